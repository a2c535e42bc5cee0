// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/results_json.hpp"

#include "results/result_parts.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/study/paper_figures.hpp"
#include "taut/version.hpp"

namespace taut {
namespace {

using Json = ResultJson;

Json to_json(const FormErrorSummary& s) {
    return {{"max", s.max}, {"min", s.min}, {"mean", s.mean}, {"rmse", s.rmse}};
}

Json to_json(const FormErrors& errors) {
    return {{"nominal", to_json(errors.nominal)}, {"identified", to_json(errors.identified)}};
}

/// All numbers of the lengths are null where no survey was identified.
Json to_json(const MethodResult& method) {
    Json object{{"surveys", method.surveys}, {"failed", method.failed}};
    if (method.failed > 0) {
        object["first_failure"] = method.first_failure;
    }
    const bool any = method.identified() > 0;
    const auto number = [any](double value) { return any ? Json(value) : Json(); };
    object["mse"] = number(method.errors.mse);
    object["mse_of_taut_edges"] = number(method.mse_of_taut);
    object["mrse"] = number(method.errors.mrse);
    object["error_mean_max_abs"] = any ? Json(method.errors.mean_max_abs()) : Json();
    object["error_std_mean"] = any ? Json(method.errors.std_mean()) : Json();
    object["coverage_95"] = number(method.coverage);
    const bool has_form = method.forms_not_converged < method.identified();
    object["form_error"] = has_form ? to_json(method.form_error) : Json();
    object["forms_not_converged"] = method.forms_not_converged;
    object["training_seconds"] = method.training_seconds;
    object["seconds"] = method.seconds;
    return object;
}

Json methods_json(const Study& study) {
    Json methods = Json::object();
    for (const MethodResult& method : study.methods) {
        methods[method.name] = to_json(method);
    }
    return methods;
}

/// The first validation sample, the paper's k = 1: lengths in the order of the interior edges,
/// forms of all nodes, tensions of all edges.
Json sample_json(const Study& study) {
    const CableNet& net = study.net;
    const auto sample = study.validation.front();
    const Eigen::VectorXd truth = study.data.length_deviations.col(sample);
    const Eigen::VectorXd identified = study.estimates.mean.col(0);
    const Points true_form = with_free_coordinates(
        net, study.data.nominal_form + study.data.form_deviations.col(sample));
    return {{"index", sample},
            {"true", numbers_json(truth, 9)},
            {"identified", numbers_json(identified, 9)},
            {"std", numbers_json(study.estimates.std.col(0), 6)},
            {"true_form", points_json(true_form)},
            {"identified_form", points_json(study.identified_form)},
            {"true_tension",
             numbers_json(tensions(net, with_length_deviations(net, truth), true_form), 6)},
            {"identified_tension",
             numbers_json(
                 tensions(net, with_length_deviations(net, identified), study.identified_form), 6)},
            {"form_error",
             {{"nominal", numbers_json(study.nominal_form_error, 6)},
              {"identified", numbers_json(study.identified_form_error, 6)}}}};
}

/// Statistics of the errors of each interior edge, and all errors where they are few enough.
Json errors_json(const Study& study) {
    constexpr Eigen::Index most_errors = 100'000;
    const LengthErrors& errors = study.as_in_paper().errors;
    Json result{{"mean", numbers_json(errors.mean, 6)}, {"std", numbers_json(errors.std, 6)}};
    if (study.estimates.mean.size() <= most_errors) {
        Json all = Json::array();
        for (Eigen::Index i = 0; i < study.estimates.mean.rows(); ++i) {
            const Eigen::VectorXd of_edge =
                study.data.length_deviations(i, study.validation) - study.estimates.mean.row(i);
            all.push_back(numbers_json(of_edge, 4));
        }
        result["all"] = std::move(all);
    }
    return result;
}

}  // namespace

std::string study_to_json(const Study& study, const RunRecord& run) {
    const CableNet& net = study.net;
    const PaperFigures paper;
    Json document{
        {"format", "taut-study"},
        {"version", 2},
        {"program", "taut " + std::string(version())},
        {"net", counts_json(net)},
        {"prior", study.settings.prior.to_string()},
        {"seed", study.settings.seed},
        {"samples",
         {{"total", study.data.size()},
          {"training", study.model.training_count()},
          {"validation", study.validation.size()},
          {"with_slack", study.data.with_slack()},
          {"not_converged", study.data.not_converged()}}},
        {"methods", methods_json(study)},
        {"form_error", to_json(study.form_errors)},
        {"form_error_mean_over_validation", to_json(study.mean_form_errors)},
        {"forms_not_converged", study.as_in_paper().forms_not_converged},
        {"paper",
         {{"mse", paper.mse}, {"mrse", paper.mrse}, {"form_error", to_json(paper.form_errors)}}},
        {"seconds",
         {{"sampling", study.seconds.sampling},
          {"training", study.seconds.training},
          {"identification", study.seconds.identification},
          {"total", study.seconds.total}}}};
    add_run(document, run);
    document["cable_net"] = net_json(net);
    document["nominal_form"] = points_json(with_free_coordinates(net, study.data.nominal_form));
    document["sample"] = sample_json(study);
    document["errors"] = errors_json(study);
    return to_text(document);
}

}  // namespace taut
