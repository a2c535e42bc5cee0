// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <cmath>

#include "net/check_index.hpp"
#include "survey/covariance.hpp"
#include "taut/survey/survey.hpp"

namespace taut {
namespace {

void check_size(const char* name, Eigen::Index found, int expected) {
    if (found != expected) {
        throw SurveyError(
            0, fmt::format("the survey's {} has {} columns, expected {}", name, found, expected));
    }
}

/// Where something was measured, and how well.
struct MeasuredPlace {
    Eigen::Vector3d place;
    Eigen::Vector3d noise_std;
    Eigen::Vector3d correlations;
};

void check_place(const CableNet& net, int node, const MeasuredPlace& measured) {
    constexpr double furthest = 1e9;  // [m]
    const auto refuse = [&](const std::string& what) {
        throw SurveyError(0, fmt::format("the survey's node '{}' {}", net.node_id(node), what));
    };
    if (!measured.place.allFinite()) {
        refuse("has a coordinate that is not finite");
    }
    if (const double largest = measured.place.cwiseAbs().maxCoeff(); largest > furthest) {
        refuse(fmt::format("has a coordinate of {:g} m, expected at most {:g}", largest, furthest));
    }
    const Eigen::Vector3d& std_dev = measured.noise_std;
    if (!(std_dev.allFinite() && std_dev.minCoeff() >= 0.0)) {
        refuse(fmt::format("has standard deviations of {}, {} and {}, expected 0 or more",
                           std_dev.x(), std_dev.y(), std_dev.z()));
    }
    if (const Eigen::Vector3d& r = measured.correlations; !are_possible_correlations(r)) {
        refuse(
            fmt::format("has noise with the correlations {}, {} and {}, expected a positive "
                        "definite matrix",
                        r.x(), r.y(), r.z()));
    }
}

void check_supports(const CableNet& net, const std::vector<SurveyedSupport>& supports) {
    int last = -1;
    for (const SurveyedSupport& support : supports) {
        const int node = support.node;
        if (node <= last || node >= net.node_count() || net.free_index(node) >= 0) {
            throw SurveyError(0, fmt::format("the survey names node {} among the supports, after "
                                             "{}, expected supports in ascending order",
                                             node, last));
        }
        check_place(net, node,
                    {.place = support.position,
                     .noise_std = support.noise_std,
                     .correlations = support.noise_correlations});
        last = node;
    }
}

void check_std(const char* name, double std_dev) {
    if (!(std_dev >= 0.0 && std::isfinite(std_dev))) {
        throw SurveyError(
            0, fmt::format("the survey's {} is {}, expected a standard deviation of 0 or more",
                           name, std_dev));
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
                    0, fmt::format("the survey names node {} after {}, expected free nodes of the "
                                   "{} nodes of the net in ascending order",
                                   node, last, net.node_count()));
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
        check_place(net, node,
                    {.place = survey.form.col(node),
                     .noise_std = survey.noise_std.cols() == 0
                                      ? Eigen::Vector3d::Zero()
                                      : Eigen::Vector3d(survey.noise_std.col(node)),
                     .correlations = survey.correlations_of(node)});
    }
    check_supports(net, survey.supports);
    check_std("scale_std", survey.scale_std);
    check_std("rounding_std", survey.rounding_std);
}

void require_whole(const CableNet& net, const Survey& survey, std::string_view expected) {
    if (survey.is_whole()) {
        return;
    }
    const int first = survey.missing.front();
    std::string message =
        fmt::format("holds {} of {} free nodes, expected {}: node '{}' is the first missing",
                    survey.surveyed.size(), net.free_node_count(), expected, net.node_id(first));
    for (const UnmatchedPoint& point : survey.unmatched) {
        if (point.nearest == first && point.reason == UnmatchedReason::far_from_its_node) {
            message += fmt::format(", as its point lies {:.4g} m from it", point.distance);
        }
    }
    throw SurveyError(0, message);
}

}  // namespace taut
