// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/prior_mixture.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "estimation/length_posterior.hpp"
#include "identification/completion.hpp"
#include "identification/draw_posterior.hpp"
#include "identification/stretch_lengths.hpp"

namespace taut {
namespace {

/// Unreliable draws of parts with less probability are left out.
constexpr double negligible = 0.1;

bool has_unreliable_draws(const Identification& result) {
    return result.draws && !result.draws->reason.empty();
}

/// Mean and standard deviation of a mixture.
class Moments {
public:
    void add(double weight, double mean, double std_dev) {
        m_mean += weight * mean;
        m_square += weight * (mean * mean + std_dev * std_dev);
        m_within += weight * std_dev * std_dev;
    }
    [[nodiscard]] double mean() const { return m_mean; }
    [[nodiscard]] double std_dev() const {
        // Rounding must not make it less than within the parts.
        return std::sqrt(std::max(m_square - m_mean * m_mean, m_within));
    }

private:
    double m_mean = 0.0;
    double m_square = 0.0;
    double m_within = 0.0;
};

template <class Get>
std::pair<double, double> mixed(const std::vector<WeightedIdentification>& parts, const Get& get) {
    Moments moments;
    for (const WeightedIdentification& part : parts) {
        const auto [mean, std_dev] = get(part.result);
        moments.add(part.weight, mean, std_dev);
    }
    return {moments.mean(), moments.std_dev()};
}

/// Whether an edge is slack shows only by reliable draws of all parts, or where all of them say it.
IdentifiedEdge mixed_edge(const std::vector<WeightedIdentification>& parts, size_t i,
                          double prior_std) {
    IdentifiedEdge edge = parts.front().result.edges[i];
    std::vector<MixturePart> ends;
    double slack = 0.0;
    bool is_open = false;
    double lowest = edge.lower;
    double highest = edge.upper;
    for (const auto& [weight, result] : parts) {
        const IdentifiedEdge& one = result.edges[i];
        ends.push_back({weight, one.length_deviation, one.lower, one.upper});
        lowest = std::min(lowest, one.lower);
        highest = std::max(highest, one.upper);
        const bool is_slack = one.status == EdgeStatus::slack;
        slack += is_slack ? weight : 0.0;
        is_open = is_open || (!is_slack && has_unreliable_draws(result));
    }
    std::tie(edge.length_deviation, edge.std_dev) = mixed(parts, [i](const Identification& result) {
        return std::pair(result.edges[i].length_deviation, result.edges[i].std_dev);
    });
    edge.lower = std::clamp(quantile_of(ends, 0.025), lowest, edge.length_deviation);
    edge.upper = std::clamp(quantile_of(ends, 0.975), edge.length_deviation, highest);
    edge.status = status_of(std_before(parts.front().result, edge.edge, prior_std),
                            {.std_dev = edge.std_dev, .slack_probability = is_open ? 0.0 : slack});
    return edge;
}

FrameOffset mixed_frame(const std::vector<WeightedIdentification>& parts) {
    FrameOffset frame = *parts.front().result.frame_offset;
    for (int k = 0; k < 3; ++k) {
        std::tie(frame.translation(k), frame.translation_std(k)) =
            mixed(parts, [k](const Identification& result) {
                return std::pair(result.frame_offset->translation(k),
                                 result.frame_offset->translation_std(k));
            });
        std::tie(frame.rotation(k), frame.rotation_std(k)) =
            mixed(parts, [k](const Identification& result) {
                return std::pair(result.frame_offset->rotation(k),
                                 result.frame_offset->rotation_std(k));
            });
    }
    return frame;
}

/// (prior-mixture), of the covariances of some lengths.
LengthCovariance mixed_covariance(const std::vector<WeightedIdentification>& parts,
                                  const std::vector<IdentifiedEdge>& edges) {
    LengthCovariance mixed = *parts.front().result.length_covariance;
    mixed.covariance.setZero();
    for (const auto& [weight, result] : parts) {
        Eigen::VectorXd from_mean(std::ssize(mixed.edges));
        for (Eigen::Index k = 0; k < from_mean.size(); ++k) {
            const auto at = std::ranges::find(edges, mixed.edges[static_cast<size_t>(k)],
                                              &IdentifiedEdge::edge) -
                            edges.begin();
            from_mean(k) = result.edges[static_cast<size_t>(at)].length_deviation -
                           edges[static_cast<size_t>(at)].length_deviation;
        }
        mixed.covariance +=
            weight * (result.length_covariance->covariance + from_mean * from_mean.transpose());
    }
    return mixed;
}

/// Force measurements that any part left out, and the probability of the parts that did; of those
/// that are only doubted, what most of them doubt.
std::vector<ForceOutlier> mixed_outliers(const std::vector<WeightedIdentification>& parts) {
    std::vector<ForceOutlier> all;
    for (const auto& [weight, result] : parts) {
        for (const ForceOutlier& one : result.force_outliers) {
            const auto found = std::ranges::find(all, one.edge, &ForceOutlier::edge);
            if (found != all.end()) {
                found->probability = std::min(found->probability + weight * one.probability, 1.0);
            } else {
                all.push_back(one);
                all.back().probability = weight * one.probability;
            }
        }
    }
    std::erase_if(all, [&](const ForceOutlier& one) {
        double named_by = 0.0;
        for (const auto& [weight, result] : parts) {
            const auto& named = result.force_outliers;
            const bool is_named =
                std::ranges::find(named, one.edge, &ForceOutlier::edge) != named.end();
            named_by += is_named ? weight : 0.0;
        }
        return one.probability == 0.0 && named_by < 0.5;
    });
    std::ranges::sort(all, std::ranges::greater(), &ForceOutlier::statistic);
    return all;
}

/// The likeliest part's common error of force measurements, of those that found one.
std::optional<ForceBias> mixed_bias(const std::vector<WeightedIdentification>& parts) {
    std::optional<ForceBias> bias;
    double probability = 0.0;
    double named_by = 0.0;
    for (const auto& [weight, result] : parts) {
        if (result.force_bias) {
            bias = bias ? bias : result.force_bias;
            probability += weight * result.force_bias->probability;
            named_by += weight;
        }
    }
    if (bias) {
        bias->probability = std::min(probability, 1.0);
    }
    return probability > 0.0 || named_by > 0.5 ? bias : std::nullopt;
}

/// (prior-mixture), of the places of all nodes; nothing where a part has none.
std::vector<Eigen::Matrix3d> mixed_places(const std::vector<WeightedIdentification>& parts) {
    const Points& first = parts.front().result.predicted.form;
    Points mean = Points::Zero(3, first.cols());  // less the first: exactly 0 where all agree
    for (const auto& [weight, result] : parts) {
        if (result.form_covariance.empty()) {
            return {};
        }
        mean += weight * (result.predicted.form - first);
    }
    std::vector<Eigen::Matrix3d> mixed(static_cast<size_t>(first.cols()), Eigen::Matrix3d::Zero());
    for (const auto& [weight, result] : parts) {
        for (Eigen::Index node = 0; node < first.cols(); ++node) {
            const Eigen::Vector3d from_mean =
                result.predicted.form.col(node) - first.col(node) - mean.col(node);
            mixed[static_cast<size_t>(node)] +=
                weight * (result.form_covariance[static_cast<size_t>(node)] +
                          from_mean * from_mean.transpose());
        }
    }
    return mixed;
}

/// The first draws of each part, one after another.
PosteriorDraws drawn_by(const std::vector<WeightedIdentification>& parts, int draws) {
    std::vector<double> weights(parts.size());
    std::ranges::transform(parts, weights.begin(), &WeightedIdentification::weight);
    const std::vector<int> shares = shared_out(draws, weights);
    PosteriorDraws all = *parts.front().result.draws;
    for (const WeightedIdentification& part : parts) {
        if (all.reason.empty()) {
            all.reason = part.result.draws->reason;
        }
        if (part.result.draws->is_refitted) {
            all.method = part.result.draws->method;
            all.is_refitted = true;
        }
    }
    // Without rows where no part has any; 0 for a part that has none.
    const auto collected = [&](const auto& of_draws) {
        Eigen::Index rows = 0;
        Eigen::Index columns = 0;
        std::vector<Eigen::Index> counts;
        for (size_t k = 0; k < parts.size(); ++k) {
            const PosteriorDraws& draws = *parts[k].result.draws;
            rows = std::max(rows, of_draws(draws).rows());
            counts.push_back(std::min<Eigen::Index>(shares[k], draws.count()));
            columns += counts.back();
        }
        if (rows == 0) {
            return Eigen::MatrixXd();
        }
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows, columns);
        columns = 0;
        for (size_t k = 0; k < parts.size(); ++k) {
            const Eigen::MatrixXd& of_part = of_draws(*parts[k].result.draws);
            if (of_part.rows() > 0) {
                result.middleCols(columns, counts[k]) = of_part.leftCols(counts[k]);
            }
            columns += counts[k];
        }
        return result;
    };
    const auto perturbation = [&](Eigen::MatrixXd ModelPerturbations::* member) {
        return collected([member](const PosteriorDraws& draws) -> const Eigen::MatrixXd& {
            return draws.perturbations.*member;
        });
    };
    const auto member = [&](Eigen::MatrixXd PosteriorDraws::* of) {
        return collected(
            [of](const PosteriorDraws& draws) -> const Eigen::MatrixXd& { return draws.*of; });
    };
    PosteriorDraws result = all;
    result.length_deviations = member(&PosteriorDraws::length_deviations);
    result.adjustable_deviations = member(&PosteriorDraws::adjustable_deviations);
    result.perturbations = {.stiffness = perturbation(&ModelPerturbations::stiffness),
                            .thermal = perturbation(&ModelPerturbations::thermal),
                            .supports = perturbation(&ModelPerturbations::supports),
                            .loads = perturbation(&ModelPerturbations::loads)};
    result.forms = member(&PosteriorDraws::forms);
    result.tensions = member(&PosteriorDraws::tensions);
    return result;
}

/// Without parts of little probability whose draws are unreliable.
std::vector<WeightedIdentification> without_unreliable(std::vector<WeightedIdentification> parts) {
    const auto is_unreliable = [](const WeightedIdentification& part) {
        return has_unreliable_draws(part.result);
    };
    double unreliable = 0.0;
    for (const WeightedIdentification& part : parts) {
        unreliable += is_unreliable(part) ? part.weight : 0.0;
    }
    if (unreliable > 0.0 && unreliable < negligible) {
        std::erase_if(parts, is_unreliable);
        for (WeightedIdentification& part : parts) {
            part.weight /= 1.0 - unreliable;
        }
    }
    return parts;
}

}  // namespace

double quantile_of(const std::vector<MixturePart>& parts, double p) {
    constexpr double interval = 1.959963984540054;  // standard deviations
    double lowest = parts.front().mean;
    double highest = lowest;
    for (const MixturePart& part : parts) {
        // Outside of these any part has less than 1e-9.
        lowest = std::min(lowest, part.mean + 4.0 * (part.lower - part.mean));
        highest = std::max(highest, part.mean + 4.0 * (part.upper - part.mean));
    }
    if (!(highest > lowest)) {
        return lowest;
    }
    const auto excess = [&](double x) {
        double sum = -p;
        for (const MixturePart& part : parts) {
            const double side = x < part.mean ? part.mean - part.lower : part.upper - part.mean;
            const double z =
                side > 0.0 ? interval * (x - part.mean) / side : (x < part.mean ? -10.0 : 10.0);
            sum += part.weight * 0.5 * std::erfc(-z / std::numbers::sqrt2);
        }
        return sum;
    };
    std::uintmax_t most_iterations = 100;
    constexpr int bits = 40;
    const auto [below, above] = boost::math::tools::toms748_solve(
        excess, lowest, highest, boost::math::tools::eps_tolerance<double>(bits), most_iterations);
    return 0.5 * (below + above);
}

std::vector<int> shared_out(int draws, const std::vector<double>& weights) {
    std::vector<int> shares;
    double cumulative = 0.0;
    int given = 0;
    for (const double weight : weights) {
        cumulative += weight;
        const int until = std::min(draws, static_cast<int>(std::lround(cumulative * draws)));
        shares.push_back(until - given);
        given = until;
    }
    shares.back() += draws - given;
    return shares;
}

Identification mixture_of(const CableNet& net, const Survey& survey,
                          std::vector<WeightedIdentification> parts, int draws) {
    parts = without_unreliable(std::move(parts));
    Identification result = parts.front().result;
    if (parts.size() == 1) {
        return result;
    }
    Moments prior;
    for (const auto& [weight, part] : parts) {
        prior.add(weight, 0.0, part.length_prior.std_dev());
    }
    for (size_t i = 0; i < result.edges.size(); ++i) {
        result.edges[i] = mixed_edge(parts, i, prior.std_dev());
    }
    const auto is_other = [&](const WeightedIdentification& part) {
        return part.result.uncertain.size() != result.uncertain.size();
    };
    // A part that released another adjustable edge has other parameters.
    const bool has_same_uncertain = std::ranges::none_of(parts, is_other);
    for (size_t k = 0; has_same_uncertain && k < result.uncertain.size(); ++k) {
        std::tie(result.uncertain[k].mean, result.uncertain[k].std_dev) =
            mixed(parts, [k](const Identification& part) {
                return std::pair(part.uncertain[k].mean, part.uncertain[k].std_dev);
            });
    }
    for (size_t k = 0; k < result.stretches.size(); ++k) {
        const auto std_of = [&](const auto& of_stretch) {
            return mixed(parts,
                         [&](const Identification& part) { return of_stretch(part.stretches[k]); })
                .second;
        };
        result.stretches[k].std_dev = std_of(
            [](const StretchLength& one) { return std::pair(one.length_deviation, one.std_dev); });
        result.stretches[k].tension_std = std_of(
            [](const StretchLength& one) { return std::pair(one.tension, one.tension_std); });
    }
    result.force_outliers = mixed_outliers(parts);
    result.force_bias = mixed_bias(parts);
    if (result.frame_offset) {
        result.frame_offset = mixed_frame(parts);
    }
    if (result.length_covariance) {
        result.length_covariance = mixed_covariance(parts, result.edges);
    }
    result.form_covariance = mixed_places(parts);
    if (result.draws) {
        result.draws = drawn_by(parts, draws);
        set_summary_of_draws(result, net, survey, prior.std_dev());
    }
    const Points start = result.predicted.form;
    predict_form(result, net, survey, start);
    set_stretch_means(result, net);
    return result;
}

std::optional<Identification> mixture_over(
    const CableNet& net, const Survey& survey, const std::vector<PriorNode>& nodes,
    const PosteriorSettings& wanted,
    const std::function<std::optional<Identification>(size_t k, const PosteriorSettings&)>&
        identify_by) {
    // Fewer draws would not show whether they are reliable.
    constexpr int fewest_draws = 10;
    constexpr double most_left_out = 0.1;
    std::vector<double> weights(nodes.size());
    std::ranges::transform(nodes, weights.begin(), &PriorNode::weight);
    const std::vector<int> shares = shared_out(wanted.count, weights);
    std::vector<WeightedIdentification> parts;
    double converged = 0.0;
    double unreliable = 0.0;
    for (size_t k = 0; k < nodes.size(); ++k) {
        PosteriorSettings of_part = wanted;
        of_part.count = wanted.count > 0 ? std::max(fewest_draws, shares[k]) : 0;
        of_part.seed += k;
        of_part.by_chains = unreliable < negligible;  // else no draws of the mixture are reliable
        std::optional<Identification> part = identify_by(k, of_part);
        if (part && part->status == IdentificationStatus::converged) {
            converged += nodes[k].weight;
            unreliable += has_unreliable_draws(*part) ? nodes[k].weight : 0.0;
            parts.push_back({.weight = nodes[k].weight, .result = *std::move(part)});
        }
    }
    if (converged < 1.0 - most_left_out) {
        return std::nullopt;
    }
    for (WeightedIdentification& part : parts) {
        part.weight /= converged;
    }
    return mixture_of(net, survey, std::move(parts), wanted.count);
}

}  // namespace taut
