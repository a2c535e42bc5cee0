// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/results_json.hpp"

#include <functional>
#include <optional>

#include "results/document_parts.hpp"
#include "results/result_parts.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/study/paper_figures.hpp"

namespace taut {
namespace {

/// A number of the lengths; empty where no survey was identified.
template <class Number>
auto of_identified(const Number& number) {
    return [number](const MethodResult& method) {
        return method.identified() > 0 ? std::optional(std::invoke(number, method)) : std::nullopt;
    };
}

auto of_errors(auto number) {
    return of_identified(
        [number](const MethodResult& method) { return std::invoke(number, method.errors); });
}

/// With its unstressed lengths, forms and tensions: the first validation sample, the paper's k = 1.
Eigen::VectorXd true_deviation(const Study& study) {
    return study.data.length_deviations.col(study.validation.front());
}

Points true_form(const Study& study) {
    return with_free_coordinates(
        study.net,
        study.data.nominal_form + study.data.form_deviations.col(study.validation.front()));
}

Eigen::VectorXd tensions_of(const Study& study, const Eigen::VectorXd& deviation,
                            const Points& form) {
    return tensions_of(study.net, with_length_deviations(study.net, deviation), form);
}

/// All errors of each interior edge, where they are few enough.
ResultJson all_errors(const Study& study) {
    constexpr Eigen::Index most_errors = 100'000;
    if (study.estimates.mean.size() > most_errors) {
        return {};
    }
    ResultJson all = ResultJson::array();
    for (Eigen::Index i = 0; i < study.estimates.mean.rows(); ++i) {
        const Eigen::VectorXd of_edge =
            study.data.length_deviations(i, study.validation) - study.estimates.mean.row(i);
        all.push_back(numbers_json(of_edge, 4));
    }
    return all;
}

Description<Study> sample_of_study() {
    const Rule numbers = Rule::list_of(Rule::number());
    const Rule points = Rule::list_of(Rule::point());
    return Description<Study>("", "The first validation sample.")
        .newer("index", TAUT_VALUE(it.validation.front()))
        .key("true", TAUT_VALUE(numbers_json(true_deviation(it), 9)), numbers)
        .key("identified", TAUT_VALUE(numbers_json(it.estimates.mean.col(0), 9)), numbers)
        .key("std", TAUT_VALUE(numbers_json(it.estimates.std_dev.col(0), 6)), numbers)
        .key("true_form", TAUT_VALUE(points_json(true_form(it))), points)
        .key("identified_form", TAUT_VALUE(points_json(it.identified_form)), points)
        .key("true_tension",
             TAUT_VALUE(numbers_json(tensions_of(it, true_deviation(it), true_form(it)), 6)),
             numbers)
        .key("identified_tension",
             TAUT_VALUE(
                 numbers_json(tensions_of(it, it.estimates.mean.col(0), it.identified_form), 6)),
             numbers)
        .object(
            "form_error",
            Description<Study>()
                .key("nominal", TAUT_VALUE(numbers_json(it.nominal_form_error, 6)), numbers)
                .key("identified", TAUT_VALUE(numbers_json(it.identified_form_error, 6)), numbers));
}

Description<Study> errors_of_study() {
    const Rule numbers = Rule::list_of(Rule::number());
    return Description<Study>("", "True less identified lengths over the validation samples.")
        .key("mean", TAUT_VALUE(numbers_json(it.as_in_paper().errors.mean, 6)), numbers)
        .key("std", TAUT_VALUE(numbers_json(it.as_in_paper().errors.std_dev, 6)), numbers)
        .optional("all", all_errors, Rule::list_of(numbers));
}

Description<Study> samples_of_study() {
    const Rule count = Rule::count();
    return Description<Study>()
        .key("total", TAUT_VALUE(it.data.size()), count)
        .key("training", TAUT_VALUE(it.model.training_count()), count)
        .key("validation", TAUT_VALUE(it.validation.size()), count)
        .key("with_slack", TAUT_VALUE(it.data.with_slack()), count)
        .key("not_converged", TAUT_VALUE(it.data.not_converged()), count);
}

}  // namespace

Description<FormErrorSummary> describe(const FormErrorSummary* /*type*/) {
    return Description<FormErrorSummary>("form_error_summary",
                                         "Distances between two forms over the free nodes [m].")
        .key("max", &FormErrorSummary::max, size)
        .key("min", &FormErrorSummary::min, size)
        .key("mean", &FormErrorSummary::mean, size)
        .key("rmse", &FormErrorSummary::rmse, size);
}

Description<FormErrors> describe(const FormErrors* /*type*/) {
    return Description<FormErrors>("form_errors")
        .key("nominal", &FormErrors::nominal)
        .key("identified", &FormErrors::identified);
}

Description<PaperFigures> describe(const PaperFigures* /*type*/) {
    return Description<PaperFigures>()
        .key("mse", &PaperFigures::mse, size)
        .key("mrse", &PaperFigures::mrse, size)
        .key("form_error", &PaperFigures::form_errors);
}

Description<MethodResult> describe(const MethodResult* /*type*/) {
    return Description<MethodResult>(
               "method", "Numbers of the lengths are null where the method failed on all surveys.")
        .newer("surveys", &MethodResult::surveys)
        .newer("failed", &MethodResult::failed)
        .optional("first_failure", TAUT_VALUE(when(it.failed > 0, it.first_failure)))
        .key("mse", of_errors(&LengthErrors::mse), size)
        .newer("mse_of_taut_edges", of_identified(&MethodResult::mse_of_taut), size)
        .key("mrse", of_errors(&LengthErrors::mrse), size)
        .key("error_mean_max_abs", of_errors(&LengthErrors::mean_max_abs), size)
        .key("error_std_mean", of_errors(&LengthErrors::std_mean), size)
        .newer("coverage_95", of_identified(&MethodResult::coverage), part)
        .newer("form_error",
               TAUT_VALUE(when(it.forms_not_converged < it.identified(), it.form_error)))
        .newer("forms_not_converged", &MethodResult::forms_not_converged)
        .newer("training_seconds", &MethodResult::training_seconds, size)
        .newer("seconds", &MethodResult::seconds, size);
}

Description<Study> describe(const Study* /*type*/) {
    auto result = document<Study>(
        "study",
        "Result of taut reproduce. Lists over edges are in the order of the interior edges, lists "
        "over nodes in that of the free nodes; forms and tensions are of all nodes and edges.");
    const auto methods = [](const Study& study, const Context& c) {
        ResultJson all = ResultJson::object();
        for (const MethodResult& method : study.methods) {
            all[method.name] = json_of(method, c);
        }
        return all;
    };
    result.key("net", &Study::net)
        .newer("prior", TAUT_VALUE(it.settings.prior))
        .newer("seed", TAUT_VALUE(it.settings.seed))
        .object("samples", samples_of_study())
        .key("methods", methods, Rule::by_name(description_of<MethodResult>().rule()))
        .key("form_error", &Study::form_errors)
        .newer("form_error_mean_over_validation", &Study::mean_form_errors)
        .newer("forms_not_converged", TAUT_VALUE(it.as_in_paper().forms_not_converged))
        .newer("paper", TAUT_VALUE(PaperFigures()))
        .object("seconds", seconds_of<Study>());
    return add_run(result)
        .key("cable_net", TAUT_VALUE(net_json(it.net)), net_rule())
        .key("nominal_form",
             TAUT_VALUE(points_json(with_free_coordinates(it.net, it.data.nominal_form))),
             Rule::list_of(Rule::point()))
        .object("sample", sample_of_study())
        .object("errors", errors_of_study());
}

std::string study_to_json(const Study& study, const RunRecord& run) {
    return to_text(json_of(study, {.net = &study.net, .run = &run}));
}

}  // namespace taut
