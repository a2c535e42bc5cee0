// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/results_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "taut/study/paper_figures.hpp"
#include "taut/version.hpp"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const FormErrorSummary& s) {
    return {{"max", s.max}, {"min", s.min}, {"mean", s.mean}, {"rmse", s.rmse}};
}

Json to_json(const FormErrors& errors) {
    return {{"nominal", to_json(errors.nominal)}, {"identified", to_json(errors.identified)}};
}

Json to_json(const MethodResult& method) {
    return {{"mse", method.errors.mse},
            {"mrse", method.errors.mrse},
            {"error_mean_max_abs", method.errors.mean_max_abs()},
            {"error_std_mean", method.errors.std_mean()},
            {"coverage_95", method.coverage}};
}

}  // namespace

std::string study_to_json(const Study& study) {
    const CableNet& net = study.net;
    const PaperFigures paper;
    const Json document{
        {"format", "taut-study"},
        {"version", 1},
        {"program", "taut " + std::string(version())},
        {"net",
         {{"name", net.name()},
          {"free_nodes", net.free_node_count()},
          {"supports", net.supports().size()},
          {"interior_edges", net.interior_edge_count()},
          {"adjustable_edges", net.adjustable_edges().size()},
          {"fingerprint", net.fingerprint()}}},
        {"law", study.settings.law.to_string()},
        {"seed", study.settings.seed},
        {"samples",
         {{"total", study.data.size()},
          {"training", study.model.training_count()},
          {"validation", study.validation.size()},
          {"with_slack", study.data.with_slack()},
          {"not_converged", study.data.not_converged()}}},
        {"methods", {{study.gp_as_in_paper.name, to_json(study.gp_as_in_paper)}}},
        {"form_error", to_json(study.form_errors)},
        {"form_error_mean_over_validation", to_json(study.mean_form_errors)},
        {"forms_not_converged", study.forms_not_converged},
        {"paper",
         {{"mse", paper.mse}, {"mrse", paper.mrse}, {"form_error", to_json(paper.form_errors)}}},
        {"seconds",
         {{"sampling", study.seconds.sampling},
          {"training", study.seconds.training},
          {"identification", study.seconds.identification},
          {"total", study.seconds.total}}}};
    return document.dump(2) + "\n";
}

std::string identification_to_json(const CableNet& net, const Survey& survey,
                                   const Identification& identification) {
    Json edges = Json::array();
    for (const IdentifiedEdge& e : identification.edges) {
        const auto [s, t] = net.edges()[static_cast<size_t>(e.edge)];
        edges.push_back({{"edge", e.edge},
                         {"id", net.edge_id(e.edge)},
                         {"nodes", {s, t}},
                         {"nominal", e.nominal},
                         {"length_deviation", e.length_deviation},
                         {"std", e.std},
                         {"lower", e.lower},
                         {"upper", e.upper},
                         {"status", to_string(e.status)}});
    }
    Json form = Json::array();
    for (const auto& node : identification.predicted.form.colwise()) {
        form.push_back({node.x(), node.y(), node.z()});
    }
    const Eigen::VectorXd& residuals = identification.residuals;
    const Json document{{"format", "taut-identification"},
                        {"version", 1},
                        {"program", "taut " + std::string(version())},
                        {"method", identification.method},
                        {"net_fingerprint", net.fingerprint()},
                        {"edges", edges},
                        {"form", form},
                        {"survey",
                         {{"used", survey.surveyed.size()},
                          {"missing", survey.missing.size()},
                          {"outliers", Json::array()},
                          {"rms_residual", std::sqrt(residuals.squaredNorm() /
                                                     static_cast<double>(residuals.size()))},
                          {"max_residual", residuals.maxCoeff()}}}};
    return document.dump(2) + "\n";
}

}  // namespace taut
