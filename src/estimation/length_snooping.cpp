// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/length_snooping.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "estimation/detectable_error.hpp"
#include "estimation/rival_scores.hpp"

namespace taut {
namespace {

/// More edges beyond the law than this part, and than a few: the law is wrong.
constexpr double most_released = 0.1;
constexpr int a_few = 3;

/// Of a released edge's law, in standard deviations of its own.
constexpr double released_width = 20.0;
/// No cut is further off.
constexpr double widest_part_of_length = 0.25;

/// Of an edge that may be slack as well as taut a bound alone is known: it is no shorter than it
/// would be if it were taut. So it is tested for being too long alone.
constexpr double surely_taut = 4.0;  // standard deviations of the extension

struct Estimate {
    double mean = 0.0;
    double std = std::numeric_limits<double>::infinity();  ///< infinite: nothing is known
};

/// The deviation, or what it is at the least.
Estimate tested_deviation(const LengthLikelihood& told) {
    const bool is_slack = told.extension == -std::numeric_limits<double>::infinity();
    const Estimate known =
        is_slack ? Estimate{told.slack_from, told.slack_from_std} : Estimate{told.mean, told.std};
    return told.extension < surely_taut && known.mean <= 0.0 ? Estimate() : known;
}

/// Where the density of a law begins to fall, and the standard deviation by which it falls there.
struct Core {
    double end = 0.0;
    double fall = 0.0;
};

Core core_of(const LengthLaw& law) {
    switch (law.kind) {
        case LengthLaw::Kind::uniform:
            return {.end = law.scale, .fall = 0.0};
        case LengthLaw::Kind::normal:
            return {.end = 0.0, .fall = law.scale};
        case LengthLaw::Kind::bimodal:
            return {.end = law.scale,
                    .fall = std::sqrt(law.std() * law.std() - law.scale * law.scale)};
    }
    return {};
}

}  // namespace

LengthSnooping::LengthSnooping(const CableNet& net, std::vector<LengthLaw> laws, double threshold)
    : m_net(net),
      m_laws(std::move(laws)),
      m_threshold(threshold),
      m_released_std(released_width * std::ranges::max(m_laws, {}, &LengthLaw::std).std()),
      m_released(m_laws.size(), false),
      m_readmitted(m_laws.size(), false),
      m_statistics(Eigen::VectorXd::Zero(std::ssize(m_laws))),
      m_core_statistics(m_statistics) {}

void LengthSnooping::evaluate(const std::vector<LengthLikelihood>& told) {
    m_told = told;
    m_statistics.setZero();
    m_core_statistics.setZero();
    for (size_t i = 0; i < m_laws.size(); ++i) {
        const Estimate found = tested_deviation(m_told[i]);
        const double variance = found.std * found.std;
        if (!std::isfinite(variance)) {
            continue;
        }
        const auto k = static_cast<Eigen::Index>(i);
        const double std = m_laws[i].std();
        const auto [end, fall] = core_of(m_laws[i]);
        const double beyond = std::max(0.0, std::abs(found.mean) - end);
        m_statistics(k) = found.mean * found.mean / (std * std + variance);
        m_core_statistics(k) = beyond * beyond / (fall * fall + variance);
    }
}

/// (length-snooping)
bool LengthSnooping::is_beyond(size_t i) const {
    const auto k = static_cast<Eigen::Index>(i);
    return std::max(m_statistics(k), m_core_statistics(k)) > m_threshold;
}

Eigen::VectorXd LengthSnooping::scores() const {
    Eigen::VectorXd scores = Eigen::VectorXd::Zero(m_net.node_count());
    if (!is_active()) {
        return scores;
    }
    for (size_t i = 0; i < m_laws.size(); ++i) {
        if (m_released[i] || m_readmitted[i]) {
            continue;
        }
        const double own = rival_score(m_statistics(static_cast<Eigen::Index>(i)), m_threshold);
        for (const int node : m_net.edges()[m_net.interior_edges()[i]]) {
            scores(node) = std::max(scores(node), own);
        }
    }
    return scores;
}

bool LengthSnooping::release(const Eigen::VectorXd& rivals) {
    if (!is_active()) {
        return false;
    }
    const Eigen::VectorXd nearby = largest_nearby(m_net, scores().cwiseMax(rivals));
    Eigen::VectorXd beyond = Eigen::VectorXd::Zero(m_net.node_count());
    for (size_t i = 0; i < m_laws.size(); ++i) {
        if (may_release(i)) {
            for (const int node : m_net.edges()[m_net.interior_edges()[i]]) {
                beyond(node) =
                    std::max(beyond(node), m_core_statistics(static_cast<Eigen::Index>(i)));
            }
        }
    }
    const Eigen::VectorXd beyond_nearby = largest_nearby(m_net, beyond);
    bool has_changed = false;
    for (size_t i = 0; i < m_laws.size(); ++i) {
        if (!may_release(i)) {
            continue;
        }
        const auto k = static_cast<Eigen::Index>(i);
        const double own = rival_score(m_statistics(k), m_threshold);
        const auto stands_out = [&](int node) {
            // A normal law bears what the true one, which ends, does not: where nothing nearby is
            // beyond its threshold by that, the edge furthest beyond its law is the one.
            return own >= nearby(node) ||
                   (nearby(node) < 1.0 && m_core_statistics(k) >= beyond_nearby(node));
        };
        const auto [s, t] = m_net.edges()[m_net.interior_edges()[i]];
        if (stands_out(s) && stands_out(t)) {
            m_released[i] = true;
            has_changed = true;
        }
    }
    return has_changed;
}

bool LengthSnooping::may_release(size_t i) const {
    return !m_released[i] && !m_readmitted[i] && is_beyond(i);
}

bool LengthSnooping::readmit() {
    bool has_changed = false;
    for (size_t i = 0; i < m_laws.size(); ++i) {
        if (m_released[i] && !is_beyond(i)) {
            m_released[i] = false;
            m_readmitted[i] = true;
            has_changed = true;
        }
    }
    return has_changed;
}

int LengthSnooping::released_count() const {
    return static_cast<int>(std::ranges::count(m_released, true));
}

bool LengthSnooping::releases_too_many() const {
    return released_count() >
           std::max<double>(a_few, most_released * static_cast<double>(m_laws.size()));
}

std::vector<LengthLaw> LengthSnooping::laws() const {
    std::vector<LengthLaw> result = m_laws;
    for (size_t i = 0; i < m_laws.size(); ++i) {
        if (m_released[i]) {
            const double length = m_net.unstressed_lengths()(m_net.interior_edges()[i]);
            result[i] = {LengthLaw::Kind::normal,
                         std::min(m_released_std, widest_part_of_length * length)};
        }
    }
    return result;
}

double LengthSnooping::released_cost() const {
    const int count = released_count();
    return count > 0 ? m_threshold * count : 0.0;
}

double LengthSnooping::detectable(const std::vector<int>& edges) const {
    if (!is_active()) {
        return std::numeric_limits<double>::infinity();
    }
    std::vector<BoundedEstimate> estimates;
    for (size_t i = 0; i < m_told.size(); ++i) {
        if (m_released[i] || !std::ranges::binary_search(edges, m_net.interior_edges()[i])) {
            continue;
        }
        // Found where W or W_b is above the threshold; of an edge that may be slack errors may
        // hide.
        const bool is_tested = m_told[i].extension >= surely_taut;
        const double variance =
            is_tested ? m_told[i].std * m_told[i].std : std::numeric_limits<double>::infinity();
        const double std = m_laws[i].std();
        const auto [end, fall] = core_of(m_laws[i]);
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
    for (size_t i = 0; i < m_laws.size(); ++i) {
        if (m_released[i] && i < m_told.size()) {
            const auto k = static_cast<Eigen::Index>(i);
            Estimate found = tested_deviation(m_told[i]);
            if (!std::isfinite(found.std)) {
                found = {m_told[i].mean, m_told[i].std};
            }
            result.push_back({.edge = m_net.interior_edges()[i],
                              .deviation = found.mean,
                              .std = found.std,
                              .statistic = std::max(m_statistics(k), m_core_statistics(k))});
        }
    }
    std::ranges::sort(result, std::greater{}, &LengthOutlier::statistic);
    return result;
}

}  // namespace taut
