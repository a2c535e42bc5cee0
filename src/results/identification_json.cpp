// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "results/result_parts.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/results_json.hpp"
#include "taut/version.hpp"

namespace taut {
namespace {

using Json = ResultJson;

/// Residuals: surveyed less predicted coordinates.
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
        if (p.swapped_with >= 0) {
            points.back()["swapped_with"] = net.node_id(p.swapped_with);
        }
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

Json findings_json(const Trust& trust) {
    Json findings = Json::array();
    for (const Trust::Finding& finding : trust.findings) {
        findings.push_back(
            {{"kind", to_string(finding.kind)},
             {"severity", to_string(finding.severity)},
             {"ids", finding.ids},
             {"value", or_null(finding.value)},
             {"std", or_null(finding.std)},
             {"confounded_with", finding.confounded_with},
             {"remedy", finding.remedy ? Json{{"parameter", finding.remedy->parameter},
                                              {"value", finding.remedy->value}}
                                       : Json()},
             {"reason", finding.reason},
             {"next", finding.next}});
    }
    return findings;
}

/// From the frame of the survey to that of the net's supports, where it was estimated.
Json offset_json(const std::optional<FrameOffset>& offset) {
    if (!offset) {
        return {};
    }
    return {{"about", to_json(offset->about)},
            {"translation", to_json(offset->translation)},
            {"translation_std", to_json(offset->translation_std)},
            {"rotation", to_json(offset->rotation)},
            {"rotation_std", to_json(offset->rotation_std)}};
}

Json scale_json(const FoundScale& scale) {
    return {{"ratio", scale.ratio}, {"std", scale.std}};
}

/// Adjustable edges and supports that are not as designed.
Json boundary_json(const CableNet& net, const std::vector<BoundaryOutlier>& outliers) {
    Json list = Json::array();
    for (const BoundaryOutlier& outlier : outliers) {
        const bool is_support = outlier.kind == BoundaryOutlier::Kind::support;
        const auto id_of = [&net](bool of_node, int index) {
            return of_node ? net.node_id(index) : net.edge_id(index);
        };
        Json entry = {{is_support ? "node" : "edge", outlier.index},
                      {"id", id_of(is_support, outlier.index)}};
        entry["deviation"] = is_support ? to_json(outlier.deviation) : Json(outlier.deviation.x());
        entry["std"] = is_support ? to_json(outlier.std) : Json(outlier.std.x());
        entry["statistic"] = outlier.statistic;
        entry["confounded_with"] = outlier.confounded_with < 0
                                       ? Json()
                                       : Json(id_of(!is_support, outlier.confounded_with));
        list.push_back(std::move(entry));
    }
    return list;
}

/// Targets with gross errors, which were left out.
Json outliers_json(const CableNet& net, const std::vector<Outlier>& outliers) {
    Json list = Json::array();
    for (const Outlier& outlier : outliers) {
        list.push_back({{"node", outlier.node},
                        {"id", net.node_id(outlier.node)},
                        {"distance", outlier.distance},
                        {"statistic", outlier.statistic}});
        if (outlier.swapped_with >= 0) {
            list.back()["swapped_with"] = net.node_id(outlier.swapped_with);
        }
    }
    return list;
}

Json frame_check_json(const FrameCheck& check) {
    return {{"scale", check.scale},
            {"scale_std", check.scale_std},
            {"translation", to_json(check.translation)},
            {"rotation", to_json(check.rotation)},
            {"motion_statistic", check.motion_statistic}};
}

/// The numbers of the checks.
Json diagnostics_json(const CableNet& net, const Identification& identification) {
    const PriorCheck& prior = identification.prior_check;
    Json length_outliers = Json::array();
    for (const LengthOutlier& outlier : identification.length_outliers) {
        length_outliers.push_back({{"edge", outlier.edge},
                                   {"id", net.edge_id(outlier.edge)},
                                   {"deviation", outlier.deviation},
                                   {"std", outlier.std},
                                   {"statistic", outlier.statistic}});
        if (outlier.other >= 0) {
            length_outliers.back()["other"] = net.edge_id(outlier.other);
            length_outliers.back()["swapped"] = outlier.is_swapped;
            length_outliers.back()["beside_target"] = outlier.is_beside_target;
        }
        if (outlier.node >= 0) {
            length_outliers.back()["node"] = net.node_id(outlier.node);
        }
    }
    return {{"noise", scale_json(identification.scales.noise)},
            {"lengths", scale_json(identification.scales.lengths)},
            {"prior",
             {{"likeliest", prior.lengths > 0 ? prior.likeliest.to_string() : ""},
              {"gain", prior.gain},
              {"lengths", prior.lengths},
              {"mean", prior.mean},
              {"mean_std", prior.mean_std},
              {"outliers", prior.outliers},
              {"found", identification.contradicted_prior.has_value()},
              {"contradicted", identification.contradicted_prior
                                   ? Json(identification.contradicted_prior->checked.to_string())
                                   : Json()}}},
            {"frame", frame_check_json(identification.frame_check)},
            {"length_outliers", length_outliers},
            {"boundary", boundary_json(net, identification.boundary_outliers)},
            {"boundary_not_released", identification.boundary_not_released}};
}

/// The smallest error of each kind that the checks would find; null: none.
Json detectable_json(const DetectableErrors& errors) {
    const auto or_null = [](double error) { return std::isfinite(error) ? Json(error) : Json(); };
    return {
        {"target", or_null(errors.target)},         {"length", or_null(errors.length)},
        {"adjustable", or_null(errors.adjustable)}, {"support", or_null(errors.support)},
        {"scale", or_null(errors.scale)},           {"temperature", or_null(errors.temperature)}};
}

/// The prior of the length deviations: as given, and as estimated.
Json prior_json(const Identification& identification) {
    const PriorEstimate& prior = identification.prior;
    Json nodes = Json::array();
    for (const PriorNode& node : prior.nodes) {
        nodes.push_back({{"prior", node.prior.to_string()}, {"weight", node.weight}});
    }
    return {{"given", identification.prior_was_given ? Json(prior.given.to_string()) : Json()},
            {"exact", prior.exact},
            {"std", prior.std},
            {"std_std", prior.std_std},
            {"uniform_probability", prior.uniform_probability},
            {"common",
             {{"mean", prior.common.mean},
              {"mean_std", prior.common.mean_std},
              {"runs", prior.common.runs},
              {"run_std", prior.common.run_std},
              {"run_probability", prior.common.run_probability},
              {"adjustable", prior.common.adjustable},
              {"adjustable_std", prior.common.adjustable_std}}},
            {"nodes", nodes}};
}

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

/// Adds the keys that follow from posterior samples.
void add_drawn(Json& document, const CableNet& net, const Identification& identification) {
    const DrawnSummary& drawn = identification.drawn;
    document["mean_tension"] = nullptr;
    document["draws"] = nullptr;
    Json adjustable = Json::array();
    Json places = Json::array();
    if (identification.draws) {
        const PosteriorDraws& draws = *identification.draws;
        document["draws"] = {{"count", draws.count()},
                             {"fingerprint", fingerprint_of(draws)},
                             {"seed", draws.seed},
                             {"how", draws.how},
                             {"reason", draws.reason.empty() ? Json() : Json(draws.reason)}};
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

/// The unit of an uncertain parameter.
std::string_view unit_of(UncertainParameter::Kind kind) {
    switch (kind) {
        case UncertainParameter::Kind::temperature:
            return "K";
        case UncertainParameter::Kind::supports:
        case UncertainParameter::Kind::adjustable:
            return "m";
        case UncertainParameter::Kind::loads_each:
            return "N";
        case UncertainParameter::Kind::stiffness:
        case UncertainParameter::Kind::stiffness_each:
        case UncertainParameter::Kind::loads:
            break;
    }
    return "1";
}

Json uncertain_json(const CableNet& net, const Identification& identification) {
    constexpr std::array axes{"x", "y", "z"};
    Json result = Json::array();
    for (const ParameterEstimate& estimate : identification.uncertain) {
        const UncertainParameter& parameter = estimate.parameter;
        Json one{{"name", parameter.name()},
                 {"group", parameter.group.empty() ? Json() : Json(parameter.group)},
                 {"given", parameter.to_string()},
                 {"mean", estimate.mean},
                 {"std", estimate.std},
                 {"prior_std", estimate.prior_std},
                 {"unit", unit_of(parameter.kind)},
                 {"observed", estimate.is_observed()}};
        if (estimate.edge >= 0) {
            one["edge"] = estimate.edge;
            one["id"] = net.edge_id(estimate.edge);
        }
        if (estimate.node >= 0) {
            one["node"] = estimate.node;
            one["id"] = net.node_id(estimate.node);
            one["axis"] = axes[estimate.axis];
        }
        result.push_back(std::move(one));
    }
    return result;
}

/// The assumed uncertainties, in the unit of their kind.
Json assumptions_json(const Identification& identification) {
    Json result = Json::array();
    for (const Assumption& one : identification.assumptions) {
        result.push_back(
            {{"name", one.parameter.name()},
             {"value", one.parameter.to_string()},
             {"group", one.parameter.group.empty() ? Json() : Json(one.parameter.group)},
             {"std", one.parameter.std},
             {"unit", unit_of(one.parameter.kind)},
             {"source", one.is_default ? "default" : "given"},
             {"testable", one.is_testable}});
    }
    return result;
}

/// Force measurements, and those that contradict the rest.
Json forces_json(const CableNet& net, const Identification& identification) {
    Json outliers = Json::array();
    for (const ForceOutlier& outlier : identification.force_outliers) {
        outliers.push_back({{"edge", outlier.edge},
                            {"id", net.edge_id(outlier.edge)},
                            {"measured", outlier.measured},
                            {"expected", outlier.expected},
                            {"statistic", outlier.statistic}});
    }
    return {{"measurements", identification.force_measurements},
            {"outliers", outliers},
            {"bias", identification.force_bias ? Json{{"part", identification.force_bias->part},
                                                      {"std", identification.force_bias->std}}
                                               : Json()},
            {"contradicted_taut", identification.contradicted_taut},
            {"contradicted_slack", identification.contradicted_slack}};
}

/// Null where it was not asked for.
Json length_covariance_json(const CableNet& net, const std::optional<LengthCovariance>& lengths) {
    if (!lengths) {
        return {};
    }
    Json ids = Json::array();
    for (const int edge : lengths->edges) {
        ids.push_back(net.edge_id(edge));
    }
    Json rows = Json::array();
    for (const auto& row : lengths->covariance.rowwise()) {
        rows.push_back(std::vector<double>(row.begin(), row.end()));
    }
    return {{"edges", lengths->edges}, {"ids", ids}, {"covariance", rows}};
}

Json turned_json(const CableNet& net, const std::vector<EdgeTurned>& turned) {
    Json list = Json::array();
    for (const EdgeTurned& one : turned) {
        list.push_back({{"edge", one.edge},
                        {"id", net.edge_id(one.edge)},
                        {"stroke", one.stroke},
                        {"std", one.std}});
    }
    return list;
}

/// The results of each of several surveys.
Json epochs_json(const CableNet& net, const std::vector<EpochResult>& epochs) {
    Json list = Json::array();
    for (const EpochResult& epoch : epochs) {
        Json changes = Json::array();
        for (const LengthChange& change : epoch.changes) {
            changes.push_back({{"edge", change.edge},
                               {"id", net.edge_id(change.edge)},
                               {"change", change.change},
                               {"std", change.std},
                               {"statistic", change.statistic}});
        }
        list.push_back({{"used", epoch.surveyed},
                        {"turned", turned_json(net, epoch.turned)},
                        {"outliers", outliers_json(net, epoch.outliers)},
                        {"boundary", boundary_json(net, epoch.boundary_outliers)},
                        {"frame_offset", offset_json(epoch.frame_offset)},
                        {"noise_ratio", epoch.noise_ratio},
                        {"noise_scale", epoch.noise_scale},
                        {"change_ratio", epoch.change_ratio},
                        {"change_limit", epoch.change_limit},
                        {"excess_actuator_std", epoch.excess_actuator_std},
                        {"changes", changes},
                        {"stroke_factor", epoch.stroke_factor},
                        {"stroke_factor_std", epoch.stroke_factor_std},
                        {"trust", trust_json(epoch.trust)},
                        {"findings", findings_json(epoch.trust)}});
    }
    return list;
}

}  // namespace

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
    double noise = 0.0;
    if (survey.noise_std.cols() > 0) {
        const Points stds = survey.noise_std(Eigen::all, survey.surveyed);
        noise = std::sqrt(stds.squaredNorm() / static_cast<double>(stds.size()));
    }
    const Eigen::VectorXd residuals = residuals_in_use(identification, survey);
    const double in_use = std::max(1.0, static_cast<double>(residuals.size()));
    Json document{{"format", "taut-identification"},
                  {"version", 2},
                  {"program", "taut " + std::string(version())},
                  {"method", identification.method},
                  {"method_reason", identification.method_reason},
                  {"status", to_string(identification.status)},
                  {"trust", trust_json(identification.trust)},
                  {"findings", findings_json(identification.trust)},
                  {"length_prior", identification.length_prior.to_string()},
                  {"prior", prior_json(identification)},
                  {"assumptions", assumptions_json(identification)},
                  {"detectable", detectable_json(identification.detectable)},
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
                    {"outliers", outliers_json(net, identification.outliers)},
                    {"outlier_threshold", identification.outlier_threshold},
                    {"rms_residual", std::sqrt(residuals.squaredNorm() / in_use)},
                    {"max_residual", residuals.lpNorm<Eigen::Infinity>()}}}};
    add_run(document, run);
    document["net"] = counts_json(net);
    document["frame_offset"] = offset_json(identification.frame_offset);
    document["turned"] = turned_json(net, identification.turned);
    document["epochs"] = epochs_json(net, identification.epochs);
    document["diagnostics"] = diagnostics_json(net, identification);
    document["survey"]["residuals"] = residuals_json(survey, identification.predicted.form);
    document["survey"]["missing_nodes"] = survey.missing;
    document["survey"]["unmatched"] = unmatched_json(net, survey);
    document["survey"]["control"] = survey.frame ? control_json(*survey.frame) : Json::array();
    document["survey"]["warnings"] = survey.warnings;
    document["cable_net"] = net_json(net);
    if (identification.tensions.size() > 0) {
        document["tension"] = numbers_json(identification.tensions, 6);
    }
    document["uncertain"] = uncertain_json(net, identification);
    document["forces"] = forces_json(net, identification);
    document["length_covariance"] = length_covariance_json(net, identification.length_covariance);
    add_drawn(document, net, identification);
    return to_text(document);
}

}  // namespace taut
