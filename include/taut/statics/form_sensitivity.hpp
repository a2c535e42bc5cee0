// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The gradient of a function of the equilibrium form by what a net is made of.
struct NetGradient {
    Eigen::VectorXd unstressed_lengths;  ///< m
    Eigen::VectorXd axial_stiffness;     ///< m; 0 for an edge with a piecewise linear law
    Points loads;                        ///< 3 x n; 0 at supports
    /// 3 x n, places of supports, of elastic ones their place without load; 0 at other nodes
    Points nodes;
};

/// First and second derivatives of the equilibrium form with respect to unstressed lengths. By the
/// implicit function theorem on h(r_I, l_0) = 0 (eq. h), with the stiffness H = dh/dr_I:
///
///     dr_I/dl_0 = -H^-1 dh/dl_0,   dh_s/dl_0(s,t) = -EA (r_s - r_t) / l_0^2   (0 for a slack edge)
///
/// and once more, docs/theory.md (second derivative). Where an edge goes slack or taut, and at a
/// corner of a tension law, the form has a kink: derivatives are those of the side it is on. H is
/// factorised once, on construction; each derivative is then one or three solves with it. Where
/// runs slide, they slide on under the change, docs/theory.md (sliding), if the tensions at a node
/// stand at the limit of its friction; second derivatives are refused then. It holds a copy of what
/// it needs of the net. One object may be used by several threads at once. A moved-from object may
/// only be assigned to or destroyed.
class TAUT_CORE_EXPORT FormSensitivity {
public:
    /// If H is singular (a slack mechanism) it is shifted by 1e-12 of the nodes' axial stiffness,
    /// so that loose nodes do not move.
    /// @param unstressed_lengths l_0 of all edges, Equilibrium::unstressed_lengths where runs slide
    ///   (m) [m]
    /// @param form an equilibrium form for them, which is not checked (3 x n) [m]
    /// @throws std::invalid_argument for wrong sizes, lengths that are not positive and finite,
    ///   coordinates that are not finite
    FormSensitivity(const CableNet& net,
                    const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                    const Eigen::Ref<const Points>& form);
    ~FormSensitivity();
    FormSensitivity(FormSensitivity&&) noexcept;             ///< moves
    FormSensitivity& operator=(FormSensitivity&&) noexcept;  ///< moves
    FormSensitivity(const FormSensitivity&) = delete;
    FormSensitivity& operator=(const FormSensitivity&) = delete;

    /// (dr_I/dl_0) dl_0: change of the free coordinates (3 n_I) [m] to first order, for changes of
    /// all unstressed lengths (m) [m].
    /// @throws std::invalid_argument for a wrong size
    [[nodiscard]] Eigen::VectorXd apply(
        const Eigen::Ref<const Eigen::VectorXd>& length_changes) const;

    /// (dr_I/dl_0)' g: the gradient with respect to all unstressed lengths (m) of a function of the
    /// form with gradient g. One pair of triangular solves. The unit is that of g.
    /// @param gradient g, in the order of r_I (3 n_I)
    /// @throws std::invalid_argument for a wrong size
    [[nodiscard]] Eigen::VectorXd apply_transposed(
        const Eigen::Ref<const Eigen::VectorXd>& gradient) const;

    /// The same for all that a net is made of: with x = H^-1 g, the gradient by anything else p is
    /// -(dh/dp)' x. One pair of triangular solves.
    /// @param gradient of a function of the form by all nodes, supports included (3 x n)
    /// @throws std::invalid_argument for a wrong size
    [[nodiscard]] NetGradient net_gradient(const Eigen::Ref<const Points>& gradient) const;

    /// r''[v, w]: the second derivative of the free coordinates (3 n_I) [m] along two changes of
    /// all unstressed lengths (m) [m]. Symmetric in them; with v = w, twice the term of second
    /// order.
    /// @throws std::invalid_argument for a wrong size, and where a run slides
    [[nodiscard]] Eigen::VectorXd apply_second(
        const Eigen::Ref<const Eigen::VectorXd>& length_changes,
        const Eigen::Ref<const Eigen::VectorXd>& more_changes) const;

    /// g . r''[v, .]: the gradient with respect to all unstressed lengths (m) of g . apply(v), for
    /// a constant g. The Hessian of a function f of the form, of gradient g, times v is this plus
    /// apply_transposed(f'' apply(v)). The unit is that of g.
    /// @param gradient g, in the order of r_I (3 n_I)
    /// @param length_changes v, of all edges (m) [m]
    /// @throws std::invalid_argument for a wrong size, and where a run slides
    [[nodiscard]] Eigen::VectorXd apply_second_transposed(
        const Eigen::Ref<const Eigen::VectorXd>& gradient,
        const Eigen::Ref<const Eigen::VectorXd>& length_changes) const;

    /// The columns of dr_I/dl_0 for the given edges (3 n_I x edges.size()) [m/m].
    /// @throws std::invalid_argument for an edge that the net does not have
    [[nodiscard]] Eigen::MatrixXd columns(std::span<const int> edges) const;

    /// How the unstressed lengths between the nodes change with those of the given edges once runs
    /// have slid, docs/theory.md (sliding): columns of the identity where none does (m x
    /// edges.size()) [m/m].
    /// @throws std::invalid_argument for an edge that the net does not have
    [[nodiscard]] Eigen::MatrixXd slid_columns(std::span<const int> edges) const;

private:
    struct Factor;
    std::unique_ptr<Factor> m_factor;
};

/// Sensitivity of the form to the length of one edge.
struct EdgeSensitivity {
    int edge;     ///< index in the net
    double move;  ///< norm of dr_I/dl_0, over all free coordinates [m/m]
};

/// The `count` of the given edges whose lengths move the form most, in descending order; all of
/// them if there are fewer.
/// @throws std::invalid_argument for an edge that the net does not have
[[nodiscard]] TAUT_CORE_EXPORT std::vector<EdgeSensitivity> most_sensitive_edges(
    const FormSensitivity& sensitivity, std::span<const int> edges, int count);

}  // namespace taut
