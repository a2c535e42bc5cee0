// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "statics/length_rates.hpp"
#include "statics/net_state.hpp"
#include "statics/stiffness_factor.hpp"

namespace taut {

/// The angle by which a run turns at a node where it slides.
/// @param form of a net with these edges (3 x n)
[[nodiscard]] TAUT_CORE_EXPORT double contact_angle(const std::vector<Edge>& edges,
                                                    const Eigen::Ref<const Points>& form,
                                                    const SlidingNode& at);

/// The runs of a net as they slide on from a form in which they stand: where its tensions differ by
/// more than friction holds, as estimated ones may, that is taken for their ratio without friction.
/// @param form in equilibrium with clamped runs (3 x n) [m]
/// @param tensions there (m) [N]
/// @param friction_error by which friction is larger than given, or than CableRun::likely_friction
[[nodiscard]] TAUT_CORE_EXPORT std::vector<CableRun> runs_from_here(
    const CableNet& net, const Eigen::Ref<const Points>& form,
    const Eigen::Ref<const Eigen::VectorXd>& tensions, double friction_error = 0.0);

/// What balances where a run slides through a node, docs/theory.md (capstan): of_after times the
/// tension behind it less of_before times that before it is 0.
struct SlidingBalance {
    int before;  ///< edge
    int after;
    double of_before;
    double of_after;
    double by_angle;  ///< its derivative by the angle at which the run turns there [N]
};

/// The balances that hold at a form: of nodes between taut edges whose tensions are equal, or with
/// friction stand at one of its limits.
[[nodiscard]] std::vector<SlidingBalance> sliding_balances(const std::vector<SlidingNode>& nodes,
                                                           const LengthRates& rates);

/// Derivatives of balances, docs/theory.md (sliding): a slip is a length that passes from the edge
/// before a node to the one behind it.
struct SlidingRates {
    /// @param factor of the stiffness at the form
    SlidingRates(const LengthRates& rates, const StiffnessFactor& factor,
                 std::vector<SlidingBalance> balances);

    /// Adds to changes of lengths the slips that keep the balances (m) [m].
    void add_slips(Eigen::VectorXd& changes) const;
    /// What a change of each balance by one adds to a function, through the slips that undo it.
    /// @param gradient of the function by all lengths, without sliding (m)
    [[nodiscard]] Eigen::VectorXd multipliers(const Eigen::VectorXd& gradient) const;

    std::vector<SlidingBalance> balances;  ///< k
    Eigen::MatrixXd by_tension;            ///< of the balances by the tensions (k x m)
    Eigen::MatrixXd moves;                 ///< K^-1 times their gradients by places (3 n_I x k)
    Eigen::MatrixXd by_length;             ///< with the form that follows (k x m) [N/m]
    Eigen::MatrixXd by_slip;               ///< k x k [N/m]
    /// Of each, through the angle at its node, by the vectors of the edges before and behind it, as
    /// LengthRates::across() [N/m].
    std::vector<std::array<Eigen::Vector3d, 2>> by_turn;

private:
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> m_factor;  ///< of by_slip
};

/// Lets the runs of a net slide until tensions balance: a semismooth Newton method over the slips,
/// with a line search, docs/theory.md (sliding). Holds a copy of what it needs of the net.
class RunSliding {
public:
    explicit RunSliding(std::vector<SlidingNode> nodes) : m_nodes(std::move(nodes)) {}

    [[nodiscard]] bool is_empty() const { return m_nodes.empty(); }

    /// Balances the forces of the state for its unstressed lengths; whether that succeeds.
    using Balance = std::function<bool()>;
    /// @param state in balance, with the lengths as marked, which become those after sliding
    /// @return the largest difference of tensions that is left, 0 where it is within rounding
    ///   errors [N]
    double run(const LocalNet& net, Stiffness& stiffness, NetState& state,
               const Balance& balance) const;

private:
    std::vector<SlidingNode> m_nodes;
};

}  // namespace taut
