// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/form_target.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "net/check_index.hpp"
#include "statics/arguments.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/target_offsets.hpp"

namespace taut {

FormTarget::FormTarget(const CableNet& net, Points places, DeviationWeights weights,
                       FormObjective objective)
    : m_places(std::move(places)), m_objective(objective) {
    check_form("target", net.node_count(), m_places);
    m_normals = node_normals(net, m_places);
    m_normal_weight.setConstant(net.node_count(), weights.normal);
    m_tangential_weight.setConstant(net.node_count(), weights.tangential);
    std::ranges::remove_copy_if(net.free_nodes(), std::back_inserter(m_free_nodes),
                                [&net](int node) { return net.is_support(node); });
    for (const ElasticSupport& support : net.elastic_supports()) {
        m_normal_weight(support.node) = 0.0;
        m_tangential_weight(support.node) = 0.0;
    }
    check_weights();
}

FormTarget::FormTarget(const CableNet& net, std::shared_ptr<const TargetSurface> surface,
                       DeviationWeights weights, FormObjective objective)
    : FormTarget(net, net.nodes(), weights, objective) {
    if (!surface) {
        throw std::invalid_argument("the target surface is null");
    }
    m_surface = std::move(surface);
    m_designed = net.nodes();
    check_nearness(net);
    *this = at(m_designed);
}

void FormTarget::check_nearness(const CableNet& net) const {
    const double size = (m_designed.rowwise().maxCoeff() - m_designed.rowwise().minCoeff()).norm();
    const double most = std::min(1.0, 0.25 * size);
    const auto distance_in = [&](int node, double unit) {
        return unit * m_surface->nearest(m_designed.col(node) / unit).distance;
    };
    double mean_edge = 0.0;
    for (const auto& [s, t] : net.edges()) {
        mean_edge += (m_designed.col(s) - m_designed.col(t)).norm() / net.edge_count();
    }
    for (const int node : m_free_nodes) {
        const SurfacePoint nearest = m_surface->nearest(m_designed.col(node));
        const double distance = nearest.distance;
        if (distance <= most && nearest.beyond_border <= mean_edge) {
            continue;
        }
        if (distance <= most) {
            throw std::invalid_argument(fmt::format(
                "node '{}' is {:.3g} m beyond the border of the surface, expected at most the mean "
                "length of an edge, {:.3g} m",
                net.node_id(node), nearest.beyond_border, mean_edge));
        }
        std::string hint = "is it in another unit or frame?";
        constexpr std::array<std::pair<const char*, double>, 4> units{
            {{"mm", 1e-3}, {"cm", 1e-2}, {"ft", 0.3048}, {"in", 0.0254}}};
        for (const auto& [name, unit] : units) {
            const auto fits = [&, in_it = unit](int other) {
                return distance_in(other, in_it) <= most;
            };
            if (std::ranges::all_of(m_free_nodes, fits)) {
                hint = fmt::format("in {} it would fit", name);
                break;
            }
        }
        throw std::invalid_argument(
            fmt::format("node '{}' is {:.3g} m from the surface, expected at most {:.3g} m; {}",
                        net.node_id(node), distance, most, hint));
    }
}

FormTarget FormTarget::at(const Points& form) const {
    check_form("form", m_places.cols(), form);
    FormTarget result = *this;
    if (m_surface == nullptr) {
        return result;
    }
    for (const int node : m_free_nodes) {
        const SurfacePoint nearest = m_surface->nearest(form.col(node));
        const auto designed = m_designed.col(node);
        // On the side of the net's own normal, where it has one.
        const double side = m_normals.col(node).dot(nearest.normal) < 0.0 ? -1.0 : 1.0;
        const Eigen::Vector3d normal = side * nearest.normal;
        result.m_normals.col(node) = normal;
        result.m_places.col(node) = designed + normal.dot(nearest.place - designed) * normal;
    }
    return result;
}

void FormTarget::set_weights(const std::vector<NodeWeights>& of_nodes) {
    Eigen::VectorXd normal = m_normal_weight;
    Eigen::VectorXd tangential = m_tangential_weight;
    for (const NodeWeights& of : of_nodes) {
        check_index("node", of.node, normal.size());
        normal(of.node) = of.normal;
        tangential(of.node) = of.tangential;
    }
    set_weights(std::move(normal), std::move(tangential));
}

void FormTarget::set_weights(Eigen::VectorXd normal, Eigen::VectorXd tangential) {
    if (normal.size() != m_places.cols() || tangential.size() != m_places.cols()) {
        throw std::invalid_argument(fmt::format("{} and {} weights for {} nodes", normal.size(),
                                                tangential.size(), m_places.cols()));
    }
    m_normal_weight.swap(normal);
    m_tangential_weight.swap(tangential);
    try {
        check_weights();
    } catch (...) {
        m_normal_weight.swap(normal);
        m_tangential_weight.swap(tangential);
        throw;
    }
}

void FormTarget::move_to(Points places) {
    check_form("target", m_places.cols(), places);
    if (m_surface != nullptr) {
        throw std::invalid_argument("a target that is a surface cannot be moved to places");
    }
    m_places = std::move(places);
}

void FormTarget::check_weights() const {
    for (const int node : m_free_nodes) {
        for (const double weight : {m_normal_weight(node), m_tangential_weight(node)}) {
            if (!std::isfinite(weight) || weight < 0.0) {
                throw std::invalid_argument(
                    fmt::format("a weight is {}, expected 0 or more", weight));
            }
        }
    }
}

Eigen::Matrix3d FormTarget::weight(int node) const {
    check_index("node", node, m_normals.cols());
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

FormTarget target_of(const CableNet& net, const GivenTarget& given) {
    FormTarget target =
        given.triangles.empty()
            ? FormTarget(net, given.points, given.weights, given.objective)
            : FormTarget(net, std::make_shared<const TargetSurface>(given.points, given.triangles),
                         given.weights, given.objective);
    if (!given.node_weights.empty()) {
        target.set_weights(given.node_weights);
    }
    return target;
}

std::vector<std::string> target_warnings(const CableNet& net, const FormTarget& target) {
    constexpr double least_shown = 1e-3;  // [m]
    std::vector<std::string> result;
    if (target.surface() == nullptr) {
        return result;
    }
    const TargetSurface& surface = *target.surface();
    if (surface.left_out() > 0) {
        result.push_back(fmt::format("{} of {} triangles have no area and are not used",
                                     surface.left_out(),
                                     surface.left_out() + surface.triangle_count()));
    }
    int outside = 0;
    int furthest = -1;
    double most = least_shown;
    for (const int node : net.free_nodes()) {
        if (net.is_support(node)) {
            continue;
        }
        const double distance = surface.nearest(net.nodes().col(node)).beyond_border;
        outside += distance > least_shown ? 1 : 0;
        if (distance > most) {
            most = distance;
            furthest = node;
        }
    }
    if (outside > 0) {
        result.push_back(fmt::format(
            "{} node{} outside the border of the surface, '{}' by {}. The surface is extended "
            "there",
            outside, outside == 1 ? " is" : "s are", net.node_id(furthest),
            format_length(1e-4 * std::round(1e4 * most))));
    }
    return result;
}

FormDeviation deviation_from(const FormTarget& of, const CableNet& net, const Points& form) {
    const FormTarget target = of.at(form);
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
