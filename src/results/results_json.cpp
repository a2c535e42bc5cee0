// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/results_json.hpp"

#include <algorithm>
#include <cmath>

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

/// What the survey says against the predicted form: surveyed less predicted coordinates.
Json residuals_json(const Survey& survey, const Points& predicted) {
    Json residuals = Json::array();
    for (const int node : survey.surveyed) {
        const Eigen::Vector3d d = survey.form.col(node) - predicted.col(node);
        Json residual{{"node", node}, {"dx", d.x()}, {"dy", d.y()}, {"dz", d.z()}};
        if (survey.noise_std.cols() > 0 && survey.noise_std.col(node).minCoeff() > 0.0) {
            const Eigen::Vector3d s = d.cwiseQuotient(survey.noise_std.col(node));
            residual["standardised"] = {s.x(), s.y(), s.z()};
        }
        residuals.push_back(residual);
    }
    return residuals;
}

Json unmatched_json(const CableNet& net, const Survey& survey) {
    Json points = Json::array();
    for (const UnmatchedPoint& p : survey.unmatched) {
        points.push_back(
            {{"id", p.point.id.empty() ? "line " + std::to_string(p.point.line) : p.point.id},
             {"line", p.point.line},
             {"reason", to_string(p.reason)},
             {"nearest", net.node_id(p.nearest)},
             {"distance", p.distance}});
    }
    return points;
}

Json to_json(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

/// Residuals of the control points that the survey's frame was fitted to.
Json control_json(const Registration& frame) {
    Json points = Json::array();
    for (const auto& [id, residual] : frame.residuals) {
        points.push_back(
            {{"id", id}, {"dx", residual.x()}, {"dy", residual.y()}, {"dz", residual.z()}});
    }
    return points;
}

Json frame_json(const Registration& frame) {
    const RigidMotion& motion = frame.motion;
    Json rotation = Json::array();
    for (const Eigen::Vector3d row : motion.rotation.rowwise()) {
        rotation.push_back(to_json(row));
    }
    return {
        {"rotation", rotation},
        {"from", to_json(motion.from)},
        {"to", to_json(motion.to)},
        {"fit", {{"rms", root_mean_square(frame.residuals)}, {"count", frame.residuals.size()}}},
        {"control", control_json(frame)}};
}

/// Of all edges, in the predicted form with the identified lengths.
Json tension_json(const CableNet& net, const Identification& identification) {
    Eigen::VectorXd lengths = net.unstressed_lengths();
    for (const IdentifiedEdge& e : identification.edges) {
        lengths(e.edge) += e.length_deviation;
    }
    return numbers_json(tensions(net, lengths, identification.predicted.form), 6);
}

/// What the draws tell of an edge; null without them.
Json drawn_tension_json(const DrawnSummary& drawn, int edge) {
    if (drawn.tensions.empty()) {
        return {{"tension", nullptr},
                {"tension_std", nullptr},
                {"tension_lower", nullptr},
                {"tension_upper", nullptr},
                {"slack_probability", nullptr}};
    }
    const DrawnTension& of_edge = drawn.tensions[edge];
    return {{"tension", of_edge.tension.mean},
            {"tension_std", of_edge.tension.std},
            {"tension_lower", of_edge.tension.lower},
            {"tension_upper", of_edge.tension.upper},
            {"slack_probability", of_edge.slack_probability}};
}

/// Keys of a result that are told by draws.
void add_drawn(Json& document, const CableNet& net, const Identification& identification) {
    const DrawnSummary& drawn = identification.drawn;
    document["mean_tension"] = nullptr;
    document["draws"] = nullptr;
    Json adjustable = Json::array();
    Json places = Json::array();
    if (identification.draws) {
        const PosteriorDraws& draws = *identification.draws;
        document["draws"] = {{"count", draws.count()},
                             {"seed", draws.seed},
                             {"how", draws.how},
                             {"doubt", draws.doubt.empty() ? Json() : Json(draws.doubt)}};
    }
    if (!drawn.tensions.empty()) {
        const DrawnEstimate& mean = drawn.mean_tension;
        document["mean_tension"] = {
            {"mean", mean.mean}, {"std", mean.std}, {"lower", mean.lower}, {"upper", mean.upper}};
        for (const int edge : net.adjustable_edges()) {
            const auto [s, t] = net.edges()[edge];
            adjustable.push_back({{"edge", edge}, {"id", net.edge_id(edge)}, {"nodes", {s, t}}});
            adjustable.back().update(drawn_tension_json(drawn, edge));
        }
        for (const DrawnPlace& place : drawn.missing) {
            places.push_back({{"node", place.node},
                              {"mean", to_json(place.mean)},
                              {"std", to_json(place.std)},
                              {"lower", to_json(place.lower)},
                              {"upper", to_json(place.upper)}});
        }
    }
    document["adjustable_edges"] = std::move(adjustable);
    document["missing_places"] = std::move(places);
}

}  // namespace

std::string study_to_json(const Study& study, const RunRecord& run) {
    const CableNet& net = study.net;
    const PaperFigures paper;
    Json document{
        {"format", "taut-study"},
        {"version", 1},
        {"program", "taut " + std::string(version())},
        {"net", counts_json(net)},
        {"law", study.settings.law.to_string()},
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

std::string identification_to_json(const CableNet& net, const Survey& survey,
                                   const Identification& identification, const RunRecord& run) {
    Json edges = Json::array();
    for (const IdentifiedEdge& e : identification.edges) {
        const auto [s, t] = net.edges()[e.edge];
        edges.push_back({{"edge", e.edge},
                         {"id", net.edge_id(e.edge)},
                         {"nodes", {s, t}},
                         {"nominal", e.nominal},
                         {"length_deviation", e.length_deviation},
                         {"std", e.std},
                         {"lower", e.lower},
                         {"upper", e.upper},
                         {"status", to_string(e.status)}});
        edges.back().update(drawn_tension_json(identification.drawn, e.edge));
    }
    Json form = Json::array();
    for (const auto& node : identification.predicted.form.colwise()) {
        form.push_back({node.x(), node.y(), node.z()});
    }
    Json outliers = Json::array();
    for (const Outlier& outlier : identification.outliers) {
        outliers.push_back({{"node", outlier.node},
                            {"id", net.node_id(outlier.node)},
                            {"distance", outlier.distance},
                            {"statistic", outlier.statistic}});
    }
    double noise = 0.0;
    if (survey.noise_std.cols() > 0) {
        const Points stds = survey.noise_std(Eigen::all, survey.surveyed);
        noise = std::sqrt(stds.squaredNorm() / static_cast<double>(stds.size()));
    }
    const Eigen::VectorXd residuals = residuals_in_use(identification, survey);
    const double in_use = std::max(1.0, static_cast<double>(residuals.size()));
    Json document{{"format", "taut-identification"},
                  {"version", 1},
                  {"program", "taut " + std::string(version())},
                  {"method", identification.method},
                  {"method_reason", identification.method_reason},
                  {"status", to_string(identification.status)},
                  {"law", identification.law.to_string()},
                  {"noise", noise},
                  {"net_fingerprint", net.fingerprint()},
                  {"edges", edges},
                  {"form", form},
                  {"frame", survey.frame ? frame_json(*survey.frame) : Json()},
                  {"survey",
                   {{"used", survey.surveyed.size()},
                    {"missing", survey.missing.size()},
                    {"noise", noise},
                    {"noise_ratio", identification.noise_ratio},
                    {"outliers", outliers},
                    {"outlier_threshold", identification.outlier_threshold},
                    {"rms_residual", std::sqrt(residuals.squaredNorm() / in_use)},
                    {"max_residual", residuals.lpNorm<Eigen::Infinity>()}}}};
    add_run(document, run);
    document["net"] = counts_json(net);
    document["survey"]["residuals"] = residuals_json(survey, identification.predicted.form);
    document["survey"]["missing_nodes"] = survey.missing;
    document["survey"]["unmatched"] = unmatched_json(net, survey);
    document["survey"]["control"] = survey.frame ? control_json(*survey.frame) : Json::array();
    document["survey"]["warnings"] = survey.warnings;
    document["cable_net"] = net_json(net);
    document["tension"] = tension_json(net, identification);
    add_drawn(document, net, identification);
    return to_text(document);
}

}  // namespace taut
