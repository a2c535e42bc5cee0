// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/form_target.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "statics/arguments.hpp"
#include "taut/survey/target_offsets.hpp"

namespace taut {

FormTarget::FormTarget(const CableNet& net, Points places, DeviationWeights weights,
                       FormObjective objective)
    : m_free_nodes(net.free_nodes()), m_places(std::move(places)), m_objective(objective) {
    check_form("target", net.node_count(), m_places);
    m_normals = node_normals(net, m_places);
    m_normal_weight.setConstant(net.node_count(), weights.normal);
    m_tangential_weight.setConstant(net.node_count(), weights.tangential);
    check_weights();
}

void FormTarget::set_weights(Eigen::VectorXd normal, Eigen::VectorXd tangential) {
    if (normal.size() != m_places.cols() || tangential.size() != m_places.cols()) {
        throw std::invalid_argument(fmt::format("{} and {} weights for {} nodes", normal.size(),
                                                tangential.size(), m_places.cols()));
    }
    m_normal_weight = std::move(normal);
    m_tangential_weight = std::move(tangential);
    check_weights();
}

void FormTarget::move_to(Points places) {
    check_form("target", m_places.cols(), places);
    m_places = std::move(places);
}

void FormTarget::check_weights() const {
    double sum = 0.0;
    for (const int node : m_free_nodes) {
        for (const double weight : {m_normal_weight(node), m_tangential_weight(node)}) {
            if (!std::isfinite(weight) || weight < 0.0) {
                throw std::invalid_argument(
                    fmt::format("a weight is {}, expected 0 or more", weight));
            }
            sum += weight;
        }
    }
    if (!(sum > 0.0)) {
        throw std::invalid_argument("all weights are 0, expected one above");
    }
}

Eigen::Matrix3d FormTarget::weight(int node) const {
    const auto normal = m_normals.col(node);
    const double along = std::sqrt(m_normal_weight(node));
    if (normal.isZero(0.0)) {
        return along * Eigen::Matrix3d::Identity();
    }
    const double across = std::sqrt(m_tangential_weight(node));
    return across * Eigen::Matrix3d::Identity() + (along - across) * normal * normal.transpose();
}

Eigen::Vector3d FormTarget::weighted(int node, const Eigen::Vector3d& deviation) const {
    return weight(node) * deviation;
}

FormDeviation deviation_from(const FormTarget& target, const CableNet& net, const Points& form) {
    check_form("form", target.places().cols(), form);
    FormDeviation result;
    int with_normal = 0;
    for (const int node : net.free_nodes()) {
        const Eigen::Vector3d deviation = form.col(node) - target.places().col(node);
        const double size = deviation.norm();
        result.mean += size;
        result.max = std::max(result.max, size);
        result.rmse += size * size;
        if (!target.normals().col(node).isZero(0.0)) {
            const double along = std::abs(target.normals().col(node).dot(deviation));
            ++with_normal;
            result.normal_mean += along;
            result.normal_max = std::max(result.normal_max, along);
            result.normal_rmse += along * along;
        }
    }
    const double count = net.free_node_count();
    result.mean /= count;
    result.rmse = std::sqrt(result.rmse / count);
    if (with_normal > 0) {
        result.normal_mean /= with_normal;
        result.normal_rmse = std::sqrt(result.normal_rmse / with_normal);
    }
    return result;
}

}  // namespace taut
