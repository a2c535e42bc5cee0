// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/length_tests.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "estimation/detectable_error.hpp"
#include "estimation/length_likelihoods.hpp"
#include "net/sliding_nodes.hpp"
#include "taut/net/cable_runs.hpp"

namespace taut {
namespace {
using Test = Hypothesis::Test;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Where the density of a prior begins to fall, and the standard deviation of its fall.
struct Core {
    double end = 0.0;
    double fall = 0.0;
};

Core core_of(const LengthPrior& prior) {
    const double end = prior.kind == LengthPrior::Kind::normal ? 0.0 : prior.scale;
    return {.end = end,
            .fall = std::sqrt(std::max(0.0, prior.std_dev() * prior.std_dev() - end * end))};
}

/// W_b of (length-snooping).
double core_statistic(double deviation, const Core& core, double variance) {
    const double outside = std::max(0.0, std::abs(deviation) - core.end);
    return outside * outside / (core.fall * core.fall + variance);
}

/// A pair in terms of its two edges.
struct Both {
    Eigen::Vector2d prior_variances;  ///< [m2]
    Core core;                        ///< of the difference of their deviations
};

Both both_of(const Hypothesis& pair, const std::vector<LengthPrior>& priors) {
    const LengthPrior& one = priors[pair.index];
    const LengthPrior& other = priors[pair.other];
    const auto [end, fall] = core_of(one);
    const auto [other_end, other_fall] = core_of(other);
    return {.prior_variances = {one.std_dev() * one.std_dev(), other.std_dev() * other.std_dev()},
            .core = {.end = end + other_end, .fall = std::hypot(fall, other_fall)}};
}

/// Adds the pairs of edges at each free node whose priors are of similar width.
void add_pairs(std::vector<Hypothesis>& all, const CableNet& net,
               const std::vector<LengthPrior>& priors) {
    constexpr double alike = 2.0;
    // Nodes with more edges are hubs, where no clamp slips.
    constexpr size_t most_edges_at_node = 8;
    std::vector<int> run_of(net.edge_count(), -1);
    const std::vector<std::vector<int>> runs = cable_runs(net);
    for (size_t k = 0; k < runs.size(); ++k) {
        for (const int edge : runs[k]) {
            run_of[edge] = static_cast<int>(k);
        }
    }
    std::vector<std::vector<int>> at(net.node_count());
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        for (const int node : net.edges()[net.interior_edges()[i]]) {
            at[node].push_back(i);
        }
    }
    const auto far_end = [&](int i, int node) {
        const auto [s, t] = net.edges()[net.interior_edges()[i]];
        return s == node ? t : s;
    };
    const auto slides = [&](int i, int j) {
        return std::ranges::any_of(net.sliding_nodes(), [&](const SlidingNode& one) {
            return std::minmax(one.before, one.after) == std::minmax(i, j);
        });
    };
    for (const int node : net.free_nodes()) {
        for (size_t a = 0; at[node].size() <= most_edges_at_node && a < at[node].size(); ++a) {
            for (size_t b = a + 1; b < at[node].size(); ++b) {
                const int i = at[node][a];
                const int j = at[node][b];
                const double ratio = priors[i].std_dev() / priors[j].std_dev();
                if (slides(net.interior_edges()[i], net.interior_edges()[j])) {
                    continue;  // what passes between them is a parameter
                }
                if (ratio < alike && alike * ratio > 1.0) {
                    const int run = run_of[net.interior_edges()[i]];
                    all.push_back(
                        {.kind = Suspect::pair,
                         .index = i,
                         .other = j,
                         .is_of_one_run = run >= 0 && run == run_of[net.interior_edges()[j]],
                         .nodes = {node, far_end(i, node), far_end(j, node)}});
                }
            }
        }
    }
}

struct Estimate {
    double mean = 0.0;
    double std_dev = infinite;  ///< infinite: not known

    [[nodiscard]] bool is_known() const { return std::isfinite(std_dev); }
    [[nodiscard]] double variance() const { return std_dev * std_dev; }
};

/// The deviation to test. Of an edge that may be slack only a lower bound is known: it is no
/// shorter than it would be if it were taut. So it is tested for being too long alone.
Estimate tested_deviation(const LengthLikelihood& likelihood) {
    const bool is_slack = likelihood.extension == -infinite;
    const Estimate known = is_slack ? Estimate{likelihood.slack_from, likelihood.slack_from_std}
                                    : Estimate{likelihood.mean, likelihood.std_dev};
    return likelihood.extension < surely_taut_extension && known.mean <= 0.0 ? Estimate() : known;
}

/// (length-snooping)
void test_length(Hypothesis& length, const LengthPrior& prior, const LengthLikelihood& likelihood) {
    const Estimate tested = tested_deviation(likelihood);
    const Estimate found =
        tested.is_known() ? tested : Estimate{likelihood.mean, likelihood.std_dev};
    length.is_lower_bound = likelihood.extension < surely_taut_extension;
    length.deviation(0) = found.mean;
    length.covariance(0, 0) = found.variance();
    length.statistic = 0.0;
    length.core_statistic = 0.0;
    if (tested.is_known()) {
        length.statistic =
            tested.mean * tested.mean / (prior.std_dev() * prior.std_dev() + tested.variance());
        length.core_statistic = core_statistic(tested.mean, core_of(prior), tested.variance());
    }
}

/// (swap)
/// @param difference deviation of the first edge if each has the other's length [m]
/// @param scatter of both deviations and their priors [m2]
bool is_swap(const Hypothesis& pair, double difference, const Eigen::Matrix2d& scatter) {
    constexpr double by_chance = 13.8;  // chi-squared of two degrees of freedom, once in 1,000
    const Eigen::Vector2d misfit =
        pair.deviation.head<2>() - Eigen::Vector2d(difference, -difference);
    return misfit.dot(scatter.inverse() * misfit) < by_chance;
}

/// The tests of pairs at a fit.
struct PairTests {
    const CableNet& net;
    const std::vector<LengthPrior>& priors;
    const std::vector<LengthLikelihood>& likelihoods;
    const Observations& observations;
    const Iterate& fitted;

    [[nodiscard]] double estimated_statistic(const Hypothesis& pair) const;
    [[nodiscard]] bool take_estimate(Hypothesis& pair, const Eigen::Matrix2d& covariance,
                                     const Eigen::Vector2d& unseen) const;
    void take(Hypothesis& pair, const Eigen::Matrix2d& covariance,
              const Eigen::Vector2d& unseen) const;
};

/// About the largest statistic of a pair, from the estimates of its edges alone; negative: not
/// known.
double PairTests::estimated_statistic(const Hypothesis& pair) const {
    const Estimate one = tested_deviation(likelihoods[pair.index]);
    const Estimate other = tested_deviation(likelihoods[pair.other]);
    if (!one.is_known() || !other.is_known()) {
        return -1.0;
    }
    const Both both = both_of(pair, priors);
    const Eigen::Vector2d scatter =
        both.prior_variances + Eigen::Vector2d(one.variance(), other.variance());
    const double gradient = one.mean / scatter(0) - other.mean / scatter(1);
    return std::max(
        gradient * gradient / scatter.cwiseInverse().sum(),
        core_statistic(one.mean - other.mean, both.core, one.variance() + other.variance()));
}

/// Takes both deviations by the survey alone.
/// @param covariance of both lengths, posterior [m2]
/// @param unseen variances that no survey shows, LawBlur::length_variances() [m2]
/// @return whether the survey shows both
bool PairTests::take_estimate(Hypothesis& pair, const Eigen::Matrix2d& covariance,
                              const Eigen::Vector2d& unseen) const {
    const std::array<Eigen::Index, 2> both{pair.index, pair.other};
    const auto is_slack = [&](Eigen::Index edge) {
        return likelihoods[edge].extension == -std::numeric_limits<double>::infinity();
    };
    if (is_slack(pair.index) || is_slack(pair.other)) {
        // Of a slack edge only the distance of its ends is known. An error of the node's place
        // makes one edge longer and the other shorter: the correlation is taken as -1.
        const Estimate one = tested_deviation(likelihoods[pair.index]);
        const Estimate other = tested_deviation(likelihoods[pair.other]);
        const Eigen::Vector2d against(one.std_dev, -other.std_dev);
        pair.deviation.head<2>() << one.mean, other.mean;
        pair.covariance.topLeftCorner<2, 2>() = against * against.transpose();
        return true;
    }
    const Eigen::Vector2d mean = observations.mean(both);
    const Eigen::Vector2d before = (observations.variance(both) + unseen).cwiseInverse();
    const Eigen::Matrix2d posterior = covariance.inverse();
    const Eigen::Matrix2d information = posterior - Eigen::Matrix2d(before.asDiagonal());
    // Relative to the prior information; below this it is rounding error.
    constexpr double rounding = 1e-6;
    const Eigen::Vector2d unit = before.cwiseSqrt().cwiseInverse();
    const Eigen::Matrix2d relative = unit.asDiagonal() * information * unit.asDiagonal();
    if (!(relative.determinant() > rounding) || !(relative.trace() > 0.0)) {
        return false;
    }
    const Eigen::Matrix2d inverse = information.inverse();
    pair.deviation.head<2>() =
        inverse * (posterior * fitted.deviations(both) - before.cwiseProduct(mean));
    pair.covariance.topLeftCorner<2, 2>() = inverse + Eigen::Matrix2d(unseen.asDiagonal());
    return true;
}

/// (slip)
void PairTests::take(Hypothesis& pair, const Eigen::Matrix2d& covariance,
                     const Eigen::Vector2d& unseen) const {
    if (!take_estimate(pair, covariance, unseen)) {
        return;
    }
    const Both both = both_of(pair, priors);
    const Eigen::Vector2d deviation = pair.deviation.head<2>();
    const Eigen::Matrix2d by_survey = pair.covariance.topLeftCorner<2, 2>();
    Eigen::Matrix2d scatter = by_survey;
    scatter.diagonal() += both.prior_variances;
    const auto length = [&](int i) { return net.unstressed_lengths()(net.interior_edges()[i]); };
    if (pair.is_of_one_run ? !is_slip(pair, priors)
                           : !is_swap(pair, length(pair.other) - length(pair.index), scatter)) {
        return;
    }
    const Eigen::Vector2d against(1.0, -1.0);
    const Eigen::Vector2d weights = scatter.inverse() * against;
    pair.statistic = std::pow(weights.dot(deviation), 2) / weights.dot(against);
    pair.core_statistic =
        core_statistic(against.dot(deviation), both.core, against.dot(by_survey * against));
}

/// The pairs to test with their covariance, which takes one solution an edge: the released ones,
/// and those that by the estimates of their edges are above a part of their threshold. The others
/// get the statistic 0.
std::vector<Hypothesis*> worth_a_look(Hypotheses& hypotheses, const PairTests& tests) {
    constexpr double part_of_threshold = 0.5;
    constexpr size_t most = 100;
    const std::vector<bool> released = hypotheses.released_lengths();
    std::vector<std::pair<double, Hypothesis*>> candidates;
    for (Hypothesis& pair : hypotheses.of(Suspect::pair)) {
        pair.test = pair.is_released() ? Test::released : Test::in_use;
        const double about = tests.estimated_statistic(pair);
        if (pair.state == Hypothesis::State::released_for_good ||
            (pair.is_released() && about < 0.0)) {
            continue;  // as it was when it was released
        }
        pair.statistic = 0.0;
        pair.core_statistic = 0.0;
        const bool is_free = !released[pair.index] && !released[pair.other];
        if (pair.is_released() || (is_free && about > part_of_threshold * pair.threshold)) {
            candidates.emplace_back(pair.is_released() ? infinite : about, &pair);
        }
    }
    std::ranges::sort(candidates, std::greater{}, [](const auto& one) { return one.first; });
    candidates.resize(std::min(candidates.size(), most));
    std::vector<Hypothesis*> result;
    std::ranges::transform(candidates, std::back_inserter(result),
                           [](const auto& one) { return one.second; });
    return result;
}

void test_pairs(const std::vector<Hypothesis*>& pairs, const PairTests& tests,
                const Linearisation& linearisation) {
    std::set<int> of_pairs;
    for (const Hypothesis* pair : pairs) {
        of_pairs.insert({pair->index, pair->other});
    }
    const std::vector<int> places(of_pairs.begin(), of_pairs.end());
    std::vector<int> edges(places.size());
    std::ranges::transform(places, edges.begin(),
                           [&](int i) { return tests.net.interior_edges()[i]; });
    const Eigen::MatrixXd covariance = linearisation.length_covariance(edges);
    const Eigen::VectorXd unseen =
        linearisation.model().blur.length_variances(tests.net.interior_edge_count());
    const auto place_of = [&](int i) {
        return std::ranges::lower_bound(places, i) - places.begin();
    };
    for (Hypothesis* pair : pairs) {
        const std::array<Eigen::Index, 2> both{place_of(pair->index), place_of(pair->other)};
        tests.take(*pair, covariance(both, both), {unseen(pair->index), unseen(pair->other)});
    }
}

/// (swap): marks the pairs of released edges of which each has the other's length.
void mark_swapped(std::vector<LengthOutlier>& outliers, const Hypotheses& hypotheses,
                  const CableNet& net, const std::vector<LengthPrior>& priors) {
    constexpr double apart = 5.0;   // standard deviations that the lengths differ by, at least
    constexpr double nearly = 3.0;  // standard deviations of the estimate and of the prior
    const double prior = std::ranges::max(priors, {}, &LengthPrior::std_dev).std_dev();
    const auto fits = [&](const LengthOutlier& outlier, double difference) {
        const double scatter = std::hypot(outlier.std_dev, prior);
        const double misfit = outlier.deviation - difference;
        const auto place = std::ranges::lower_bound(net.interior_edges(), outlier.edge) -
                           net.interior_edges().begin();
        const bool is_at_least = hypotheses.of(Suspect::length)[place].is_lower_bound;
        return std::abs(difference) > apart * scatter && misfit < nearly * scatter &&
               (is_at_least || misfit > -nearly * scatter);
    };
    for (LengthOutlier& one : outliers) {
        for (LengthOutlier& other : outliers) {
            const double difference =
                net.unstressed_lengths()(other.edge) - net.unstressed_lengths()(one.edge);
            if (one.edge != other.edge && (one.other < 0 || one.other == other.edge) &&
                (other.other < 0 || other.other == one.edge) && fits(one, difference) &&
                fits(other, -difference)) {
                one.other = other.edge;
                other.other = one.edge;
                one.is_swapped = true;
                other.is_swapped = true;
            }
        }
    }
}

}  // namespace

std::vector<Hypothesis> length_hypotheses(const CableNet& net,
                                          const std::vector<LengthPrior>& priors,
                                          double false_alarm_rate) {
    const double threshold = snooping_threshold(false_alarm_rate, priors.size(), 1);
    std::vector<Hypothesis> result;
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const auto [s, t] = net.edges()[net.interior_edges()[i]];
        result.push_back(
            {.kind = Suspect::length, .index = i, .nodes = {s, t, -1}, .threshold = threshold});
    }
    // Only the sum of a stretch that slides is determined: one of its edges stands for all, never
    // an adjustable one, which is known better.
    for (const std::vector<int>& stretch : sliding_stretches(net)) {
        const auto width = [&](int edge) {
            const int i = net.interior_index(edge);
            return i < 0 ? std::pair(0.0, 0.0)
                         : std::pair(priors[i].std_dev(), net.unstressed_lengths()(edge));
        };
        const int named = std::ranges::max(stretch, {}, width);
        for (const int edge : stretch) {
            if (const int i = net.interior_index(edge); i >= 0 && edge != named) {
                result[i].threshold = infinite;
            }
        }
    }
    if (std::isfinite(threshold)) {
        add_pairs(result, net, priors);
    }
    const size_t pairs = result.size() - priors.size();
    const double pair_threshold =
        snooping_threshold(false_alarm_rate, std::max<size_t>(1, pairs), 1);
    for (size_t k = priors.size(); k < result.size(); ++k) {
        result[k].threshold = pair_threshold;
    }
    return result;
}

void test_lengths(Hypotheses& hypotheses, const CableNet& net,
                  const std::vector<LengthPrior>& priors,
                  const std::vector<LengthLikelihood>& likelihoods,
                  const Linearisation& linearisation, const Observations& observations,
                  const Iterate& fitted) {
    const std::vector<bool> released = hypotheses.released_lengths();
    for (Hypothesis& length : hypotheses.of(Suspect::length)) {
        length.test = released[length.index] ? Test::released : Test::in_use;
        test_length(length, priors[length.index], likelihoods[length.index]);
    }
    const PairTests tests{net, priors, likelihoods, observations, fitted};
    test_pairs(worth_a_look(hypotheses, tests), tests, linearisation);
}

bool is_slip(const Hypothesis& pair, const std::vector<LengthPrior>& priors) {
    constexpr double nearly = 3.0;  // standard deviations of both, and of their priors
    const double scatter =
        std::sqrt(pair.covariance.trace() + both_of(pair, priors).prior_variances.sum());
    return pair.deviation(0) * pair.deviation(1) < 0.0 &&
           std::abs(pair.deviation.sum()) < nearly * scatter;
}

std::vector<LengthPrior> priors_with_released(const Hypotheses& hypotheses, const CableNet& net,
                                              const std::vector<LengthPrior>& priors) {
    // Standard deviation of a released edge's prior, in that of its own prior, and at most as a
    // part of its length: no cut is further off.
    constexpr double released_width = 20.0;
    constexpr double widest_part_of_length = 0.25;
    std::vector<LengthPrior> result = priors;
    const double wide =
        priors.empty()
            ? 0.0
            : released_width * std::ranges::max(priors, {}, &LengthPrior::std_dev).std_dev();
    const auto release = [&](const Hypothesis& hypothesis, int i, int k) {
        // Beside a rejected target the survey does not determine the edge: its prior is widened by
        // the deviation found with the target in use.
        const double std_dev = hypothesis.state == Hypothesis::State::released_for_good
                                   ? std::hypot(priors[i].std_dev(), hypothesis.deviation(k))
                                   : wide;
        const double length = net.unstressed_lengths()(net.interior_edges()[i]);
        result[i] = {LengthPrior::Kind::normal, std::min(std_dev, widest_part_of_length * length)};
    };
    for (const Suspect kind : {Suspect::length, Suspect::pair}) {
        for (const Hypothesis& hypothesis : hypotheses.of(kind)) {
            if (hypothesis.is_released()) {
                release(hypothesis, hypothesis.index, 0);
            }
            if (hypothesis.is_released() && hypothesis.is_pair()) {
                release(hypothesis, hypothesis.other, 1);
            }
        }
    }
    return result;
}

/// Found where W or W_b is above the threshold; never for an edge that may be slack.
double detectable_length(const Hypotheses& hypotheses, const CableNet& net,
                         const std::vector<LengthPrior>& priors, const std::vector<int>& edges) {
    std::vector<BoundedEstimate> estimates;
    for (const Hypothesis& length : hypotheses.of(Suspect::length)) {
        if (length.test != Test::in_use || !std::isfinite(length.threshold) ||
            !std::ranges::binary_search(edges, net.interior_edges()[length.index])) {
            continue;
        }
        const double variance = length.is_lower_bound ? infinite : length.covariance(0, 0);
        const double std_dev = priors[length.index].std_dev();
        const auto [end, fall] = core_of(priors[length.index]);
        const double scatter = std::sqrt(std_dev * std_dev + variance);
        estimates.push_back(
            {.bound = std::min(std::sqrt(length.threshold) * scatter,
                               end + std::sqrt(length.threshold * (fall * fall + variance))),
             .std_dev = scatter});
    }
    return detectable_error(estimates);
}

std::vector<LengthOutlier> length_outliers(const Hypotheses& hypotheses, const CableNet& net,
                                           const std::vector<LengthPrior>& priors) {
    std::vector<LengthOutlier> result;
    const auto add = [&](const Hypothesis& one, int i, int k) -> LengthOutlier& {
        return result.emplace_back(LengthOutlier{.edge = net.interior_edges()[i],
                                                 .deviation = one.deviation(k),
                                                 .std_dev = one.std_dev()(k),
                                                 .statistic = one.largest_statistic()});
    };
    for (const Hypothesis& one : hypotheses.found(Suspect::length)) {
        add(one, one.index, 0);
    }
    for (const Hypothesis& pair : hypotheses.found(Suspect::pair)) {
        for (const int k : {0, 1}) {
            LengthOutlier& outlier = add(pair, k == 0 ? pair.index : pair.other, k);
            outlier.other = net.interior_edges()[k == 0 ? pair.other : pair.index];
            outlier.node = pair.nodes[0];
            outlier.is_beside_target = pair.state == Hypothesis::State::released_for_good;
        }
    }
    std::ranges::stable_sort(result, std::greater{}, &LengthOutlier::statistic);
    mark_swapped(result, hypotheses, net, priors);
    return result;
}

}  // namespace taut
