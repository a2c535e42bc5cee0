// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/parameter_estimates.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "estimation/hypotheses.hpp"
#include "identification/parameter_spread.hpp"
#include "net/support_stiffness.hpp"
#include "net/weight_as_load.hpp"
#include "sampling/uncertain_widths.hpp"
#include "taut/estimation/edge_status.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

using Kind = UncertainParameter::Kind;

/// A fitted length deviation is the sum of independent terms. This is the part of it that a term of
/// variance `part` has, given the prior variance of the sum.
struct Share {
    double mean;
    double variance;
};
Share share_of(double part, double prior_variance, double deviation_from_prior, double variance) {
    const double ratio = part / prior_variance;
    return {.mean = ratio * deviation_from_prior,
            .variance = part * (1.0 - ratio) + ratio * ratio * variance};
}

/// The root of a variance; where rounding errors exceed it, the prior standard deviation.
double std_or(double variance, double prior_std) {
    return variance > 0.0 ? std::sqrt(variance) : prior_std;
}

/// To this number of digits, rounded up.
double rounded_up(double width, int digits) {
    constexpr double rounding = 1e-9;  // 25.000000000000004 is 25
    const double per_digit = std::pow(10.0, digits - 1.0 - std::floor(std::log10(width)));
    return std::ceil(width * per_digit - rounding) / per_digit;
}

/// The width of an adjustable edge as reported: as given, to three digits, since it may have been
/// estimated from the surveys; or to two digits where it was set free, so that similar ones are
/// grouped.
double reported_width(double std_dev, double given) {
    constexpr double alike = 1e-3;
    return std::abs(std_dev - given) < alike * given ? rounded_up(given, 3)
                                                     : rounded_up(std_dev, 2);
}

class Estimates {
public:
    Estimates(const CableNet& net, const PriorKnowledge& knowledge, const LinearisedFit& fitted,
              const Observations& sites)
        : m_net(net),
          m_knowledge(knowledge),
          m_model(fitted.model()),
          m_covariance(fitted.covariance),
          m_sites(sites),
          m_fitted(fitted.iterate),
          m_blur_variances(m_model.blur.length_variances(sites.variance.size())) {}

    [[nodiscard]] std::vector<ParameterEstimate> run() && {
        int common = 0;
        for (const UncertainParameter& parameter : m_knowledge.uncertain) {
            switch (parameter.kind) {
                case Kind::stiffness:
                case Kind::temperature:
                case Kind::creep:
                case Kind::loads:
                case Kind::forces:
                case Kind::mass:
                case Kind::test_loads:
                case Kind::support_stiffness:
                    add_common(parameter, common++);
                    break;
                case Kind::slip:
                    add_slips(parameter);
                    break;
                case Kind::stiffness_each:
                    add_own_stiffness(parameter);
                    break;
                case Kind::adjustable:
                    add_adjustable(parameter);
                    break;
                case Kind::supports:
                    add_supports(parameter);
                    break;
                case Kind::loads_each:
                    add_own_loads(parameter);
                    break;
            }
        }
        for (ParameterEstimate& one : m_result) {
            one.prior_std = one.parameter.std_dev;
        }
        return std::move(m_result);
    }

private:
    /// @param k place among the common parameters
    void add_common(const UncertainParameter& parameter, int k) {
        m_result.push_back(
            {.parameter = parameter,
             .mean = parameter.std_dev * m_fitted.common(k),
             .std_dev = std_or(parameter.std_dev * parameter.std_dev * m_covariance.common(k, k),
                               parameter.std_dev)});
    }

    /// From the lengths as marked, those of the net, on: the net to fit has those that have slid in
    /// the design.
    void add_slips(const UncertainParameter& parameter) {
        const Eigen::VectorXd designed =
            m_model.net().unstressed_lengths() - m_net.unstressed_lengths();
        const int first = m_model.common.first_of_slips();
        int last = -1;
        double slip = 0.0;
        for (int k = 0; k < std::ssize(m_net.sliding_nodes()); ++k) {
            const SlidingNode& at = m_net.sliding_nodes()[k];
            slip = (at.before == last ? slip : 0.0) - designed(at.before);
            last = at.after;
            m_result.push_back({.parameter = parameter,
                                .edge = at.after,
                                .mean = slip + parameter.std_dev * m_fitted.common(first + k),
                                .std_dev = std_or(parameter.std_dev * parameter.std_dev *
                                                      m_covariance.common(first + k, first + k),
                                                  parameter.std_dev)});
        }
    }

    /// The share of an edge's deviation by a part of its prior variance.
    [[nodiscard]] Share share(int edge, double part) const {
        const double prior = m_sites.variance(edge) + m_blur_variances(edge);
        // Where rounding errors exceed it, nothing is known.
        const double found = m_covariance.lengths(edge);
        return share_of(part, prior, m_fitted.deviations(edge) - m_sites.mean(edge),
                        found > 0.0 ? found : prior);
    }

    /// (own-stiffness). All edges are interior ones of the net to fit.
    void add_own_stiffness(const UncertainParameter& parameter) {
        const Eigen::VectorXd stds = own_stiffness_stds(m_net, m_knowledge.uncertain);
        for (const int edge : edges_of(m_net, parameter)) {
            ParameterEstimate estimate{
                .parameter = parameter, .edge = edge, .std_dev = parameter.std_dev};
            if (const double part = m_model.blur.stiffness(edge); part > 0.0) {
                // The edge's own stiffness may be the sum of two parameters; this one is a part of
                // it.
                const double by_length = stds(edge) / std::sqrt(part);
                const double own = std::pow(parameter.std_dev / stds(edge), 2);
                const Share length = share(edge, part);
                estimate.mean =
                    m_model.own_stiffness_sign(edge, m_model.rates(edge, m_fitted).tension) * own *
                    by_length * length.mean;
                estimate.std_dev = std_or(own * own * by_length * by_length * length.variance +
                                              (1.0 - own) * parameter.std_dev * parameter.std_dev,
                                          parameter.std_dev);
            }
            m_result.push_back(std::move(estimate));
        }
    }

    /// Grouped by the width given for each: most have the same, some were set free.
    void add_adjustable(const UncertainParameter& parameter) {
        std::vector<int> edges;
        std::ranges::copy_if(m_net.adjustable_edges(), std::back_inserter(edges), [&](int edge) {
            // Else it is known: not turned since.
            return m_knowledge.priors[edge].std_dev() >= 1e-3 * parameter.std_dev;
        });
        std::ranges::stable_sort(edges, {},
                                 [&](int edge) { return m_knowledge.priors[edge].std_dev(); });
        for (const int edge : edges) {
            const Share length = share(edge, m_sites.variance(edge));
            UncertainParameter reported = parameter;
            reported.std_dev =
                reported_width(m_knowledge.priors[edge].std_dev(), parameter.std_dev);
            m_result.push_back({.parameter = reported,
                                .edge = edge,
                                .mean = m_sites.mean(edge) + length.mean,
                                .std_dev = std::sqrt(std::max(0.0, length.variance))});
        }
    }

    void add_supports(const UncertainParameter& parameter) {
        const Points motion = m_model.common.support_motion(m_fitted.common);
        for (const int node : m_net.supports()) {
            const Eigen::Vector3d shift =
                m_fitted.form.col(node) - m_net.nodes().col(node) - motion.col(node);
            add_node(parameter, node, shift, m_covariance.places[node]);
        }
        const std::vector<int> coupled = coupled_supports(m_net);
        for (const ElasticSupport& support : m_net.elastic_supports()) {
            const auto found = std::ranges::find(coupled, support.node);
            if (found == coupled.end()) {
                add_place_of_elastic(parameter, support);
            } else {
                add_place_on_frame(parameter, support.node,
                                   static_cast<int>(found - coupled.begin()));
            }
        }
    }

    /// A force on a node is the sum of independent terms. This is the part of it that a term of
    /// covariance `part` has.
    struct ForceShare {
        Eigen::Vector3d mean;
        Eigen::Matrix3d covariance;
    };
    [[nodiscard]] ForceShare force_share(int node, const Eigen::Matrix3d& part) const {
        const Eigen::Matrix3d ratio = part * m_sites.load_covariance(node).inverse();
        return {.mean = ratio * (m_fitted.loads.col(node) - m_sites.load_mean.col(node)),
                .covariance =
                    part - ratio * part + ratio * m_covariance.loads[node] * ratio.transpose()};
    }

    /// (elastic-supports): the place of a support without load, by the force that its error adds.
    void add_place_of_elastic(const UncertainParameter& parameter, const ElasticSupport& support) {
        const Eigen::Matrix3d& K = support.stiffness;
        const ForceShare force =
            force_share(support.node, parameter.std_dev * parameter.std_dev * K * K);
        const Eigen::Matrix3d flexibility = K.inverse();
        add_node(parameter, support.node, flexibility * force.mean,
                 flexibility * force.covariance * flexibility);
    }

    /// @param i position of the support in coupled_supports()
    void add_place_on_frame(const UncertainParameter& parameter, int node, int i) {
        const int first = m_model.common.first_of_places() + 3 * i;
        add_node(
            parameter, node, parameter.std_dev * m_fitted.common.segment<3>(first),
            parameter.std_dev * parameter.std_dev * m_covariance.common.block<3, 3>(first, first));
    }

    void add_own_loads(const UncertainParameter& parameter) {
        const Eigen::Matrix3d own =
            parameter.std_dev * parameter.std_dev * Eigen::Matrix3d::Identity();
        for (const int node : m_net.free_nodes()) {
            const ForceShare load = force_share(node, own);
            add_node(parameter, node, load.mean, load.covariance);
        }
    }

    void add_node(const UncertainParameter& parameter, int node, const Eigen::Vector3d& mean,
                  const Eigen::Matrix3d& covariance) {
        for (int axis = 0; axis < 3; ++axis) {
            m_result.push_back({.parameter = parameter,
                                .node = node,
                                .axis = axis,
                                .mean = mean(axis),
                                .std_dev = std::sqrt(std::max(0.0, covariance(axis, axis)))});
        }
    }

    const CableNet& m_net;
    const PriorKnowledge& m_knowledge;
    const StaticsModel& m_model;
    const Covariance& m_covariance;
    const Observations& m_sites;
    const Iterate& m_fitted;
    Eigen::VectorXd m_blur_variances;
    std::vector<ParameterEstimate> m_result;
};

/// Sums over numbers with one given standard deviation.
struct Variances {
    double given = 0.0;     ///< before the survey
    double expected = 0.0;  ///< of the means: what the survey takes away
};
Variances variances_of(std::span<const ParameterEstimate> estimates) {
    Variances sums;
    for (const ParameterEstimate& one : estimates) {
        sums.given += one.prior_std * one.prior_std;
        sums.expected += std::max(0.0, one.prior_std * one.prior_std - one.std_dev * one.std_dev);
    }
    return sums;
}

}  // namespace

bool ParameterEstimate::is_observed() const {
    return std_dev < not_determined_ratio * prior_std;
}

double spread_ratio(std::span<const ParameterEstimate> estimates) {
    double found = 0.0;
    for (const ParameterEstimate& one : estimates) {
        found += one.mean * one.mean;
    }
    const auto [given, expected] = variances_of(estimates);
    // Where the survey shows less than this, non-linearity moves the estimates as much. A single
    // number is moved as far by the prior of the lengths, which is estimated with it.
    const double least_shown = estimates.size() == 1 ? 0.05 : 0.02;
    return expected > least_shown * given ? std::sqrt(found / expected) : 0.0;
}

bool ParameterSpread::is_contradicted() const {
    constexpr double false_alarm_rate = 2.7e-3;
    constexpr double least = 1.5;
    const double numbers = std::max(1.0, shown);
    const boost::math::chi_squared_distribution<> by_chance(numbers);
    const double highest = boost::math::quantile(complement(by_chance, false_alarm_rate)) / numbers;
    return ratio > std::max(least, std::sqrt(highest));
}

std::vector<ParameterSpread> spreads_of(const std::vector<ParameterEstimate>& estimates) {
    std::vector<ParameterSpread> result;
    for (auto first = estimates.begin(); first != estimates.end();) {
        const auto last = std::find_if(first, estimates.end(), [&](const ParameterEstimate& one) {
            return one.parameter != first->parameter;
        });
        const auto [given, expected] = variances_of({first, last});
        result.push_back(
            {.parameter = first->parameter,
             // slips are counted from the marks, and nothing is assumed of them
             .ratio = first->parameter.kind == Kind::slip ? 0.0 : spread_ratio({first, last}),
             .shown = static_cast<double>(last - first) * expected / given,
             .widening = first->parameter.kind == Kind::creep
                             ? 1.0  // a walk: its steps are as wide as all of it
                             : first->prior_std / first->parameter.std_dev});
        first = last;
    }
    return result;
}

std::vector<DisplacedSupport> displaced_supports(const CableNet& net,
                                                 std::span<const ParameterEstimate> estimates) {
    constexpr double false_alarm_rate = 0.01;
    constexpr double least_shown = 0.1;  // of the prior variance
    struct Found {
        double squared_distance = 0.0;
        double std_dev = 0.0;
        double statistic = 0.0;
    };
    std::map<int, Found> found;
    for (const ParameterEstimate& one : estimates) {
        if (one.parameter.kind == Kind::supports && net.free_index(one.node) >= 0) {
            Found& of_node = found[one.node];
            const double prior = one.prior_std * one.prior_std;
            const double shown = std::max(prior - one.std_dev * one.std_dev, least_shown * prior);
            of_node.squared_distance += one.mean * one.mean;
            of_node.std_dev = std::max(of_node.std_dev, one.std_dev);
            of_node.statistic = std::max(of_node.statistic, one.mean * one.mean / shown);
        }
    }
    const double threshold = snooping_threshold(false_alarm_rate, 3 * found.size(), 1);
    std::vector<DisplacedSupport> result;
    for (const auto& [node, of_node] : found) {
        if (of_node.statistic > threshold) {
            result.push_back({.node = node,
                              .distance = std::sqrt(of_node.squared_distance),
                              .std_dev = of_node.std_dev});
        }
    }
    return result;
}

ModelPerturbation perturbation_of(const CableNet& net,
                                  const std::vector<ParameterEstimate>& uncertain,
                                  const Points& test_loads) {
    ModelPerturbation result = unperturbed(net);
    const bool is_mass_uncertain = std::ranges::any_of(
        uncertain, [](const auto& one) { return one.parameter.kind == Kind::mass; });
    for (const ParameterEstimate& estimate : uncertain) {
        const double mean = estimate.mean;
        switch (estimate.parameter.kind) {
            case Kind::stiffness:
                result.stiffness(edges_of(net, estimate.parameter)).array() += mean;
                break;
            case Kind::stiffness_each:
                result.stiffness(estimate.edge) += mean;
                break;
            case Kind::temperature: {
                const std::vector<int> edges = edges_of(net, estimate.parameter);
                result.thermal(edges) += mean * net.data().expansion(edges);
                break;
            }
            case Kind::creep:
                result.thermal(edges_of(net, estimate.parameter)).array() += mean;
                break;
            case Kind::supports:
                result.supports(estimate.axis, estimate.node) = mean;
                break;
            case Kind::adjustable:
                result.adjustable(estimate.edge) += mean;
                break;
            case Kind::support_stiffness:
                result.support_stiffness = mean;
                break;
            case Kind::slip: {
                // Estimates of interior edges hold what slid to them.
                const auto at =
                    std::ranges::find(net.sliding_nodes(), estimate.edge, &SlidingNode::after);
                for (const auto& [edge, sign] : {std::pair(at->before, -1.0), {at->after, 1.0}}) {
                    if (std::ranges::binary_search(net.adjustable_edges(), edge)) {
                        result.adjustable(edge) += sign * mean;
                    }
                }
                break;
            }
            case Kind::loads:
                result.loads = mean;
                if (is_mass_uncertain) {
                    result.own_loads -= mean * self_weight(net);  // has that of the mass
                }
                if (test_loads.cols() > 0) {
                    result.own_loads -= mean * test_loads;  // have their own
                }
                break;
            case Kind::loads_each:
                result.own_loads(estimate.axis, estimate.node) += mean;
                break;
            case Kind::mass:
                result.sag = mean;
                result.own_loads += mean * self_weight(net);
                break;
            case Kind::test_loads:
                if (test_loads.cols() > 0) {
                    result.own_loads += mean * test_loads;
                }
                break;
            case Kind::forces:
                break;  // an error of measurements, not of the net
        }
    }
    return result;
}

CableNet net_to_fit(const CableNet& net, const std::vector<UncertainParameter>& uncertain) {
    const bool slides = !net.sliding_nodes().empty();
    if (!slides && !(std_of(uncertain, Kind::adjustable) > 0.0) &&
        !(std_of(uncertain, Kind::stiffness_each) > 0.0)) {
        return net;
    }
    CableNetData data =
        slides ? with_lengths_of_same_weight(net, solve_equilibrium(net).unstressed_lengths)
               : net.data();
    data.adjustable.clear();
    data.thread.clear();
    return CableNet(std::move(data));
}

Eigen::VectorXd adjustable_stds(const CableNet& net,
                                const std::vector<UncertainParameter>& uncertain) {
    constexpr double as_good_as_known = 1e-7;  // of a length, as of exact places
    const double given = std_of(uncertain, Kind::adjustable);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(net.edge_count());
    for (const int edge : net.adjustable_edges()) {
        result(edge) = std::max(given, as_good_as_known * net.unstressed_lengths()(edge));
    }
    return result;
}

PriorKnowledge knowledge_of(const CableNet& fit_net, const LengthPrior& prior,
                            const std::vector<UncertainParameter>& uncertain, const Forces& forces,
                            const Eigen::VectorXd& stds) {
    PriorKnowledge knowledge(fit_net, prior);
    knowledge.uncertain = uncertain;
    knowledge.forces = forces;
    for (int i = 0; i < fit_net.interior_edge_count(); ++i) {
        if (const double std_dev = stds(fit_net.interior_edges()[i]); std_dev > 0.0) {
            knowledge.priors[i] = {LengthPrior::Kind::normal, std_dev};
        }
    }
    return knowledge;
}

std::vector<ParameterEstimate> parameter_estimates(const CableNet& net,
                                                   const PriorKnowledge& knowledge,
                                                   const LinearisedFit& fitted,
                                                   const Observations& sites) {
    return Estimates(net, knowledge, fitted, sites).run();
}

}  // namespace taut
