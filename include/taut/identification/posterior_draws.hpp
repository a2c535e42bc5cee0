// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Deviations from the net besides lengths, one draw a column; a matrix of 0 x 0: none.
struct ModelPerturbations {
    /// m x draws: logarithm of the factor of EA, or of the tension law.
    Eigen::MatrixXd stiffness;
    /// m x draws: relative change of the unstressed lengths, by temperature or, of an adjustable
    /// edge that was found at another length, by that.
    Eigen::MatrixXd thermal;
    Eigen::MatrixXd supports;  ///< 3 n_S x draws: of their places, as CableNet::supports() [m]
    Eigen::MatrixXd loads;     ///< 3 n_I x draws: of the loads on free nodes [N]

    /// Whether there are none.
    [[nodiscard]] bool empty() const {
        return stiffness.size() + thermal.size() + supports.size() + loads.size() == 0;
    }
};

/// Draws of the posterior, one a column: lengths and all else that is uncertain, with the form and
/// the tensions that follow in exact equilibrium.
struct PosteriorDraws {
    Eigen::MatrixXd length_deviations;  ///< m_I x draws, of the interior edges [m]
    /// m_A x draws, of the adjustable edges where their lengths, too, were uncertain; 0 x 0: they
    /// are as given [m].
    Eigen::MatrixXd adjustable_deviations;
    ModelPerturbations perturbations;  ///< of stiffness, temperature, supports and loads
    Eigen::MatrixXd forms;             ///< 3 n_I x draws, free coordinates [m]
    Eigen::MatrixXd tensions;          ///< m x draws, of all edges [N]
    std::uint64_t seed = 1;            ///< of the random numbers
    std::string method;                ///< of drawing, in words
    bool is_refitted = false;  ///< by fits of their own or chains: they determine the lengths, too
    std::string reason;        ///< why they are not reliable; empty: they are

    /// How many draws.
    [[nodiscard]] int count() const { return static_cast<int>(length_deviations.cols()); }
};

/// Mean, standard deviation and 95 % interval of a number over draws, docs/theory.md (drawn).
struct DrawnEstimate {
    double mean = 0.0;     ///< in the unit of the number, as all below
    double std_dev = 0.0;  ///< divisor draws - 1; 0 of one draw
    double lower = 0.0;    ///< lower end of the interval
    double upper = 0.0;    ///< its upper end
};

/// Posterior of the tension of one edge.
struct DrawnTension {
    int edge = 0;                    ///< index in the net
    DrawnEstimate tension;           ///< [N]
    double slack_probability = 0.0;  ///< the part of the draws in which it carries nothing
};

/// Posterior of the place of one free node.
struct DrawnPlace {
    int node = 0;             ///< index of a free node
    Eigen::Vector3d mean;     ///< [m]
    Eigen::Vector3d std_dev;  ///< [m]
    Eigen::Vector3d lower;    ///< 95 % interval of each coordinate [m]
    Eigen::Vector3d upper;    ///< its upper end [m]
};

/// Tensions and places that follow from draws.
struct DrawnSummary {
    std::vector<DrawnTension> tensions;  ///< one an edge, in their order
    DrawnEstimate mean_tension;          ///< over all cables [N]
    std::vector<DrawnPlace> missing;     ///< of the nodes that the survey misses
};

}  // namespace taut
