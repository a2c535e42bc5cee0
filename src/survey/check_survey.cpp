// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <cmath>

#include "net/check_index.hpp"
#include "taut/survey/covariance.hpp"
#include "taut/survey/survey.hpp"

namespace taut {
namespace {

void check_size(const char* name, Eigen::Index found, int expected) {
    if (found != expected) {
        throw SurveyError(
            0, fmt::format("the survey's {} has {} columns, expected {}", name, found, expected));
    }
}

void check_target(const CableNet& net, const Survey& survey, int node) {
    const auto refuse = [&](const std::string& what) {
        throw SurveyError(0, fmt::format("the survey's node '{}' {}", net.node_id(node), what));
    };
    if (!survey.form.col(node).allFinite()) {
        refuse("has a coordinate that is not finite");
    }
    if (survey.noise_std.cols() != 0 &&
        !(survey.noise_std.col(node).allFinite() && survey.noise_std.col(node).minCoeff() >= 0.0)) {
        refuse(fmt::format("has a standard deviation of {}, expected 0 or more",
                           survey.noise_std.col(node).minCoeff()));
    }
    if (const Eigen::Vector3d r = survey.correlations_of(node); !are_possible_correlations(r)) {
        refuse(
            fmt::format("has noise with the correlations {}, {} and {}, expected a positive "
                        "definite matrix",
                        r.x(), r.y(), r.z()));
    }
}

}  // namespace

Eigen::Vector3d Survey::correlations_of(int node) const {
    if (noise_correlations.cols() == 0) {
        return Eigen::Vector3d::Zero();
    }
    check_index("node", node, noise_correlations.cols());
    return noise_correlations.col(node);
}

void Survey::set_correlations(int node, const Eigen::Vector3d& correlations) {
    if (noise_correlations.cols() == 0) {
        if (correlations.isZero(0.0)) {
            return;
        }
        noise_correlations.setZero(3, form.cols());
    }
    check_index("node", node, noise_correlations.cols());
    noise_correlations.col(node) = correlations;
}

double Survey::largest_noise_std() const {
    return noise_std.cols() == 0 || surveyed.empty() ? 0.0
                                                     : noise_std(Eigen::all, surveyed).maxCoeff();
}

double Survey::rms_noise_std() const {
    return noise_std.cols() == 0 || surveyed.empty()
               ? 0.0
               : std::sqrt(noise_std(Eigen::all, surveyed).cwiseAbs2().mean());
}

void check_survey(const CableNet& net, const Survey& survey) {
    check_size("form", survey.form.cols(), net.node_count());
    if (survey.noise_std.cols() != 0) {
        check_size("noise_std", survey.noise_std.cols(), net.node_count());
    }
    if (survey.noise_correlations.cols() != 0) {
        check_size("noise_correlations", survey.noise_correlations.cols(), net.node_count());
    }
    if (survey.surveyed.empty()) {
        throw SurveyError(0, "the survey holds no free node, expected at least one");
    }
    std::vector<bool> is_named(net.node_count(), false);
    for (const std::vector<int>* nodes : {&survey.surveyed, &survey.missing}) {
        int last = -1;
        for (const int node : *nodes) {
            if (node <= last || node >= net.node_count() || net.free_index(node) < 0) {
                throw SurveyError(
                    0, fmt::format("the survey names node {} after {}, expected free nodes in "
                                   "ascending order",
                                   node, last));
            }
            if (is_named[node]) {
                throw SurveyError(0, fmt::format("the survey's node '{}' is surveyed and missing, "
                                                 "expected one of both",
                                                 net.node_id(node)));
            }
            is_named[node] = true;
            last = node;
        }
    }
    const auto named = survey.surveyed.size() + survey.missing.size();
    if (static_cast<int>(named) != net.free_node_count()) {
        throw SurveyError(
            0, fmt::format("the survey names {} surveyed and {} missing nodes, expected the {} "
                           "free nodes of the net",
                           survey.surveyed.size(), survey.missing.size(), net.free_node_count()));
    }
    for (const int node : survey.surveyed) {
        check_target(net, survey, node);
    }
}

void require_whole(const CableNet& net, const Survey& survey, std::string_view expected) {
    if (!survey.is_whole()) {
        throw SurveyError(
            0, fmt::format("holds {} of {} free nodes, expected {}: node '{}' is the first missing",
                           survey.surveyed.size(), net.free_node_count(), expected,
                           net.node_id(survey.missing.front())));
    }
}

}  // namespace taut
