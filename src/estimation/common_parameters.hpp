// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <iterator>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// Whether a parameter is one number for many edges: of stiffness, temperature, creep, loads or
/// force measurements.
[[nodiscard]] inline bool is_common(const UncertainParameter& parameter) {
    return parameter.kind == UncertainParameter::Kind::stiffness ||
           parameter.kind == UncertainParameter::Kind::temperature ||
           parameter.kind == UncertainParameter::Kind::creep ||
           parameter.kind == UncertainParameter::Kind::loads ||
           parameter.kind == UncertainParameter::Kind::forces ||
           parameter.kind == UncertainParameter::Kind::mass ||
           parameter.kind == UncertainParameter::Kind::test_loads ||
           parameter.kind == UncertainParameter::Kind::support_stiffness;
}

/// Outliers among adjustable edges and supports: nothing is assumed of them.
struct BoundaryReleases {
    std::vector<int> turned;  ///< edges of another length
    std::vector<int> moved;   ///< supports at another place

    [[nodiscard]] int count() const { return static_cast<int>(turned.size() + moved.size()); }
    bool operator==(const BoundaryReleases&) const = default;
};

/// The parameters in the border of the matrix, in their standard deviations: common factors of the
/// stiffness, temperatures, creep (thermal strains hold both), a factor of the loads and errors of
/// force measurements; a slip of each sliding node and a tension of each stretch that slides; three
/// of each support on a common frame, its place without load, where these are uncertain; six of the
/// survey's frame, as a small motion of all supports; three of each released support and one of
/// each released adjustable edge. docs/theory.md, (common), (slips), (frame), (boundary).
class CommonParameters {
public:
    CommonParameters() = default;
    /// @param uncertain of the net; those not is_common() are ignored
    /// @param frame_is_unknown whether the frame is among the parameters
    /// @param test_loads of the survey, among the net's loads (3 x n); 3 x 0: none [N]
    CommonParameters(const CableNet& net, const std::vector<UncertainParameter>& uncertain,
                     bool frame_is_unknown = false, const Points& test_loads = Points(3, 0),
                     BoundaryReleases released = {});

    [[nodiscard]] int count() const {
        return first_of_frame() + static_cast<int>(m_motions.size() + m_released.turned.size());
    }
    /// How many are not of the released boundary: these come first.
    [[nodiscard]] int kept_count() const { return first_of_frame() + (m_has_frame ? 6 : 0); }
    [[nodiscard]] const BoundaryReleases& released() const { return m_released; }
    /// Places of the parameters of a released support (the first of three) and of a released edge,
    /// by their order in released().
    [[nodiscard]] int place_of_moved(int i) const { return kept_count() + 3 * i; }
    [[nodiscard]] int place_of_turned(int i) const {
        return kept_count() + 3 * static_cast<int>(m_released.moved.size()) + i;
    }
    /// Standard deviation of the parameters of the released boundary [m].
    [[nodiscard]] static double released_unit() { return m_translation_unit; }
    /// How many are given: these come first of all.
    [[nodiscard]] int given_count() const { return static_cast<int>(m_uncertain.size()); }
    /// Of the given ones.
    [[nodiscard]] const UncertainParameter& operator[](int k) const { return m_uncertain[k]; }

    /// Factor of an edge's stiffness.
    [[nodiscard]] double stiffness_factor(int edge, const Eigen::VectorXd& values) const;
    /// Relative change of an edge's unstressed length.
    [[nodiscard]] double thermal_strain(int edge, const Eigen::VectorXd& values) const;
    /// Place of the slip of the first sliding node, in the order of CableNet::sliding_nodes().
    [[nodiscard]] int first_of_slips() const { return given_count(); }
    /// Place of the tension of the first stretch, in the order of sliding_stretches().
    [[nodiscard]] int first_of_stretches() const { return first_of_slips() + m_slip_count; }
    /// Prior standard deviation of a slip [m].
    [[nodiscard]] double slip_std() const { return m_slip_std; }
    /// Length that has passed to an edge, at the reference temperature [m].
    [[nodiscard]] double slip(int edge, const Eigen::VectorXd& values) const {
        return m_slips.size() > 0 ? m_slips.row(edge).dot(values) : 0.0;
    }
    /// Change of that by one standard deviation.
    [[nodiscard]] double slip_rate(int k, int edge) const {
        return m_slips.size() > 0 ? m_slips(edge, k) : 0.0;
    }
    /// The same of edges, by all parameters (k x count).
    [[nodiscard]] Eigen::MatrixXd slip_rates(const std::vector<int>& edges) const {
        return m_slips.size() > 0 ? Eigen::MatrixXd(m_slips(edges, Eigen::all))
                                  : Eigen::MatrixXd::Zero(std::ssize(edges), count());
    }
    /// Length at the reference temperature, before anything slid, of an edge of this length.
    [[nodiscard]] double cold(int edge, double length, const Eigen::VectorXd& values) const {
        return length / (1.0 + thermal_strain(edge, values)) - slip(edge, values);
    }
    /// Of all edges (m).
    [[nodiscard]] Eigen::VectorXd cold(const Eigen::VectorXd& lengths,
                                       const Eigen::VectorXd& values) const;
    /// Prior standard deviations by thermal strains and slips of edges of these lengths (m) [m].
    [[nodiscard]] Eigen::VectorXd length_stds(const Eigen::VectorXd& lengths) const;
    /// Change of the loads (3 x n); 3 x 0 where none can change [N].
    [[nodiscard]] Points load_change(const Eigen::VectorXd& values) const;

    /// Factor of the stiffness of all elastic supports.
    [[nodiscard]] double support_factor(const Eigen::VectorXd& values) const;
    /// Change of its logarithm by one standard deviation.
    [[nodiscard]] double support_stiffness_rate(int k) const;
    /// Change of log(EA), and of the thermal strain, of an edge by one standard deviation.
    [[nodiscard]] double stiffness_rate(int k, int edge) const {
        return m_stiffness.size() > 0 ? m_stiffness(edge, k) : 0.0;
    }
    /// Relative change of the weight that makes cables sag, by one standard deviation of the mass.
    [[nodiscard]] double sag_rate(int k) const {
        return k < std::ssize(m_uncertain) && m_uncertain[k].kind == UncertainParameter::Kind::mass
                   ? m_uncertain[k].std_dev
                   : 0.0;
    }
    [[nodiscard]] double sag_factor(const Eigen::VectorXd& values) const {
        double factor = 1.0;
        for (int k = 0; k < std::ssize(m_uncertain); ++k) {
            factor += sag_rate(k) * values(k);
        }
        return factor;
    }
    [[nodiscard]] double thermal_rate(int k, int edge) const {
        return m_thermal.size() > 0 ? m_thermal(edge, k) : 0.0;
    }
    /// Change of the loads by one standard deviation (3 x n); 3 x 0: none [N].
    [[nodiscard]] const Points& load_rate(int k) const { return m_load_rates[k]; }
    /// Change of a support's place by one standard deviation; 0 for free nodes [m].
    [[nodiscard]] Eigen::Vector3d support_rate(int k, int node) const {
        const int motion = k - first_of_frame();
        return motion >= 0 && motion < std::ssize(m_motions)
                   ? Eigen::Vector3d(m_motions[motion].col(node))
                   : Eigen::Vector3d::Zero();
    }
    /// Place of the first of three parameters of the first support on a common frame, in the order
    /// of coupled_supports().
    [[nodiscard]] int first_of_places() const { return first_of_stretches() + m_stretch_count; }
    /// K times the errors of their places (3 x n); 3 x 0: none [N].
    [[nodiscard]] Points place_loads(const Eigen::VectorXd& values) const;
    /// Place of the first parameter of the frame: three translations, then three rotations.
    [[nodiscard]] int first_of_frame() const {
        return first_of_places() + static_cast<int>(m_place_loads.size());
    }
    /// Centre of the rotations of the frame.
    [[nodiscard]] const Eigen::Vector3d& frame_middle() const { return m_middle; }
    /// Standard deviations of a translation [m] and of a rotation [rad].
    [[nodiscard]] double translation_unit() const { return m_translation_unit; }
    [[nodiscard]] double rotation_unit() const { return m_translation_unit / m_reach; }
    [[nodiscard]] bool has_frame() const { return m_has_frame; }
    /// Whether any of them moves supports.
    [[nodiscard]] bool moves_supports() const { return !m_motions.empty(); }
    /// Motion of all supports, 0 elsewhere (3 x n) [m].
    [[nodiscard]] Points support_motion(const Eigen::VectorXd& values) const;
    /// The part of it by the frame, which is no error of the supports.
    [[nodiscard]] Points frame_motion(const Eigen::VectorXd& values) const;
    /// K m of elastic supports, which move by m with the frame (3 x n); 3 x 0: none [N].
    [[nodiscard]] Points frame_loads(const Eigen::VectorXd& values) const;
    /// K times the change of the places of elastic supports by one standard deviation of a
    /// parameter, at a node [N].
    [[nodiscard]] Eigen::Vector3d place_load_rate(int k, int node) const {
        if (k >= first_of_places() && k < first_of_frame()) {
            return m_place_loads[static_cast<size_t>(k - first_of_places())].col(node);
        }
        const int i = k - first_of_frame();
        return i >= 0 && i < std::ssize(m_frame_loads) ? Eigen::Vector3d(m_frame_loads[i].col(node))
                                                       : Eigen::Vector3d::Zero();
    }

private:
    void set_frame(const CableNet& net);

    std::vector<UncertainParameter> m_uncertain;
    BoundaryReleases m_released;
    bool m_has_frame = false;
    Eigen::MatrixXd m_stiffness;  ///< m x count
    Eigen::MatrixXd m_thermal;    ///< m x count
    Eigen::MatrixXd m_slips;      ///< m x count; empty where nothing slides [m]
    double m_slip_std = 0.0;
    int m_slip_count = 0;
    int m_stretch_count = 0;
    std::vector<Points> m_place_loads;  ///< three a support on a common frame, each 3 x n [N]
    std::vector<Points> m_motions;      ///< six of the frame, or none; three a moved support
    std::vector<Points> m_load_rates;   ///< count, each 3 x n or 3 x 0
    Eigen::Index m_node_count = 0;
    std::vector<Points> m_frame_loads;  ///< of six parameters, or none, each 3 x n [N]
    Eigen::Vector3d m_middle = Eigen::Vector3d::Zero();
    double m_reach = 1.0;  ///< largest distance of a support from it [m]
    static constexpr double m_translation_unit = 0.1;  ///< far more than such errors [m]
};

}  // namespace taut
