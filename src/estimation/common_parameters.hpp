// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <iterator>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// Adjustable edges and supports that are not as told: nothing is known of them beforehand.
struct BoundaryReleases {
    std::vector<int> turned;  ///< edges of another length
    std::vector<int> moved;   ///< supports at another place

    [[nodiscard]] int count() const { return static_cast<int>(turned.size() + moved.size()); }
    bool operator==(const BoundaryReleases&) const = default;
};

/// UncertainParameter numbers in the border of the matrix, in their standard deviations: common
/// factors of the stiffness, temperatures, a factor of the loads; the six of the frame that a
/// survey is in, a small motion of all supports; three of each support and one of each adjustable
/// edge that are released. docs/theory.md, (common), (frame), (boundary).
class CommonParameters {
public:
    CommonParameters() = default;
    /// @param uncertain of the net; those of other kinds are left out
    /// @param frame_is_unknown whether the frame is among them
    CommonParameters(const CableNet& net, const std::vector<UncertainParameter>& uncertain,
                     bool frame_is_unknown = false, BoundaryReleases released = {});

    [[nodiscard]] int count() const {
        return static_cast<int>(m_uncertain.size() + m_motions.size() + m_released.turned.size());
    }
    /// Of those that are not released: they come first.
    [[nodiscard]] int kept_count() const {
        return static_cast<int>(m_uncertain.size()) + (m_has_frame ? 6 : 0);
    }
    [[nodiscard]] const BoundaryReleases& released() const { return m_released; }
    /// Places of the uncertain of a released support (the first of three) and of a released edge,
    /// by their order there.
    [[nodiscard]] int place_of_moved(int i) const { return kept_count() + 3 * i; }
    [[nodiscard]] int place_of_turned(int i) const {
        return kept_count() + 3 * static_cast<int>(m_released.moved.size()) + i;
    }
    /// What one of a released unknown is in its standard deviations [m].
    [[nodiscard]] static double released_unit() { return m_translation_unit; }
    /// Of those that are told.
    [[nodiscard]] const UncertainParameter& operator[](int k) const { return m_uncertain[k]; }

    /// The factor of an edge's stiffness.
    [[nodiscard]] double stiffness_factor(int edge, const Eigen::VectorXd& values) const;
    /// By which an edge's unstressed length is longer, relative.
    [[nodiscard]] double thermal_strain(int edge, const Eigen::VectorXd& values) const;
    /// The length that an edge of another has at the reference temperature.
    [[nodiscard]] double cold(int edge, double length, const Eigen::VectorXd& values) const {
        return length / (1.0 + thermal_strain(edge, values));
    }
    /// Of all edges (m).
    [[nodiscard]] Eigen::VectorXd cold(const Eigen::VectorXd& lengths,
                                       const Eigen::VectorXd& values) const;
    /// Standard deviation of each edge's thermal strain (m); before anything is found.
    [[nodiscard]] Eigen::VectorXd thermal_stds() const { return m_thermal.rowwise().norm(); }
    /// The factor of the loads.
    [[nodiscard]] double load_factor(const Eigen::VectorXd& values) const;

    /// What one of them changes at an edge: d log(EA) and d strain, by one standard deviation.
    [[nodiscard]] double stiffness_rate(int k, int edge) const {
        return m_stiffness.size() > 0 ? m_stiffness(edge, k) : 0.0;
    }
    [[nodiscard]] double thermal_rate(int k, int edge) const {
        return m_thermal.size() > 0 ? m_thermal(edge, k) : 0.0;
    }
    [[nodiscard]] double load_rate(int k) const {
        return is_told(k) && m_uncertain[k].kind == UncertainParameter::Kind::loads
                   ? m_uncertain[k].std
                   : 0.0;
    }
    /// Of a support's place; 0 for free nodes [m].
    [[nodiscard]] Eigen::Vector3d support_rate(int k, int node) const {
        const auto motion = k - std::ssize(m_uncertain);
        return motion >= 0 && motion < std::ssize(m_motions)
                   ? Eigen::Vector3d(m_motions[motion].col(node))
                   : Eigen::Vector3d::Zero();
    }
    /// Place of the first unknown of the frame among all: three translations, three rotations.
    [[nodiscard]] int first_of_frame() const { return static_cast<int>(m_uncertain.size()); }
    /// The point that rotations of the frame are about.
    [[nodiscard]] const Eigen::Vector3d& frame_middle() const { return m_middle; }
    /// What one of a translation [m] and of a rotation [rad] is in its standard deviations.
    [[nodiscard]] double translation_unit() const { return m_translation_unit; }
    [[nodiscard]] double rotation_unit() const { return m_translation_unit / m_reach; }
    [[nodiscard]] bool has_frame() const { return m_has_frame; }
    /// Whether any of them moves supports.
    [[nodiscard]] bool moves_supports() const { return !m_motions.empty(); }
    /// Motion of all supports, 0 elsewhere (3 x n) [m].
    [[nodiscard]] Points support_motion(const Eigen::VectorXd& values) const;
    /// What of it is the motion of the frame: no error of the supports.
    [[nodiscard]] Points frame_motion(const Eigen::VectorXd& values) const;

private:
    void set_frame(const CableNet& net);
    [[nodiscard]] bool is_told(int k) const { return k < std::ssize(m_uncertain); }

    std::vector<UncertainParameter> m_uncertain;
    BoundaryReleases m_released;
    bool m_has_frame = false;
    Eigen::MatrixXd m_stiffness;    ///< m x count
    Eigen::MatrixXd m_thermal;      ///< m x count
    std::vector<Points> m_motions;  ///< six of the frame, or none; three a moved support
    Eigen::Index m_node_count = 0;
    Eigen::Vector3d m_middle = Eigen::Vector3d::Zero();
    double m_reach = 1.0;                              ///< of the supports from there [m]
    static constexpr double m_translation_unit = 0.1;  ///< much more than such things are off [m]
};

}  // namespace taut
