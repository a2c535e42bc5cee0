// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/length_snooping.hpp"

#include <Eigen/LU>
#include <array>
#include <functional>
#include <limits>
#include <utility>

#include "estimation/comparable_scores.hpp"
#include "estimation/data_snooping.hpp"
#include "estimation/detectable_error.hpp"
#include "estimation/length_likelihoods.hpp"
#include "taut/net/cable_runs.hpp"

namespace taut {
namespace {

/// More outliers than this part of the edges, and than a few, mean that the prior is wrong.
constexpr double most_released = 0.1;
constexpr int a_few = 3;

/// Standard deviation of a released edge's prior, in that of its own prior, and at most as a part
/// of its length: no cut is further off.
constexpr double released_width = 20.0;
constexpr double widest_part_of_length = 0.25;

/// Nodes with more edges are hubs, where no clamp slips.
constexpr size_t most_edges_at_node = 8;

/// Pairs are screened by the estimates of their edges. Those above this part of their threshold are
/// tested with their covariance, which takes one solution an edge.
constexpr double worth_a_look = 0.5;
constexpr size_t most_looked_at = 100;

struct Estimate {
    double mean = 0.0;
    double std = std::numeric_limits<double>::infinity();  ///< infinite: not known
};

/// The deviation to test. Of an edge that may be slack only a lower bound is known: it is no
/// shorter than it would be if it were taut. So it is tested for being too long alone.
Estimate tested_deviation(const LengthLikelihood& likelihood) {
    const bool is_slack = likelihood.extension == -std::numeric_limits<double>::infinity();
    const Estimate known = is_slack ? Estimate{likelihood.slack_from, likelihood.slack_from_std}
                                    : Estimate{likelihood.mean, likelihood.std};
    return likelihood.extension < surely_taut_extension && known.mean <= 0.0 ? Estimate() : known;
}

/// Where the density of a prior begins to fall, and the standard deviation of its fall.
struct Core {
    double end = 0.0;
    double fall = 0.0;
};

Core core_of(const LengthPrior& prior) {
    switch (prior.kind) {
        case LengthPrior::Kind::uniform:
            return {.end = prior.scale, .fall = 0.0};
        case LengthPrior::Kind::normal:
            return {.end = 0.0, .fall = prior.scale};
        case LengthPrior::Kind::bimodal:
            return {.end = prior.scale,
                    .fall = std::sqrt(prior.std() * prior.std() - prior.scale * prior.scale)};
    }
    return {};
}

/// W_b of (length-snooping).
double core_statistic(double deviation, const Core& core, double variance) {
    const double outside = std::max(0.0, std::abs(deviation) - core.end);
    return outside * outside / (core.fall * core.fall + variance);
}

/// The core of the difference of two deviations.
Core core_of_difference(const LengthPrior& one, const LengthPrior& other) {
    const auto [end, fall] = core_of(one);
    const auto [other_end, other_fall] = core_of(other);
    return {.end = end + other_end, .fall = std::hypot(fall, other_fall)};
}

}  // namespace

LengthSnooping::LengthSnooping(const CableNet& net, std::vector<LengthPrior> priors,
                               double false_alarm_rate)
    : m_net(net),
      m_priors(std::move(priors)),
      m_threshold(snooping_threshold(false_alarm_rate, m_priors.size(), 1)),
      m_released_std(released_width * std::ranges::max(m_priors, {}, &LengthPrior::std).std()) {
    for (Eigen::Index i = 0; i < std::ssize(m_priors); ++i) {
        m_suspects.push_back({.edge = i});
    }
    if (std::isfinite(m_threshold)) {
        add_pairs();
    }
    m_pair_threshold = snooping_threshold(
        false_alarm_rate, std::max<size_t>(1, m_suspects.size() - m_priors.size()), 1);
}

/// Adds the pairs of edges at each free node whose priors are of similar width: a cable may slip
/// between two of one run, and any two may have been swapped.
void LengthSnooping::add_pairs() {
    constexpr double alike = 2.0;
    std::vector<int> run_of(m_net.edge_count(), -1);
    const std::vector<std::vector<int>> runs = cable_runs(m_net);
    for (size_t k = 0; k < runs.size(); ++k) {
        for (const int edge : runs[k]) {
            run_of[edge] = static_cast<int>(k);
        }
    }
    std::vector<std::vector<Eigen::Index>> at(m_net.node_count());
    for (Eigen::Index i = 0; i < std::ssize(m_priors); ++i) {
        for (const int node : m_net.edges()[m_net.interior_edges()[i]]) {
            at[node].push_back(i);
        }
    }
    for (const int node : m_net.free_nodes()) {
        for (size_t a = 0; at[node].size() <= most_edges_at_node && a < at[node].size(); ++a) {
            for (size_t b = a + 1; b < at[node].size(); ++b) {
                const Eigen::Index i = at[node][a];
                const Eigen::Index j = at[node][b];
                const double ratio = m_priors[i].std() / m_priors[j].std();
                if (ratio < alike && alike * ratio > 1.0) {
                    const int run = run_of[m_net.interior_edges()[i]];
                    const bool is_of_one_run = run >= 0 && run == run_of[m_net.interior_edges()[j]];
                    m_suspects.push_back(
                        {.edge = i, .other = j, .node = node, .is_of_one_run = is_of_one_run});
                }
            }
        }
    }
}

void LengthSnooping::evaluate(const std::vector<LengthLikelihood>& likelihoods,
                              const LinearisedStatics& statics, const Observations& observations,
                              const Iterate& fitted) {
    m_likelihoods = likelihoods;
    for (size_t i = 0; i < m_priors.size(); ++i) {
        evaluate_one(m_suspects[i]);
    }
    evaluate_pairs(statics, observations, fitted);
}

void LengthSnooping::evaluate_one(LengthSuspect& suspect) const {
    suspect.statistic = 0.0;
    suspect.core_statistic = 0.0;
    const Estimate found = tested_deviation(m_likelihoods[suspect.edge]);
    const double variance = found.std * found.std;
    if (std::isfinite(variance)) {
        const LengthPrior& prior = m_priors[suspect.edge];
        suspect.statistic = found.mean * found.mean / (prior.std() * prior.std() + variance);
        suspect.core_statistic = core_statistic(found.mean, core_of(prior), variance);
    }
}

/// Whether a pair can be tested: both lengths are known, and neither edge is released by itself.
bool LengthSnooping::is_testable(const LengthSuspect& pair,
                                 const std::vector<bool>& released) const {
    const auto is_known = [&](Eigen::Index i) {
        return std::isfinite(tested_deviation(m_likelihoods[i]).std);
    };
    return is_known(pair.edge) && is_known(pair.other) &&
           (pair.is_released || (!released[pair.edge] && !released[pair.other]));
}

/// (slip)
void LengthSnooping::evaluate_pairs(const LinearisedStatics& statics,
                                    const Observations& observations, const Iterate& fitted) {
    const std::vector<bool> released = this->released();
    std::vector<std::pair<double, LengthSuspect*>> looked_at;
    for (size_t k = m_priors.size(); k < m_suspects.size(); ++k) {
        LengthSuspect& pair = m_suspects[k];
        if (pair.is_beside_target) {
            continue;  // as it was when the target was left out
        }
        const bool is_known = is_testable(pair, released);
        if (pair.is_released && !is_known) {
            continue;  // as it was when it was released
        }
        pair.statistic = 0.0;
        pair.core_statistic = 0.0;
        if (!is_known) {
            continue;
        }
        const Estimate one = tested_deviation(m_likelihoods[pair.edge]);
        const Estimate other = tested_deviation(m_likelihoods[pair.other]);
        const double one_scatter = std::pow(m_priors[pair.edge].std(), 2) + one.std * one.std;
        const double other_scatter =
            std::pow(m_priors[pair.other].std(), 2) + other.std * other.std;
        const double gradient = one.mean / one_scatter - other.mean / other_scatter;
        const double about =
            std::max(gradient * gradient / (1.0 / one_scatter + 1.0 / other_scatter),
                     core_statistic(one.mean - other.mean,
                                    core_of_difference(m_priors[pair.edge], m_priors[pair.other]),
                                    one.std * one.std + other.std * other.std));
        if (pair.is_released || about > worth_a_look * m_pair_threshold) {
            looked_at.emplace_back(
                pair.is_released ? std::numeric_limits<double>::infinity() : about, &pair);
        }
    }
    std::ranges::sort(looked_at, std::greater{}, [](const auto& one) { return one.first; });
    looked_at.resize(std::min(looked_at.size(), most_looked_at));
    std::vector<Eigen::Index> places;
    for (const auto& [about, pair] : looked_at) {
        places.insert(places.end(), {pair->edge, pair->other});
    }
    std::ranges::sort(places);
    places.erase(std::ranges::unique(places).begin(), places.end());
    std::vector<int> edges(places.size());
    std::ranges::transform(places, edges.begin(),
                           [this](Eigen::Index i) { return m_net.interior_edges()[i]; });
    const Eigen::MatrixXd covariance = statics.length_covariance(edges);
    const Eigen::VectorXd unseen = statics.blur().length_variances(m_net.interior_edge_count());
    const auto place_of = [&](Eigen::Index i) {
        return std::ranges::lower_bound(places, i) - places.begin();
    };
    for (const auto& [about, pair] : looked_at) {
        const std::array<Eigen::Index, 2> both{place_of(pair->edge), place_of(pair->other)};
        take_pair(*pair, covariance(both, both), {unseen(pair->edge), unseen(pair->other)},
                  observations, fitted);
    }
}

/// @param covariance of both lengths, posterior [m2]
/// @param unseen variances that no survey shows, LawBlur::length_variances() [m2]
void LengthSnooping::take_pair(LengthSuspect& pair, const Eigen::Matrix2d& covariance,
                               const Eigen::Vector2d& unseen, const Observations& observations,
                               const Iterate& fitted) const {
    const std::array<Eigen::Index, 2> both{pair.edge, pair.other};
    const Estimate one = tested_deviation(m_likelihoods[pair.edge]);
    const Estimate other = tested_deviation(m_likelihoods[pair.other]);
    Eigen::Matrix2d survey_covariance;
    if (std::isinf(m_likelihoods[pair.edge].extension) ||
        std::isinf(m_likelihoods[pair.other].extension)) {
        // Of a slack edge only the distance of its ends is known. An error of the node's place
        // makes one edge longer and the other shorter: the correlation is taken as -1.
        pair.deviation = {one.mean, other.mean};
        const double covariance_at_most = one.std * other.std;
        survey_covariance << one.std * one.std, -covariance_at_most, -covariance_at_most,
            other.std * other.std;
    } else {
        const Eigen::Vector2d mean = observations.mean(both);
        const Eigen::Vector2d before = (observations.variance(both) + unseen).cwiseInverse();
        const Eigen::Matrix2d posterior = covariance.inverse();
        const Eigen::Matrix2d information = posterior - Eigen::Matrix2d(before.asDiagonal());
        // Relative to the prior information; below this it is rounding error.
        constexpr double rounding = 1e-6;
        const Eigen::Vector2d unit = before.cwiseSqrt().cwiseInverse();
        const Eigen::Matrix2d relative = unit.asDiagonal() * information * unit.asDiagonal();
        if (!(relative.determinant() > rounding) || !(relative.trace() > 0.0)) {
            return;
        }
        const Eigen::Matrix2d inverse = information.inverse();
        survey_covariance = inverse + Eigen::Matrix2d(unseen.asDiagonal());
        pair.deviation =
            inverse * (posterior * fitted.deviations(both) - before.cwiseProduct(mean));
    }
    pair.std = survey_covariance.diagonal().cwiseSqrt();
    Eigen::Matrix2d scatter = survey_covariance;
    scatter.diagonal() += Eigen::Vector2d(std::pow(m_priors[pair.edge].std(), 2),
                                          std::pow(m_priors[pair.other].std(), 2));
    if (pair.is_of_one_run ? !is_slip(pair) : !is_swap(pair, scatter)) {
        return;
    }
    const Eigen::Vector2d against(1.0, -1.0);
    const Eigen::Vector2d weights = scatter.inverse() * against;
    pair.statistic = std::pow(weights.dot(pair.deviation), 2) / weights.dot(against);
    pair.core_statistic =
        core_statistic(pair.deviation(0) - pair.deviation(1),
                       core_of_difference(m_priors[pair.edge], m_priors[pair.other]),
                       against.dot(survey_covariance * against));
}

/// Deviation of the first edge of a pair if each has the other's length [m].
double LengthSnooping::swapped_difference(const LengthSuspect& pair) const {
    const auto length = [this](Eigen::Index i) {
        return m_net.unstressed_lengths()(m_net.interior_edges()[i]);
    };
    return length(pair.other) - length(pair.edge);
}

/// (swap)
bool LengthSnooping::is_swap(const LengthSuspect& pair, const Eigen::Matrix2d& scatter) const {
    constexpr double by_chance = 13.8;  // chi-squared of two degrees of freedom, once in 1,000
    const double difference = swapped_difference(pair);
    const Eigen::Vector2d misfit = pair.deviation - Eigen::Vector2d(difference, -difference);
    return misfit.dot(scatter.inverse() * misfit) < by_chance;
}

double LengthSnooping::score_of(const LengthSuspect& suspect) const {
    return comparable_score(suspect.statistic, threshold_of(suspect));
}

std::vector<int> LengthSnooping::nodes_of(const LengthSuspect& suspect) const {
    const Edge& one = m_net.edges()[m_net.interior_edges()[suspect.edge]];
    std::vector<int> nodes(one.begin(), one.end());
    if (suspect.is_pair()) {
        const Edge& other = m_net.edges()[m_net.interior_edges()[suspect.other]];
        nodes.insert(nodes.end(), other.begin(), other.end());
    }
    return nodes;
}

Eigen::VectorXd LengthSnooping::scores() const {
    Eigen::VectorXd scores = Eigen::VectorXd::Zero(m_net.node_count());
    if (!is_active()) {
        return scores;
    }
    const std::vector<bool> released = this->released();
    for (const LengthSuspect& suspect : m_suspects) {
        const double own = score_of(suspect);
        if (own <= 0.0 || suspect.is_readmitted || released[suspect.edge] ||
            (suspect.is_pair() && released[suspect.other])) {
            continue;
        }
        for (const int node : nodes_of(suspect)) {
            scores(node) = std::max(scores(node), own);
        }
    }
    return scores;
}

bool LengthSnooping::may_release(const LengthSuspect& suspect,
                                 const std::vector<bool>& released) const {
    return !suspect.is_readmitted && !released[suspect.edge] &&
           !(suspect.is_pair() && released[suspect.other]) && is_outlier(suspect);
}

bool LengthSnooping::release(const Eigen::VectorXd& other_scores) {
    if (!is_active()) {
        return false;
    }
    std::vector<bool> released = this->released();
    const Eigen::VectorXd nearby = largest_nearby(m_net, scores().cwiseMax(other_scores));
    Eigen::VectorXd core = Eigen::VectorXd::Zero(m_net.node_count());
    for (const LengthSuspect& suspect : m_suspects) {
        if (may_release(suspect, released)) {
            for (const int node : nodes_of(suspect)) {
                core(node) = std::max(core(node), suspect.core_statistic);
            }
        }
    }
    const Eigen::VectorXd core_nearby = largest_nearby(m_net, core);
    bool has_changed = false;
    for (LengthSuspect& suspect : m_suspects) {
        if (!may_release(suspect, released)) {
            continue;
        }
        const double own = score_of(suspect);
        const auto stands_out = [&](int node) {
            // A normal prior tolerates what a bounded one does not: where nothing nearby exceeds
            // its threshold by the normal statistic, the largest core statistic decides.
            return own >= nearby(node) ||
                   (nearby(node) < 1.0 && suspect.core_statistic >= core_nearby(node));
        };
        if (std::ranges::all_of(nodes_of(suspect), stands_out)) {
            suspect.is_released = true;
            released[suspect.edge] = true;
            if (suspect.is_pair()) {
                released[suspect.other] = true;
            }
            has_changed = true;
        }
    }
    return has_changed;
}

std::vector<size_t> LengthSnooping::pairs_at(int node) const {
    std::vector<bool> in_pairs(m_priors.size(), false);
    for (const LengthSuspect& suspect : m_suspects) {
        if (suspect.is_pair() && suspect.is_released) {
            in_pairs[suspect.edge] = true;
            in_pairs[suspect.other] = true;
        }
    }
    std::vector<size_t> result;
    for (size_t k = m_priors.size(); k < m_suspects.size(); ++k) {
        const LengthSuspect& pair = m_suspects[k];
        const bool is_free = pair.is_released || (!in_pairs[pair.edge] && !in_pairs[pair.other]);
        if (pair.node == node && pair.is_of_one_run && is_free) {
            result.push_back(k);
        }
    }
    return result;
}

void LengthSnooping::set_pair(size_t place, bool is_released) {
    LengthSuspect& pair = m_suspects[place];
    pair.is_released = is_released;
    m_suspects[pair.edge].is_released = false;
    m_suspects[pair.other].is_released = false;
}

bool LengthSnooping::is_slip(const LengthSuspect& pair) const {
    constexpr double nearly = 3.0;  // standard deviations of both, and of their priors
    const double scatter =
        std::sqrt(pair.std.squaredNorm() + std::pow(m_priors[pair.edge].std(), 2) +
                  std::pow(m_priors[pair.other].std(), 2));
    return pair.deviation(0) * pair.deviation(1) < 0.0 &&
           std::abs(pair.deviation.sum()) < nearly * scatter;
}

bool LengthSnooping::readmit() {
    bool has_changed = false;
    for (LengthSuspect& suspect : m_suspects) {
        if (suspect.is_released && !suspect.is_beside_target && !is_outlier(suspect)) {
            suspect.is_released = false;
            suspect.is_readmitted = true;
            has_changed = true;
        }
    }
    return has_changed;
}

void LengthSnooping::readmit_all() {
    for (LengthSuspect& suspect : m_suspects) {
        suspect.is_released = false;
        suspect.is_beside_target = false;
    }
}

void LengthSnooping::reopen() {
    for (LengthSuspect& suspect : m_suspects) {
        suspect.is_readmitted = false;
    }
}

std::vector<bool> LengthSnooping::released() const {
    std::vector<bool> result(m_priors.size(), false);
    for (const LengthSuspect& suspect : m_suspects) {
        if (suspect.is_released) {
            result[suspect.edge] = true;
            if (suspect.is_pair()) {
                result[suspect.other] = true;
            }
        }
    }
    return result;
}

int LengthSnooping::released_count() const {
    return static_cast<int>(std::ranges::count(m_suspects, true, &LengthSuspect::is_released));
}

bool LengthSnooping::releases_too_many() const {
    return released_count() >
           std::max<double>(a_few, most_released * static_cast<double>(m_priors.size()));
}

std::vector<LengthPrior> LengthSnooping::priors() const {
    std::vector<LengthPrior> result = m_priors;
    const auto widen = [&](Eigen::Index i, double std) {
        const double length = m_net.unstressed_lengths()(m_net.interior_edges()[i]);
        result[i] = {LengthPrior::Kind::normal, std::min(std, widest_part_of_length * length)};
    };
    for (const LengthSuspect& suspect : m_suspects) {
        if (!suspect.is_released) {
            continue;
        }
        // Beside a rejected target the survey does not determine the edge: its prior is widened by
        // the deviation found with the target in use.
        const auto width = [&](Eigen::Index i, int k) {
            return suspect.is_beside_target ? std::hypot(m_priors[i].std(), suspect.deviation(k))
                                            : m_released_std;
        };
        widen(suspect.edge, width(suspect.edge, 0));
        if (suspect.is_pair()) {
            widen(suspect.other, width(suspect.other, 1));
        }
    }
    return result;
}

double LengthSnooping::released_cost() const {
    double cost = 0.0;
    for (const LengthSuspect& suspect : m_suspects) {
        // A pair beside a target costs nothing more than the target.
        if (suspect.is_released && !suspect.is_beside_target) {
            cost += threshold_of(suspect);
        }
    }
    return cost;
}

double LengthSnooping::detectable(const std::vector<int>& edges) const {
    if (!is_active()) {
        return std::numeric_limits<double>::infinity();
    }
    const std::vector<bool> released = this->released();
    std::vector<BoundedEstimate> estimates;
    for (size_t i = 0; i < m_likelihoods.size(); ++i) {
        if (released[i] || !std::ranges::binary_search(edges, m_net.interior_edges()[i])) {
            continue;
        }
        // Found where W or W_b is above the threshold; never for an edge that may be slack.
        const bool is_tested = m_likelihoods[i].extension >= surely_taut_extension;
        const double variance = is_tested ? m_likelihoods[i].std * m_likelihoods[i].std
                                          : std::numeric_limits<double>::infinity();
        const double std = m_priors[i].std();
        const auto [end, fall] = core_of(m_priors[i]);
        const double scatter = std::sqrt(std * std + variance);
        estimates.push_back(
            {.bound = std::min(std::sqrt(m_threshold) * scatter,
                               end + std::sqrt(m_threshold * (fall * fall + variance))),
             .std = scatter});
    }
    return detectable_error(estimates);
}

std::vector<LengthOutlier> LengthSnooping::outliers() const {
    std::vector<LengthOutlier> result;
    for (const LengthSuspect& suspect : m_suspects) {
        if (!suspect.is_released || m_likelihoods.empty()) {
            continue;
        }
        const double statistic = std::max(suspect.statistic, suspect.core_statistic);
        const int edge = m_net.interior_edges()[suspect.edge];
        if (suspect.is_pair()) {
            const int other = m_net.interior_edges()[suspect.other];
            LengthOutlier outlier{.edge = edge,
                                  .deviation = suspect.deviation(0),
                                  .std = suspect.std(0),
                                  .statistic = statistic,
                                  .other = other,
                                  .node = suspect.node,
                                  .is_beside_target = suspect.is_beside_target};
            result.push_back(outlier);
            std::swap(outlier.edge, outlier.other);
            outlier.deviation = suspect.deviation(1);
            outlier.std = suspect.std(1);
            result.push_back(outlier);
            continue;
        }
        Estimate found = tested_deviation(m_likelihoods[suspect.edge]);
        if (!std::isfinite(found.std)) {
            found = {m_likelihoods[suspect.edge].mean, m_likelihoods[suspect.edge].std};
        }
        result.push_back(
            {.edge = edge, .deviation = found.mean, .std = found.std, .statistic = statistic});
    }
    std::ranges::stable_sort(result, std::greater{}, &LengthOutlier::statistic);
    mark_swapped(result);
    return result;
}

/// (swap): marks the pairs of released edges of which each has the other's length.
void LengthSnooping::mark_swapped(std::vector<LengthOutlier>& outliers) const {
    constexpr double apart = 5.0;   // standard deviations that the lengths differ by, at least
    constexpr double nearly = 3.0;  // standard deviations of the estimate and of the prior
    const double prior = std::ranges::max(m_priors, {}, &LengthPrior::std).std();
    const auto fits = [&](const LengthOutlier& outlier, double difference) {
        const double scatter = std::hypot(outlier.std, prior);
        const double misfit = outlier.deviation - difference;
        const auto place = std::ranges::lower_bound(m_net.interior_edges(), outlier.edge) -
                           m_net.interior_edges().begin();
        const bool is_at_least = m_likelihoods[place].extension < surely_taut_extension;
        return std::abs(difference) > apart * scatter && misfit < nearly * scatter &&
               (is_at_least || misfit > -nearly * scatter);
    };
    for (LengthOutlier& one : outliers) {
        for (LengthOutlier& other : outliers) {
            const double difference =
                m_net.unstressed_lengths()(other.edge) - m_net.unstressed_lengths()(one.edge);
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

}  // namespace taut
