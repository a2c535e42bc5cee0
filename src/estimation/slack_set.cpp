// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/slack_set.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Deviations of more standard deviations than this are not expected.
constexpr double reach = 3.0;

/// Least length of each edge while it is taut (m) [m].
Eigen::VectorXd shortest_taut(const CableNet& net, const std::vector<LengthPrior>& priors) {
    Eigen::VectorXd result = net.unstressed_lengths();
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        result(net.interior_edges()[i]) -= reach * priors[i].std_dev();
    }
    return result;
}

/// Standard deviation of the measured length of an edge; infinite where an end was not measured
/// [m].
double measured_std(const CableNet& net, const Observations& observations, int edge) {
    const auto [s, t] = net.edges()[edge];
    const Eigen::Vector3d u = (observations.form.col(s) - observations.form.col(t)).normalized();
    double variance = 0.0;
    for (const int node : {s, t}) {
        Eigen::Matrix3d weight = observations.weight(node);
        weight.diagonal() += observations.support_weights.col(node);
        if (net.free_index(node) < 0 && weight.isZero(0.0)) {
            continue;  // known
        }
        if (!(weight.diagonal().minCoeff() > 0.0)) {
            return std::numeric_limits<double>::infinity();
        }
        variance += u.dot(weight.llt().solve(u));
    }
    return std::sqrt(variance);
}

}  // namespace

std::vector<bool> slack_by_lengths(const CableNet& net, const Eigen::VectorXd& lengths,
                                   const std::vector<LengthPrior>& priors) {
    const Eigen::VectorXd shortest = shortest_taut(net, priors);
    std::vector<bool> slack(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        slack[e] = net.can_be_slack(e) && lengths(e) < shortest(e);  // (slack-form)
    }
    return slack;
}

std::vector<bool> slack_by_survey(const CableNet& net, const Observations& observations,
                                  const std::vector<LengthPrior>& priors,
                                  const Eigen::VectorXd& length_stds) {
    const Eigen::VectorXd measured = edge_lengths(net, observations.form);
    const Eigen::VectorXd shortest = shortest_taut(net, priors);
    std::vector<bool> slack(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const double common = length_stds.size() > 0 ? length_stds(e) : 0.0;
        const double std_dev = std::hypot(measured_std(net, observations, e), common);
        slack[e] = net.can_be_slack(e) && measured(e) + reach * std_dev < shortest(e);
    }
    return slack;
}

std::vector<bool> where_measured(const CableNet& net, const Observations& observations,
                                 std::vector<bool> slack) {
    for (int e = 0; e < net.edge_count(); ++e) {
        slack[e] = slack[e] && std::isfinite(measured_std(net, observations, e));
    }
    return slack;
}

}  // namespace taut
