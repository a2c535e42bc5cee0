// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/observations.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

constexpr double exact_part_of_length = 1e-7;

[[noreturn]] void refuse(const CableNet& net, int node, const std::string& what) {
    throw std::invalid_argument(fmt::format("the survey's node '{}' {}", net.node_id(node), what));
}

void check_size(const char* name, Eigen::Index found, int expected) {
    if (found != expected) {
        throw std::invalid_argument(
            fmt::format("the survey's {} has {} columns, expected {}", name, found, expected));
    }
}

}  // namespace

void check_survey(const CableNet& net, const Survey& survey) {
    check_size("form", survey.form.cols(), net.node_count());
    if (survey.noise_std.cols() != 0) {
        check_size("noise_std", survey.noise_std.cols(), net.node_count());
    }
    if (survey.surveyed.empty()) {
        throw std::invalid_argument("the survey holds no free node, expected at least one");
    }
    int last = -1;
    for (const int node : survey.surveyed) {
        if (node <= last || node >= net.node_count() || net.free_index(node) < 0) {
            throw std::invalid_argument(fmt::format(
                "the survey names node {} after {}, expected free nodes in ascending order", node,
                last));
        }
        last = node;
        if (!survey.form.col(node).allFinite()) {
            refuse(net, node, "has a coordinate that is not finite");
        }
        if (survey.noise_std.cols() != 0 && !(survey.noise_std.col(node).allFinite() &&
                                              survey.noise_std.col(node).minCoeff() >= 0.0)) {
            refuse(net, node,
                   fmt::format("has a standard deviation of {}, expected 0 or more",
                               survey.noise_std.col(node).minCoeff()));
        }
    }
}

Points reckoned_noise(const CableNet& net, const Survey& survey) {
    const double exact = exact_part_of_length * edge_lengths(net, net.nodes()).mean();
    Points noise = Points::Constant(3, net.node_count(), exact);
    if (survey.noise_std.cols() != 0) {
        noise = survey.noise_std.cwiseMax(exact);
    }
    return noise;
}

Knowledge knowledge_of(const CableNet& net, const Survey& survey, const Points& noise,
                       const std::vector<bool>& left_out, double length_std) {
    Knowledge knowledge{
        .form = survey.form,
        .weights = Points::Zero(3, net.node_count()),
        .mean = Eigen::VectorXd::Zero(net.interior_edge_count()),
        .variance = Eigen::VectorXd::Constant(net.interior_edge_count(), length_std * length_std)};
    for (const int node : survey.surveyed) {
        if (!left_out[node]) {
            knowledge.weights.col(node) = noise.col(node).cwiseAbs2().cwiseInverse();
        }
    }
    return knowledge;
}

Guess surveyed_guess(const CableNet& net, const Survey& survey, const std::vector<bool>& left_out) {
    Guess guess{.form = net.nodes(),
                .deviations = Eigen::VectorXd::Zero(net.interior_edge_count())};
    for (const int node : survey.surveyed) {
        if (!left_out[node]) {
            guess.form.col(node) = survey.form.col(node);
        }
    }
    return guess;
}

}  // namespace taut
