// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a change anywhere on the way from the net to the lengths that makes the paper's
// experiment (section 5) come out worse than the paper's, or far better than is believable.

#include "taut/study/paper_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "study/error_sums.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"

namespace {

using namespace taut;

/// By which factor MSE and MRSE may differ from the paper's. Those of seeds 1 to 4 lie within 6 %
/// of each other; the rest is the other roof.
constexpr double of_lengths = 1.4;

/// A number of the paper beside ours.
struct Figure {
    std::string name;
    double paper;
    double here;                  ///< mean over the validation samples
    std::vector<double> samples;  ///< of each of them
    double factor;                ///< by which `here` may differ from the paper's
};

/// The paper's table "Error Statistics" beside the form errors of all validation samples, each
/// found anew by an equilibrium of the identified lengths.
std::vector<Figure> error_statistics(const Study& study, const PaperFigures& paper) {
    const CableNet& net = study.net;
    std::vector<FormErrorSummary> nominal;
    std::vector<FormErrorSummary> identified;
    EquilibriumSolver solver(net);
    for (size_t k = 0; k < study.validation.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        const Eigen::VectorXd truth =
            study.data.nominal_form + study.data.form_deviations.col(study.validation[k]);
        const Equilibrium predicted = solver.solve(
            with_length_deviations(net, study.estimates.mean.col(column)), net.nodes());
        nominal.push_back(summarise(node_distances(truth, study.data.nominal_form)));
        identified.push_back(
            summarise(node_distances(truth, free_coordinates(net, predicted.form))));
    }
    // Both nets have 300 free nodes, edges of some 130 mm and the same prior, so that the errors'
    // size is the same but for the shape of the roof: by a sixth. The smallest of 300 distances
    // is a matter of chance: it is that of one node, which varies as the distance of a point in
    // three dimensions, not as a mean.
    constexpr double of_many = 1.17;
    constexpr double of_one = 2.0;
    std::vector<Figure> figures;
    const auto add = [&](const std::string& name, double FormErrorSummary::* number,
                         double factor) {
        const auto add_one = [&](const std::string& which, double of_paper, double here,
                                 const std::vector<FormErrorSummary>& all) {
            Figure figure{.name = which + name,
                          .paper = of_paper,
                          .here = here,
                          .samples = {},
                          .factor = factor};
            for (const FormErrorSummary& one : all) {
                figure.samples.push_back(one.*number);
            }
            figures.push_back(figure);
        };
        add_one("nominal ", paper.form_errors.nominal.*number,
                study.mean_form_errors.nominal.*number, nominal);
        add_one("identified ", paper.form_errors.identified.*number,
                study.mean_form_errors.identified.*number, identified);
    };
    add("max", &FormErrorSummary::max, of_many);
    add("min", &FormErrorSummary::min, of_one);
    add("mean", &FormErrorSummary::mean, of_many);
    add("RMSE", &FormErrorSummary::rmse, of_many);
    return figures;
}

void expect_within_a_factor(const std::string& name, double here, double paper, double factor) {
    EXPECT_GE(here, paper / factor) << name;
    EXPECT_LE(here, paper * factor) << name;
}

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
    expect_within_a_factor("MSE", errors.mse, paper.mse, of_lengths);
    expect_within_a_factor("MRSE", errors.mrse, paper.mrse, of_lengths);
    // The paper's errors have means that are small beside their standard deviations.
    EXPECT_LT(errors.mean_max_abs(), errors.std_mean());
    EXPECT_GE(study.as_in_paper().coverage, 0.93);
    EXPECT_LE(study.as_in_paper().coverage, 0.97);

    EXPECT_EQ(study.as_in_paper().forms_not_converged, 0);
    for (const Figure& figure : error_statistics(study, paper)) {
        const auto [lowest, highest] = std::ranges::minmax(figure.samples);
        const double mean = std::accumulate(figure.samples.begin(), figure.samples.end(), 0.0) /
                            static_cast<double>(figure.samples.size());
        EXPECT_NEAR(figure.here, mean, 1e-9) << figure.name;
        expect_within_a_factor(figure.name, figure.here, figure.paper, figure.factor);
        // The paper's one sample might be one of ours.
        EXPECT_LE(lowest, figure.paper) << figure.name;
        EXPECT_GE(highest, figure.paper) << figure.name;
    }
    EXPECT_GE(study.form_errors.nominal.mean, 4e-3);
    EXPECT_LE(study.form_errors.nominal.mean, 6e-3);
    EXPECT_LE(study.form_errors.identified.mean, 0.08 * study.form_errors.nominal.mean);
    EXPECT_LE(study.mean_form_errors.identified.mean, 0.08 * study.mean_form_errors.nominal.mean);
}

}  // namespace
