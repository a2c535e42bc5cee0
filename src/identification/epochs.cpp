// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/epochs.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "identification/epoch_chain.hpp"
#include "identification/maximum_a_posteriori.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;

/// A survey that moves lengths by so much more than all let expect contradicts the others.
constexpr double far_too_much = 1.5;

bool goes_with_epochs(const Unknown& unknown) {
    using Kind = Unknown::Kind;
    return unknown.kind == Kind::stiffness || unknown.kind == Kind::temperature ||
           unknown.kind == Kind::loads || unknown.kind == Kind::adjustable;
}

/// Two surveys of which most targets agree to the last digit are one, counted twice.
bool is_repeated(const Survey& a, const Survey& b) {
    std::vector<int> both;
    std::ranges::set_intersection(a.surveyed, b.surveyed, std::back_inserter(both));
    const auto same =
        std::ranges::count_if(both, [&](int node) { return a.form.col(node) == b.form.col(node); });
    return !both.empty() && 2 * same > std::ssize(both);
}

void check_epochs(const CableNet& net, std::span<const Epoch> epochs,
                  const IdentifyOptions& options) {
    if (epochs.size() < 2) {
        throw std::invalid_argument("epochs are at least two surveys");
    }
    if (options.model != nullptr ||
        options.method.value_or(IdentificationMethod::map) != IdentificationMethod::map) {
        throw std::invalid_argument("--epoch is for --method map, without a model");
    }
    if (net.interior_edge_count() > most_edges_of_epochs) {
        throw std::invalid_argument(
            fmt::format("the net has {} interior edges, and --epoch is for at most {}",
                        net.interior_edge_count(), most_edges_of_epochs));
    }
    for (const Unknown& unknown : options.unknowns) {
        if (!goes_with_epochs(unknown)) {
            throw std::invalid_argument(
                fmt::format("--unknown {} does not go with --epoch: all surveys would share them, "
                            "each by itself",
                            unknown.to_string()));
        }
    }
    if (!epochs.front().turned.empty()) {
        throw std::invalid_argument("nothing can be turned before the first survey");
    }
    for (size_t k = 0; k < epochs.size(); ++k) {
        check_turned(net, epochs[k].turned);
        if (!epochs[k].survey.is_noisy()) {
            throw SurveyError(0,
                              "is taken for exact, and --epoch needs its noise (--noise, or sx, "
                              "sy, sz in the file)");
        }
        for (size_t j = 0; j < k; ++j) {
            if (is_repeated(epochs[j].survey, epochs[k].survey)) {
                throw SurveyError(0,
                                  fmt::format("repeats survey {} as survey {} to the last digit: "
                                              "what was seen once would be counted twice",
                                              j + 1, k + 1));
            }
        }
    }
}

/// The surveys with lengths found to have changed: of adjustable edges as play of the turnbuckle.
std::vector<Epoch> with_changes(const CableNet& net, std::vector<Epoch> epochs,
                                const std::vector<EpochChain::Changes>& changes) {
    for (size_t k = 1; k < epochs.size(); ++k) {
        for (const LengthChange& change : changes[k].lengths) {
            if (!std::ranges::binary_search(net.adjustable_edges(), change.edge)) {
                continue;
            }
            std::vector<EdgeTurned>& turned = epochs[k].turned;
            auto one = std::ranges::find(turned, change.edge, &EdgeTurned::edge);
            if (one == turned.end()) {
                one = turned.insert(one, {.edge = change.edge, .stroke = 0.0, .std = 0.0});
            }
            one->std = std::hypot(one->std, widest_turn(net));
        }
    }
    return epochs;
}

/// Far below what a survey shows.
double small_play(const std::vector<Epoch>& epochs) {
    constexpr double part_of_noise = 0.05;
    double noise = std::numeric_limits<double>::infinity();
    for (const Epoch& epoch : epochs) {
        const Points stds = epoch.survey.noise_std(Eigen::all, epoch.survey.surveyed);
        noise = std::min(noise, std::sqrt(stds.squaredNorm() / static_cast<double>(stds.size())));
    }
    return part_of_noise * noise;
}

constexpr const char* what_to_check =
    "Check what is told of the turns (signs, units, which file), and that both surveys are of this "
    "net";

std::string contradiction_text(size_t before, double ratio) {
    return fmt::format(
        "between surveys {} and {} lengths changed {:.2g} times as much as both let "
        "expect of the same ones",
        before, before + 1, ratio);
}

/// Which lengths changed between two surveys.
void add_changes(Trust& trust, const CableNet& net, const std::vector<EpochResult>& epochs) {
    for (size_t k = 1; k < epochs.size(); ++k) {
        const EpochResult& epoch = epochs[k];
        const std::string between = fmt::format("between surveys {} and {}", k, k + 1);
        if (epoch.change_ratio > far_too_much) {
            trust.findings.push_back({.verdict = Verdict::failed,
                                      .reason = contradiction_text(k, epoch.change_ratio),
                                      .next = what_to_check});
            continue;
        }
        constexpr double beyond_chance = 4.0;
        if (std::abs(epoch.stroke_factor - 1.0) > beyond_chance * epoch.stroke_factor_std) {
            trust.findings.push_back(
                {.verdict = Verdict::failed,
                 .reason = fmt::format("{} all edges were turned {:.3f} +- {:.3f} times as far as "
                                       "told",
                                       between, epoch.stroke_factor, epoch.stroke_factor_std),
                 .next = "Check the length of a turn and the unit of what was turned"});
        }
        std::vector<std::string> names;
        names.reserve(epoch.changes.size());
        for (const LengthChange& change : epoch.changes) {
            names.push_back(fmt::format("{} by {:+.2f} +- {:.2f} mm", net.edge_id(change.edge),
                                        1e3 * change.change, 1e3 * change.std));
        }
        if (!names.empty()) {
            trust.findings.push_back(
                {.verdict = Verdict::doubtful,
                 .reason =
                     fmt::format("{} length{} changed {}: {}", names.size(),
                                 names.size() == 1 ? "" : "s", between, fmt::join(names, ", ")),
                 .next = "If these were turned, tell it among the turns; else look whether they "
                         "slipped, or a support at them moved. Each survey was given a length of "
                         "its own for them"});
        }
    }
}

Trust trust_of_epochs(const CableNet& net, const std::vector<EpochResult>& epochs) {
    Trust trust;
    for (size_t k = 0; k < epochs.size(); ++k) {
        for (const Trust::Finding& finding : epochs[k].trust.findings) {
            trust.findings.push_back(finding);
            trust.findings.back().reason = fmt::format("survey {}: {}", k + 1, finding.reason);
        }
    }
    add_changes(trust, net, epochs);
    std::ranges::stable_sort(trust.findings, std::greater{}, &Trust::Finding::verdict);
    return trust;
}

}  // namespace

Identification identify_epochs(const CableNet& net, std::span<const Epoch> epochs,
                               const IdentifyOptions& options, const Progress& progress) {
    check_epochs(net, epochs, options);
    IdentifyOptions alone = options;
    alone.method = IdentificationMethod::map;
    alone.draws = 0;
    alone.forces = {};
    // The law, where none is told, and the noise, where it is not known.
    const Identification first = identify(net, epochs.front().survey, alone, progress);
    std::vector<Epoch> scaled(epochs.begin(), epochs.end());
    std::vector<double> noise_scales(epochs.size(), first.noise_scale);
    std::vector<std::vector<EdgeTurned>> steps;
    std::vector<std::vector<EdgeTurned>> all_steps;
    for (size_t k = 0; options.estimate_noise && k < epochs.size(); ++k) {
        steps.push_back(epochs[k].turned);
        if (k > 0) {
            noise_scales[k] =
                identify(settled_net(net, all_turned(steps)), epochs[k].survey, alone, progress)
                    .noise_scale;
        }
        scaled[k].survey = with_noise_times(std::move(scaled[k].survey), noise_scales[k]);
    }
    EpochChain each(net, scaled, options, first.law,
                    net.adjustable_edges().empty() ? 0.0 : small_play(scaled));
    each.find_changes(progress);
    for (int k = 1; k < each.count(); ++k) {
        if (are_too_many_changes(net, each.changes()[k].lengths.size())) {
            Identification none = each.found(k);
            none.status = IdentificationStatus::survey_does_not_fit;
            none.message =
                fmt::format("{}, and more than a tenth of all. {}",
                            contradiction_text(k, each.changes()[k].ratio), what_to_check);
            none.method = to_string(IdentificationMethod::map);
            return none;
        }
    }
    const std::vector<Epoch> changed = with_changes(net, scaled, each.changes());
    EpochChain chain(net, changed, options, first.law);
    chain.let_go(each.changes());
    const int last = chain.count() - 1;
    const bool has_settled = chain.settle(progress);
    Identification result = has_settled
                                ? identify_by_maximum_a_posteriori(
                                      chain.net_at(last), changed.back().survey, chain.told(last),
                                      {}, {.count = options.draws, .seed = options.seed}, progress)
                                : chain.found(last);
    for (int k = 0; !has_settled && k <= last; ++k) {
        if (chain.found(k).status != IdentificationStatus::converged) {
            result.status = chain.found(k).status;
            result.message = fmt::format("survey {}: {}", k + 1, chain.found(k).message);
        }
    }
    result.contradicted_law = first.contradicted_law;
    result.law_was_told = options.law.has_value();
    for (int k = 0; k <= last; ++k) {
        const Identification& found = k < last ? chain.found(k) : result;
        result.epochs.push_back({.surveyed = static_cast<int>(scaled[k].survey.surveyed.size()),
                                 .turned = epochs[k].turned,
                                 .outliers = found.outliers,
                                 .boundary_outliers = found.boundary_outliers,
                                 .frame_offset = found.frame_offset,
                                 .noise_ratio = found.noise_ratio,
                                 .noise_scale = noise_scales[k],
                                 .change_ratio = each.changes()[k].ratio,
                                 .changes = each.changes()[k].lengths,
                                 .stroke_factor = each.changes()[k].stroke_factor,
                                 .stroke_factor_std = each.changes()[k].stroke_factor_std,
                                 .trust = trust_of(chain.net_at(k), scaled[k].survey, found)});
    }
    for (const Epoch& epoch : epochs) {
        all_steps.push_back(epoch.turned);
    }
    result.turned = all_turned(all_steps);
    result.noise_scale = noise_scales.back();
    result.method = to_string(IdentificationMethod::map);
    result.method_reason = fmt::format("{} surveys are told", epochs.size());
    result.how = fmt::format("maximum a posteriori under the statics, by {} surveys, lengths {}",
                             epochs.size(), first.law.to_string());
    if (!options.unknowns.empty()) {
        result.how += ", unknown besides: " + to_string(options.unknowns);
    }
    result.trust = trust_of_epochs(net, result.epochs);
    return result;
}

}  // namespace taut
