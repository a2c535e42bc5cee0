// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a change anywhere on the way from the net to the lengths that makes the paper's
// experiment (section 5) come out worse than the paper's, or far better than is believable.

#include "taut/study/paper_figures.hpp"

#include <gtest/gtest.h>

#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;

TEST(PaperFigures, AreReachedOnTheBuiltInNet) {
#ifndef NDEBUG
    GTEST_SKIP()
        << "takes minutes without optimisation, as under the sanitizers: run it in release";
#endif
    const PaperFigures paper;
    const Study study = run_study(hilo_quarter(), {});
    EXPECT_EQ(study.net.free_node_count(), paper.free_nodes);
    EXPECT_EQ(study.net.interior_edge_count(), paper.interior_edges);
    EXPECT_EQ(study.data.not_converged(), 0);
    EXPECT_EQ(study.model.training_count(), 950);
    EXPECT_EQ(study.validation.size(), 50U);
    EXPECT_LT(study.data.with_slack(), 50);

    const LengthErrors& errors = study.as_in_paper().errors;
    EXPECT_LE(errors.mse, 2.5e-8);
    EXPECT_GE(errors.mse, 1e-9);
    EXPECT_LE(errors.mrse, 0.003);
    // The paper's errors have means that are small beside their standard deviations.
    EXPECT_LT(errors.mean_max_abs(), errors.std_mean());
    EXPECT_GE(study.as_in_paper().coverage, 0.93);
    EXPECT_LE(study.as_in_paper().coverage, 0.97);

    EXPECT_EQ(study.as_in_paper().forms_not_converged, 0);
    EXPECT_GE(study.mean_form_errors.nominal.mean, 4e-3);
    EXPECT_LE(study.mean_form_errors.nominal.mean, 6e-3);
    EXPECT_LE(study.mean_form_errors.identified.mean, 0.08 * study.mean_form_errors.nominal.mean);
    EXPECT_GE(study.form_errors.nominal.mean, 4e-3);
    EXPECT_LE(study.form_errors.nominal.mean, 6e-3);
    EXPECT_LE(study.form_errors.identified.mean, 0.08 * study.form_errors.nominal.mean);
}

}  // namespace
