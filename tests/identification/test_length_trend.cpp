// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against intervals that are too narrow where lengths are wrong together: all by the same,
// or each cable by a scale of its own.

#include <gtest/gtest.h>

#include <random>

#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/net/cable_runs.hpp"

namespace {

using namespace taut;

constexpr int surveys = 8;
const LengthPrior prior{LengthPrior::Kind::uniform, 2e-3};

struct Coverage {
    double lengths = 0.0;
    double tensions = 0.0;    ///< of those reported
    double mean_error = 0.0;  ///< of the common mean, root mean square, in its standard deviations
};

/// Of 95 % intervals, with the prior given as the prior that the lengths follow apart from what is
/// altered.
/// @param given the net that is identified, which is built as `net`
template <class Alter>
Coverage coverage(const CableNet& net, const CableNet& given, const IdentifyOptions& options,
                  double mean, const Alter& alter) {
    Coverage result;
    size_t drawn = 0;
    for (int seed = 0; seed < surveys; ++seed) {
        const auto s =
            test::simulate(net, *options.prior, 5e-4, static_cast<std::uint64_t>(seed),
                           [&](Eigen::VectorXd& d) { alter(d, static_cast<unsigned>(seed)); });
        const Identification found = test::identify_lengths(given, s.survey, options);
        result.lengths += test::coverage(found, s.deviations) / surveys;
        drawn += found.drawn.tensions.size();
        result.tensions += test::tensions_held(found, test::true_tensions(net, s));
        const CommonDeviation& common = found.prior.common;
        result.mean_error += std::pow((common.mean - mean) / common.mean_std, 2);
    }
    result.tensions /= static_cast<double>(drawn);
    result.mean_error = std::sqrt(result.mean_error / surveys);
    return result;
}

template <class Alter>
Coverage coverage(const CableNet& net, bool prior_exact, double mean, const Alter& alter) {
    return coverage(net, net, {.prior = prior, .prior_exact = prior_exact, .draws = 100}, mean,
                    alter);
}

TEST(LengthTrend, IntervalsHoldWhereAllLengthsAreWrongByTheSame) {
    const CableNet net = hypar(7, 7);
    constexpr double mean = 0.7e-3;
    const auto longer = [=](Eigen::VectorXd& d, unsigned) { d.array() += mean; };
    const Coverage with = coverage(net, false, mean, longer);
    EXPECT_GT(with.lengths, 0.92);
    EXPECT_GT(with.tensions, 0.90);
    EXPECT_LT(with.mean_error, 2.0);
    // What a prior without trend misses.
    EXPECT_LT(coverage(net, true, mean, longer).tensions, with.tensions);
}

// Turnbuckles that were all read alike, twice as far off as taut assumes of each.
TEST(LengthTrend, IntervalsHoldWhereAllTurnbucklesAreOffByTheSame) {
    const CableNet net = hypar(7, 7);
    CableNetData data = net.data();
    for (const int edge : net.adjustable_edges()) {
        data.unstressed_lengths(edge) += 1e-3;
    }
    const auto as_cut = [](Eigen::VectorXd&, unsigned) {};
    for (const double width : {2e-3, 6e-3}) {  // the wider hides it from the survey, (considered)
        const IdentifyOptions options{.prior = LengthPrior{LengthPrior::Kind::uniform, width},
                                      .assume_site = true,
                                      .draws = 100};
        const Coverage with = coverage(CableNet(data), net, options, 0.0, as_cut);
        EXPECT_GT(with.lengths, 0.90) << width;
        EXPECT_GT(with.tensions, 0.90) << width;
    }
}

TEST(LengthTrend, IntervalsHoldWhereEachCableHasAScaleOfItsOwn) {
    const CableNet net = hypar(7, 7);
    const auto scaled = [&](Eigen::VectorXd& d, unsigned seed) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> scale(0.0, 0.005);
        Eigen::VectorXd of_edges = Eigen::VectorXd::Zero(net.edge_count());
        for (const std::vector<int>& run : cable_runs(net)) {
            of_edges(run).setConstant(scale(random));
        }
        d += of_edges.cwiseProduct(net.unstressed_lengths())(net.interior_edges());
    };
    const Coverage with = coverage(net, false, 0.0, scaled);
    EXPECT_GT(with.lengths, 0.88);
    EXPECT_GT(with.tensions, 0.88);
    const Coverage without = coverage(net, true, 0.0, scaled);
    EXPECT_LT(without.tensions, with.tensions);
}

TEST(LengthTrend, DoesNotStandForAPriorThatIsFarTooNarrow) {
    const CableNet net = hypar(5, 5);
    const LengthPrior wide{LengthPrior::Kind::uniform, 3e-3};
    const LengthPrior narrow{LengthPrior::Kind::uniform, 2e-4};
    for (int seed = 0; seed < 3; ++seed) {
        const auto s = test::simulate(net, wide, 5e-4, static_cast<std::uint64_t>(seed));
        const Identification found = test::identify_lengths(
            net, s.survey, {.prior = narrow, .assume_site = true, .draws = 20});
        EXPECT_NE(found.trust.verdict(), Trust::Verdict::passed) << seed;
    }
}

}  // namespace
