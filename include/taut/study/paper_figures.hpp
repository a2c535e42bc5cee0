// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/study/study.hpp"

namespace taut {

/// The paper's figures of its experiment (section 5), in SI units, for comparison.
struct PaperFigures {
    int free_nodes = 300;      ///< n_I
    int interior_edges = 536;  ///< m_I
    double mse = 1.7e-8;       ///< [m2]
    double mrse = 0.002;       ///< eq. MRSE [-]
    /// Table "Error Statistics", there in 1e-4 m.
    FormErrors form_errors{
        .nominal = {.max = 138e-4, .min = 1.93e-4, .mean = 47e-4, .rmse = 53e-4},
        .identified = {.max = 7.76e-4, .min = 0.194e-4, .mean = 2.73e-4, .rmse = 3.15e-4}};
};

}  // namespace taut
