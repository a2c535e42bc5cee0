// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "paper_table.hpp"

#include <fmt/core.h>

#include "taut/study/paper_figures.hpp"

namespace taut::app {
namespace {

std::string form_error_line(std::string_view name, const FormErrors& paper, const FormErrors& first,
                            const FormErrors& mean, double FormErrorSummary::* number) {
    const auto mm = [number](const FormErrorSummary& summary) { return 1e3 * (summary.*number); };
    return fmt::format("  {:<8}{:>12.3g}{:>12.3g}{:>12.3g}{:>14.3g}{:>12.3g}{:>12.3g}\n", name,
                       mm(paper.nominal), mm(first.nominal), mm(mean.nominal), mm(paper.identified),
                       mm(first.identified), mm(mean.identified));
}

constexpr const char* method_format = "  {:<15}{:>10}{:>9}{:>15}{:>13}{:>12}{:>14}{:>11}\n";

std::string method_line(const MethodResult& method) {
    if (method.identified() == 0) {
        return fmt::format("  {:<15}failed on all {} samples: {}\n", method.name, method.surveys,
                           method.first_failure);
    }
    const LengthErrors& errors = method.errors;
    std::string text = fmt::format(method_format, method.name, fmt::format("{:.2g}", errors.mse),
                                   fmt::format("{:.2g}", 100.0 * errors.mrse),
                                   fmt::format("{:.2g}", 1e3 * errors.mean_max_abs()),
                                   fmt::format("{:.2g}", 1e3 * errors.std_mean()),
                                   fmt::format("{:.1f}", 100.0 * method.coverage),
                                   method.forms_not_converged < method.identified()
                                       ? fmt::format("{:.3g}", 1e3 * method.form_error.mean)
                                       : "-",
                                   fmt::format("{:.0f}", 1e3 * method.seconds));
    if (method.failed > 0) {
        text += fmt::format("  {:<15}failed on {} of {} samples, not counted above: {}\n", "",
                            method.failed, method.surveys, method.first_failure);
    }
    return text;
}

/// One line for the paper and one for each method.
std::string lengths_table(const Study& study, const PaperFigures& paper) {
    std::string text =
        "\nIdentified lengths, of exact forms\n" +
        fmt::format(method_format, "", "MSE", "MRSE", "largest mean", "std, mean of", "inside the",
                    "form error,", "time each") +
        fmt::format(method_format, "", "[m2]", "[%]", "error [mm]", "edges [mm]", "95 % [%]",
                    "mean [mm]", "[ms]") +
        fmt::format(method_format, "paper", fmt::format("{:.2g}", paper.mse),
                    fmt::format("{:.2g}", 100.0 * paper.mrse), "-", "-", "-",
                    fmt::format("{:.3g}", 1e3 * paper.form_errors.identified.mean), "-");
    for (const MethodResult& method : study.methods) {
        text += method_line(method);
    }
    return text;
}

}  // namespace

std::string paper_table(const Study& study) {
    const PaperFigures paper;
    std::string text = fmt::format(
        "{} samples ({}, seed {}): {} for training, {} for validation; {} with slack edges, {} not "
        "converged\n",
        study.data.size(), to_string(study.settings.prior), study.settings.seed,
        study.model.training_count(), study.validation.size(), study.data.with_slack(),
        study.data.not_converged());
    if (study.net.free_node_count() != paper.free_nodes ||
        study.net.interior_edge_count() != paper.interior_edges) {
        text +=
            fmt::format("The paper uses another net, with {} free nodes and {} interior edges.\n",
                        paper.free_nodes, paper.interior_edges);
    }
    text += lengths_table(study, paper);
    text += fmt::format("\nForm error [mm]{:>18}{:>29}\n", "nominal", "identified");
    text += fmt::format("  {:<8}{:>12}{:>12}{:>12}{:>14}{:>12}{:>12}\n", "", "paper", "here",
                        "here, mean", "paper", "here", "here, mean");
    const auto line = [&](std::string_view name, double FormErrorSummary::* number) {
        text += form_error_line(name, paper.form_errors, study.form_errors, study.mean_form_errors,
                                number);
    };
    line("max", &FormErrorSummary::max);
    line("min", &FormErrorSummary::min);
    line("mean", &FormErrorSummary::mean);
    line("RMSE", &FormErrorSummary::rmse);
    text +=
        "  here: gp_as_in_paper, the first validation sample, as in the paper; mean: over all "
        "samples\n";
    text += fmt::format("  identified / nominal, means: paper {:.3f}, here {:.3f}\n",
                        paper.form_errors.identified.mean / paper.form_errors.nominal.mean,
                        study.form_errors.identified.mean / study.form_errors.nominal.mean);
    if (const int left_out = study.as_in_paper().forms_not_converged; left_out > 0) {
        text += fmt::format("  left out: {} identified forms that did not converge\n", left_out);
    }
    text += fmt::format(
        "\nSeconds: sampling {:.2f}, training {:.2f}, identification {:.2f}, in all {:.2f}\n",
        study.seconds.sampling, study.seconds.training, study.seconds.identification,
        study.seconds.total);
    return text;
}

}  // namespace taut::app
