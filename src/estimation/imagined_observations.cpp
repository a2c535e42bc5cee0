// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/imagined_observations.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "numerics/dense.hpp"

namespace taut {

Observations satisfied(const StaticsModel& model, const Observations& observations,
                       const Iterate& iterate) {
    Observations result = observations;
    result.form = iterate.form;
    result.support_mean = model.support_deviations(iterate);
    result.mean = iterate.deviations;
    result.load_mean = iterate.loads;
    result.common_mean = iterate.common;
    result.tension = observations.measured(model.tensions(iterate), iterate.common);
    if (observations.evidence) {
        result.evidence_pull = observations.evidence->information *
                               iterate.lengths_and_common(observations.evidence_pull.size());
    }
    return result;
}

Eigen::VectorXd standard_normals(Eigen::Index count, RandomNumbers& random) {
    Eigen::VectorXd result(count);
    for (double& one : result) {
        one = random.normal();
    }
    return result;
}

Observations perturbed(const CableNet& net, const Observations& observations,
                       const Eigen::VectorXd& blur, RandomNumbers& random) {
    Observations result = observations;
    const auto perturb_places = [&](const std::vector<int>& nodes) {
        for (const int node : nodes) {
            if (!(observations.weights.col(node).minCoeff() > 0.0)) {
                continue;
            }
            Eigen::Vector3d error;
            for (double& of_one : error) {
                of_one = random.normal();
            }
            // With the covariance S^-1 = L'^-1 L^-1.
            result.form.col(node) += observations.weight(node).llt().matrixU().solve(error);
        }
    };
    perturb_places(net.free_nodes());
    for (int i = 0; i < result.mean.size(); ++i) {
        result.mean(i) += random.normal() * std::sqrt(observations.variance(i) + blur(i));
    }
    perturb_places(net.supports());
    for (Eigen::Index k = 0; k < result.support_mean.size(); ++k) {
        if (const double weight = observations.support_weights(k); weight > 0.0) {
            result.support_mean(k) += random.normal() / std::sqrt(weight);
        }
    }
    for (int node = 0; node < net.node_count(); ++node) {
        if (observations.load_variance.col(node).maxCoeff() > 0.0) {
            Eigen::Vector3d error;
            for (double& of_one : error) {
                of_one = random.normal();
            }
            const Eigen::LLT<Eigen::Matrix3d> root(observations.load_covariance(node));
            result.load_mean.col(node) += root.matrixL() * error;
        }
    }
    for (double& mean : result.common_mean) {
        mean += random.normal();
    }
    for (Eigen::Index e = 0; e < result.tension.size(); ++e) {
        if (const double weight = observations.tension_weights(e); weight > 0.0) {
            result.tension(e) += random.normal() / std::sqrt(weight);
        }
    }
    if (observations.evidence) {
        const Eigen::VectorXd error = standard_normals(observations.evidence->root.cols(), random);
        result.evidence_pull += observations.evidence->root * error;
    }
    return result;
}

Observations with_drawn_mean(const Observations& observations, RandomNumbers& random) {
    Observations result = observations;
    if (result.mean_root.size() > 0) {
        const Eigen::VectorXd error = standard_normals(result.shown_root.cols(), random);
        result.mean += result.mean_root * (result.shown_mean + result.shown_root * error);
        result.mean_root.resize(0, 0);
    }
    return result;
}

Observations with_mean_given(const Observations& observations, const Eigen::VectorXd& variances,
                             const Eigen::VectorXd& deviations, RandomNumbers& random) {
    Observations result = observations;
    const Eigen::MatrixXd root = std::exchange(result.mean_root, {});
    if (root.size() > 0) {
        const Eigen::MatrixXd pulls = variances.cwiseInverse().asDiagonal() * root;
        const Eigen::LLT<Eigen::MatrixXd> precision(
            Eigen::MatrixXd::Identity(root.cols(), root.cols()) + root.transpose() * pulls);
        const Eigen::VectorXd error = standard_normals(root.cols(), random);
        result.mean +=
            root * (precision.solve(pulls.transpose() * (deviations - observations.mean)) +
                    precision.matrixU().solve(error));
    }
    return result;
}

Observations with_leading_means(const Observations& observations) {
    constexpr Eigen::Index most = 3;
    Observations result = observations;
    if (result.mean_root.cols() > most) {
        const Eigen::VectorXd stds = observations.variance.cwiseSqrt();
        const Eigen::MatrixXd scaled = stds.cwiseInverse().asDiagonal() * observations.mean_root;
        const SymmetricEigen squares = symmetric_eigen(gram(scaled));
        result.mean_root =
            observations.mean_root * squares.vectors.rightCols(most).rowwise().reverse();
        result.shown_mean.resize(0);
        result.shown_root.resize(0, 0);
    }
    return result;
}

}  // namespace taut
