// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/common_parameters.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

#include "net/sliding_nodes.hpp"
#include "net/support_stiffness.hpp"
#include "net/weight_as_load.hpp"
#include "sampling/uncertain_widths.hpp"

namespace taut {

CommonParameters::CommonParameters(const CableNet& net,
                                   const std::vector<UncertainParameter>& uncertain,
                                   bool frame_is_unknown, const Points& test_loads,
                                   BoundaryReleases released)
    : m_released(std::move(released)),
      m_has_frame(frame_is_unknown),
      m_node_count(net.node_count()) {
    if (frame_is_unknown) {
        set_frame(net);
    }
    for (const int node : m_released.moved) {
        for (int k = 0; k < 3; ++k) {
            m_motions.emplace_back(Points::Zero(3, net.node_count()));
            m_motions.back()(k, node) = m_translation_unit;
        }
    }
    for (const UncertainParameter& parameter : uncertain) {
        if (is_common(parameter)) {
            m_uncertain.push_back(parameter);
        }
    }
    m_slip_std = std_of(uncertain, UncertainParameter::Kind::slip);
    if (m_slip_std > 0.0) {
        m_slip_count = static_cast<int>(net.sliding_nodes().size());
        m_stretch_count = static_cast<int>(sliding_stretches(net).size());
    }
    if (const double std_dev = std_of(uncertain, UncertainParameter::Kind::supports);
        std_dev > 0.0) {
        for (const int node : coupled_supports(net)) {
            for (int axis = 0; axis < 3; ++axis) {
                Points shift = Points::Zero(3, net.node_count());
                shift(axis, node) = std_dev;
                m_place_loads.push_back(support_forces(net, shift));
            }
        }
    }
    m_stiffness.setZero(net.edge_count(), count());
    m_thermal.setZero(net.edge_count(), count());
    m_load_rates.assign(count(), Points(3, 0));
    // Each load has one error: of the mass, of the known loads of a survey, or of all others.
    const bool is_mass_uncertain = std_of(uncertain, UncertainParameter::Kind::mass) > 0.0;
    Points other_loads = is_mass_uncertain ? net.data().loads : net.loads();
    if (test_loads.cols() > 0) {
        other_loads -= test_loads;
    }
    for (int k = 0; k < static_cast<int>(m_uncertain.size()); ++k) {
        const UncertainParameter& parameter = m_uncertain[k];
        if (parameter.kind == UncertainParameter::Kind::loads) {
            m_load_rates[k] = parameter.std_dev * other_loads;
        } else if (parameter.kind == UncertainParameter::Kind::mass) {
            m_load_rates[k] = parameter.std_dev * self_weight(net);
        } else if (parameter.kind == UncertainParameter::Kind::test_loads) {
            m_load_rates[k] = parameter.std_dev * test_loads;
        }
        for (const int edge : edges_of(net, parameter)) {
            if (parameter.kind == UncertainParameter::Kind::stiffness) {
                m_stiffness(edge, k) = parameter.std_dev;
            } else if (parameter.kind == UncertainParameter::Kind::temperature) {
                m_thermal(edge, k) = parameter.std_dev * net.data().expansion(edge);
            } else if (parameter.kind == UncertainParameter::Kind::creep) {
                m_thermal(edge, k) = parameter.std_dev;
            }
        }
    }
    for (int i = 0; i < static_cast<int>(m_released.turned.size()); ++i) {
        const int edge = m_released.turned[i];
        m_thermal(edge, place_of_turned(i)) = m_translation_unit / net.unstressed_lengths()(edge);
    }
    if (m_slip_count > 0) {
        m_slips.setZero(net.edge_count(), count());
        for (int k = 0; k < m_slip_count; ++k) {
            const SlidingNode& at = net.sliding_nodes()[k];
            m_slips(at.before, first_of_slips() + k) -= m_slip_std;
            m_slips(at.after, first_of_slips() + k) += m_slip_std;
        }
    }
}

/// Three translations and three rotations about the middle of the supports. A rotation moves the
/// farthest support by as much as a translation does.
void CommonParameters::set_frame(const CableNet& net) {
    const Points places = net.support_places();
    m_middle = places.rowwise().mean();
    const double reach = (places.colwise() - m_middle).colwise().norm().maxCoeff();
    m_reach = reach > 0.0 ? reach : 1.0;
    m_motions.assign(6, Points::Zero(3, net.node_count()));
    const auto motion_of = [&](const Eigen::Vector3d& place, int k) -> Eigen::Vector3d {
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k % 3);
        return m_translation_unit * (k < 3 ? axis : axis.cross((place - m_middle) / m_reach));
    };
    m_frame_loads.assign(net.elastic_supports().empty() ? 0 : 6, Points::Zero(3, m_node_count));
    for (int k = 0; k < 6; ++k) {
        for (const int node : net.supports()) {
            m_motions[k].col(node) = motion_of(net.nodes().col(node), k);
        }
        if (net.elastic_supports().empty()) {
            continue;
        }
        Points moved = Points::Zero(3, m_node_count);
        for (const ElasticSupport& support : net.elastic_supports()) {
            moved.col(support.node) = motion_of(support.place, k);
        }
        m_frame_loads[k] = support_forces(net, moved);
    }
}

double CommonParameters::support_stiffness_rate(int k) const {
    return k < std::ssize(m_uncertain) &&
                   m_uncertain[k].kind == UncertainParameter::Kind::support_stiffness
               ? m_uncertain[k].std_dev
               : 0.0;
}

double CommonParameters::support_factor(const Eigen::VectorXd& values) const {
    double logarithm = 0.0;
    for (int k = 0; k < std::ssize(m_uncertain); ++k) {
        logarithm += support_stiffness_rate(k) * values(k);
    }
    return std::exp(logarithm);
}

double CommonParameters::stiffness_factor(int edge, const Eigen::VectorXd& values) const {
    return count() > 0 ? std::exp(m_stiffness.row(edge).dot(values)) : 1.0;
}

double CommonParameters::thermal_strain(int edge, const Eigen::VectorXd& values) const {
    return count() > 0 ? m_thermal.row(edge).dot(values) : 0.0;
}

Eigen::VectorXd CommonParameters::length_stds(const Eigen::VectorXd& lengths) const {
    const Eigen::VectorXd thermal = lengths.cwiseProduct(m_thermal.rowwise().norm());
    return m_slips.size() > 0
               ? Eigen::VectorXd(
                     (thermal.cwiseAbs2() + m_slips.rowwise().squaredNorm()).cwiseSqrt())
               : thermal;
}

Eigen::VectorXd CommonParameters::cold(const Eigen::VectorXd& lengths,
                                       const Eigen::VectorXd& values) const {
    Eigen::VectorXd result = lengths;
    for (int e = 0; count() > 0 && e < lengths.size(); ++e) {
        result(e) = cold(e, lengths(e), values);
    }
    return result;
}

Points CommonParameters::support_motion(const Eigen::VectorXd& values) const {
    Points motion = Points::Zero(3, m_node_count);
    for (size_t k = 0; k < m_motions.size(); ++k) {
        motion += values(first_of_frame() + static_cast<Eigen::Index>(k)) * m_motions[k];
    }
    return motion;
}

Points CommonParameters::frame_motion(const Eigen::VectorXd& values) const {
    Eigen::VectorXd of_frame = values;
    of_frame.tail(values.size() - kept_count()).setZero();
    return support_motion(of_frame);
}

Points CommonParameters::frame_loads(const Eigen::VectorXd& values) const {
    Points loads = Points::Zero(3, m_frame_loads.empty() ? 0 : m_node_count);
    for (size_t k = 0; k < m_frame_loads.size(); ++k) {
        loads += values(first_of_frame() + static_cast<Eigen::Index>(k)) * m_frame_loads[k];
    }
    return loads;
}

Points CommonParameters::place_loads(const Eigen::VectorXd& values) const {
    Points loads = Points::Zero(3, m_place_loads.empty() ? 0 : m_node_count);
    for (size_t k = 0; k < m_place_loads.size(); ++k) {
        loads += values(first_of_places() + static_cast<Eigen::Index>(k)) * m_place_loads[k];
    }
    return loads;
}

Points CommonParameters::load_change(const Eigen::VectorXd& values) const {
    Points change(3, 0);
    for (int k = 0; k < count(); ++k) {
        if (m_load_rates[k].cols() > 0) {
            change = change.cols() > 0 ? Points(change + values(k) * m_load_rates[k])
                                       : Points(values(k) * m_load_rates[k]);
        }
    }
    return change;
}

}  // namespace taut
