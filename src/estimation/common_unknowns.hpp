// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/sampling/unknown.hpp"

namespace taut {

/// Unknown numbers that act on many edges or loads at once, in their standard deviations: common
/// factors of the stiffness, temperatures, a factor of the loads. docs/theory.md, (common).
class CommonUnknowns {
public:
    CommonUnknowns() = default;
    /// @param unknowns of the net; those of other kinds are left out
    CommonUnknowns(const CableNet& net, const std::vector<Unknown>& unknowns);

    [[nodiscard]] int count() const { return static_cast<int>(m_unknowns.size()); }
    [[nodiscard]] const Unknown& operator[](int k) const { return m_unknowns[k]; }

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
        return m_unknowns[k].kind == Unknown::Kind::loads ? m_unknowns[k].std : 0.0;
    }

private:
    std::vector<Unknown> m_unknowns;
    Eigen::MatrixXd m_stiffness;  ///< m x count
    Eigen::MatrixXd m_thermal;    ///< m x count
};

}  // namespace taut
