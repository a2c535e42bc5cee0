// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// The paper's experiment on another net.
#include <iostream>

#include "taut/design/builtin_nets.hpp"
#include "taut/study/study.hpp"

int main() {
    const taut::StudySettings settings{
        .samples = 300, .validation = 20, .prior = {.scale = 0.003}, .seed = 7};
    const taut::Study study = taut::run_study(taut::hypar(8, 10), settings);

    std::cout << "MSE " << study.as_in_paper().errors.mse << " m2, MRSE "
              << 100.0 * study.as_in_paper().errors.mrse << " %\n"
              << "mean form error: nominal " << 1e3 * study.form_errors.nominal.mean
              << " mm, identified " << 1e3 * study.form_errors.identified.mean << " mm\n";
    return study.form_errors.identified.mean < study.form_errors.nominal.mean ? 0 : 1;
}
