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

}  // namespace

std::string paper_table(const Study& study) {
    const PaperFigures paper;
    const LengthErrors& errors = study.gp_as_in_paper.errors;
    std::string text = fmt::format(
        "{} samples ({}, seed {}): {} for training, {} for validation; {} with slack edges, {} not "
        "converged\n",
        study.data.size(), study.settings.law.to_string(), study.settings.seed,
        study.model.training_count(), study.validation.size(), study.data.with_slack(),
        study.data.not_converged());
    if (study.net.free_node_count() != paper.free_nodes ||
        study.net.interior_edge_count() != paper.interior_edges) {
        text += fmt::format("The paper's net is another one: {} free nodes, {} interior edges.\n",
                            paper.free_nodes, paper.interior_edges);
    }
    text += fmt::format("\nError of the identified lengths{:>19}{:>12}\n", "paper", "here");
    text += fmt::format("  {:<36}{:>12.2g}{:>12.2g}  m2\n", "mean squared error (MSE)", paper.mse,
                        errors.mse);
    text += fmt::format("  {:<36}{:>12.2g}{:>12.2g}  %\n", "mean relative squared error (MRSE)",
                        100.0 * paper.mrse, 100.0 * errors.mrse);
    text += fmt::format("  {:<36}{:>12}{:>12.2g}  mm\n", "largest mean error of an edge", "-",
                        1e3 * errors.mean_max_abs());
    text += fmt::format("  {:<36}{:>12}{:>12.2g}  mm\n", "standard deviation, mean of the edges",
                        "-", 1e3 * errors.std_mean());
    text += fmt::format("  {:<36}{:>12}{:>12.1f}  %\n", "inside the 95 % interval", "-",
                        100.0 * study.gp_as_in_paper.coverage);

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
    text += "  here: the first validation sample, as in the paper; mean: over all of them\n";
    text += fmt::format("  identified / nominal, means: paper {:.3f}, here {:.3f}\n",
                        paper.form_errors.identified.mean / paper.form_errors.nominal.mean,
                        study.form_errors.identified.mean / study.form_errors.nominal.mean);
    if (study.forms_not_converged > 0) {
        text += fmt::format("  left out: {} identified forms that did not converge\n",
                            study.forms_not_converged);
    }
    text += fmt::format(
        "\nSeconds: sampling {:.2f}, training {:.2f}, identification {:.2f}, in all {:.2f}\n",
        study.seconds.sampling, study.seconds.training, study.seconds.identification,
        study.seconds.total);
    return text;
}

}  // namespace taut::app
