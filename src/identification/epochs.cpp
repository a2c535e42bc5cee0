// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/epochs.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "estimation/hyperprior.hpp"
#include "identification/assumptions.hpp"
#include "identification/epoch_chain.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/prior_mixture.hpp"
#include "net/rounded_length.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;
using FindingKind = Trust::Finding::Kind;

/// A survey whose changes exceed the expected ones by this factor contradicts the others.
constexpr double far_too_much = 1.5;

using Kind = UncertainParameter::Kind;

/// Whether every survey has its own in the chain, though all surveys have the same.
bool is_of_each_survey(const UncertainParameter& parameter) {
    return parameter.kind == Kind::supports || parameter.kind == Kind::loads_each;
}

/// The same with other widths of what each survey has its own of, (epoch-own).
IdentifyOptions with_own_widths(const CableNet& net, IdentifyOptions options, double factor) {
    const double widest_support = net.unstressed_lengths().minCoeff() / 3.0;  // may be uncertain
    for (UncertainParameter& one : options.uncertain) {
        if (is_of_each_survey(one)) {
            one.std *= factor;
        }
        if (one.kind == Kind::supports) {
            one.std = std::min(one.std, widest_support);
        }
    }
    return options;
}

/// In estimates of a chain: widths of with_own_widths() and of creep, as they were given.
void name_given_widths(Identification& result, const std::vector<UncertainParameter>& given) {
    for (ParameterEstimate& estimate : result.uncertain) {
        UncertainParameter& parameter = estimate.parameter;
        for (const UncertainParameter& one : given) {
            if ((is_of_each_survey(one) || one.kind == Kind::creep) && one.kind == parameter.kind &&
                one.group == parameter.group) {
                parameter.std = one.std;
            }
        }
    }
}

/// Two surveys of which most targets agree to the last digit are one, counted twice.
bool is_repeated(const Survey& a, const Survey& b) {
    std::vector<int> both;
    std::ranges::set_intersection(a.surveyed, b.surveyed, std::back_inserter(both));
    const auto same =
        std::ranges::count_if(both, [&](int node) { return a.form.col(node) == b.form.col(node); });
    return !both.empty() && 2 * same > std::ssize(both);
}

/// Runs an action, and names the survey in its errors.
template <class Action>
auto with_epoch(size_t k, const Action& action) {
    try {
        return action();
    } catch (const SurveyError& error) {
        throw EpochError(k, error.what());
    }
}

void check_epochs(const CableNet& net, std::span<const Epoch> epochs,
                  const IdentifyOptions& options) {
    if (epochs.size() < 2) {
        throw std::invalid_argument(
            fmt::format("epochs: {} given, expected at least two surveys", epochs.size()));
    }
    if (options.model != nullptr ||
        options.method.value_or(IdentificationMethod::map) != IdentificationMethod::map) {
        throw std::invalid_argument(
            "several surveys are identified by the method map, without a model");
    }
    if (!options.covariance_of.empty()) {
        throw std::invalid_argument("covariances of lengths are for one survey, not for several");
    }
    if (net.interior_edge_count() > most_edges_of_epochs) {
        throw std::invalid_argument(
            fmt::format("the net has {} interior edges, expected at most {} for several surveys",
                        net.interior_edge_count(), most_edges_of_epochs));
    }
    if (!epochs.front().turned.empty() || epochs.front().is_loaded()) {
        throw std::invalid_argument("nothing can be turned or hung on before the first survey");
    }
    static_cast<void>(reported_epoch(epochs));
    check_uncertain_parameters(net, options.uncertain);
    const double steps = std::sqrt(static_cast<double>(epochs.size()) - 1.0);
    if (const double creep = std_of(options.uncertain, Kind::creep); creep * steps > most_creep) {
        throw std::invalid_argument(
            fmt::format("a creep of {:.3g} % strains edges by more than 1 % in {} surveys, "
                        "expected less",
                        1e2 * creep, epochs.size()));
    }
    for (size_t k = 0; k < epochs.size(); ++k) {
        with_epoch(k, [&] { check_survey(net, epochs[k].survey); });
        check_turned(net, epochs[k].turned);
        if (epochs[k].is_loaded() &&
            (epochs[k].loads.cols() != net.node_count() || !epochs[k].loads.allFinite())) {
            throw std::invalid_argument(
                fmt::format("the loads at survey {} are {} columns, expected one finite force a "
                            "node: {}",
                            k + 1, epochs[k].loads.cols(), net.node_count()));
        }
        try {
            check_turned(net, turned_until(epochs, k));
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(fmt::format("until survey {} {}", k + 1, error.what()));
        }
        if (!epochs[k].survey.is_noisy()) {
            throw EpochError(k, "is exact: several surveys need their noise (standard deviations)");
        }
        for (size_t j = 0; j < k; ++j) {
            if (is_repeated(epochs[j].survey, epochs[k].survey)) {
                throw EpochError(k, fmt::format("repeats survey {} as survey {} to the last digit: "
                                                "one survey would be counted twice",
                                                j + 1, k + 1));
            }
        }
    }
}

/// Far below what a survey shows.
double small_actuator_std(const std::vector<Epoch>& epochs) {
    constexpr double part_of_noise = 0.05;
    double noise = std::numeric_limits<double>::infinity();
    for (const Epoch& epoch : epochs) {
        const Points stds = epoch.survey.noise_std(Eigen::all, epoch.survey.surveyed);
        noise = std::min(noise, std::sqrt(stds.squaredNorm() / static_cast<double>(stds.size())));
    }
    return part_of_noise * noise;
}

constexpr const char* what_to_check =
    "Check the turns given, and the loads that hung on the net (signs, units, which nodes and "
    "file), "
    "and that both surveys are of this net.";

std::string contradiction_text(size_t before, double ratio) {
    return fmt::format(
        "Between surveys {} and {} the lengths changed {:.2g} times as much as chance allows.",
        before, before + 1, ratio);
}

std::string strokes_text(size_t before, double factor, double std) {
    return fmt::format(
        "Between surveys {} and {} all edges were turned {:.3f} +- {:.3f} times as far as given.",
        before, before + 1, factor, std);
}

std::string change_text(const LengthChange& change) {
    return fmt::format("{:+.2f} +- {:.2f} mm", 1e3 * change.change, 1e3 * change.std);
}

/// Reports adjustable edges that at the first survey are not as long as in the net.
void add_start(Trust& trust, const CableNet& net, const EpochResult& first) {
    for (const LengthChange& change : first.changes) {
        trust.findings.push_back(
            {.kind = FindingKind::adjustable_edge,
             .severity = Verdict::doubtful,
             .ids = {net.edge_id(change.edge)},
             .value = change.change,
             .std = change.std,
             .reason = fmt::format("At the first survey adjustable edge {} differs by {} from the "
                                   "length given. taut used the length that the surveys show.",
                                   net.edge_id(change.edge), change_text(change)),
             .next = "Read the turnbuckle there."});
    }
}

/// An edge that did not change as it was turned: that nothing was turned is the first thing to ask.
Trust::Finding change_finding(const CableNet& net, const EpochResult& epoch,
                              const LengthChange& change, const std::string& between) {
    Trust::Finding finding{
        .kind = FindingKind::length_change,
        .severity = Verdict::doubtful,
        .ids = {net.edge_id(change.edge)},
        .value = change.change,
        .std = change.std,
        .reason = fmt::format("{} the length of edge {} changed by {}. taut gave each survey a "
                              "length of its own for it.",
                              between, net.edge_id(change.edge), change_text(change)),
        .next =
            "If it was turned, add it to the turns. Else check whether it slipped, was slack "
            "at one survey, or a support at it moved."};
    const auto turned = std::ranges::find(epoch.turned, change.edge, &EdgeTurned::edge);
    if (turned != epoch.turned.end()) {
        finding.reason = fmt::format(
            "{} edge {} is given as turned by {:+.2f} mm, but its length changed by {:+.2f} +- "
            "{:.2f} mm. taut gave each survey a length of its own for it.",
            between, net.edge_id(change.edge), 1e3 * turned->stroke,
            1e3 * (turned->stroke + change.change), 1e3 * change.std);
        finding.next = "Check whether it was turned as given, and which way.";
    }
    return finding;
}

/// (creep) that was not given.
/// @param widest that may be given for so many surveys
Trust::Finding creep_finding(const EpochChain::Changes::CommonStrain& strain, double widest,
                             const std::string& between) {
    const UncertainParameter creep{
        .kind = Kind::creep, .std = to_digits(std::abs(strain.strain), 2), .group = strain.group};
    return {.kind = FindingKind::uncertain_parameter,
            .severity = Verdict::doubtful,
            .ids = {std::string(creep.name()) + (creep.group.empty() ? "" : "@" + creep.group)},
            .value = strain.strain,
            .std = strain.std,
            .remedy = Trust::Remedy{"uncertain", creep.std < widest ? creep.to_string() : ""},
            .reason = fmt::format(
                "{} the lengths of {} changed by {:+.2f} +- {:.2f} % in common.", between,
                strain.group.empty() ? "all interior edges"
                                     : fmt::format("the edges of group {}", strain.group),
                1e2 * strain.strain, 1e2 * strain.std),
            .next =
                "Check the temperature of both surveys, and that they have one scale. If the "
                "cables creep or bed in, state it."};
}

/// Reports how lengths changed before a survey, besides the turns given.
void add_changes(Trust& trust, const CableNet& net, const EpochResult& epoch,
                 const EpochChain::Changes& changes, double widest_creep, size_t k) {
    const std::string between = fmt::format("Between surveys {} and {}", k, k + 1);
    const bool is_significant = epoch.change_ratio > epoch.change_limit;
    const Trust::Finding contradiction{.kind = FindingKind::epoch,
                                       .severity = Verdict::doubtful,
                                       .value = epoch.change_ratio,
                                       .reason = contradiction_text(k, epoch.change_ratio),
                                       .next = what_to_check};
    const bool are_strokes_off =
        std::abs(epoch.stroke_factor - 1.0) > significant_std * epoch.stroke_factor_std;
    if (is_significant && epoch.change_ratio > far_too_much && !are_strokes_off) {
        trust.findings.push_back(contradiction);
        trust.findings.back().severity = Verdict::failed;
        if (changes.common_strain) {
            trust.findings.push_back(creep_finding(*changes.common_strain, widest_creep, between));
        }
        return;
    }
    if (are_strokes_off) {
        trust.findings.push_back(
            {.kind = FindingKind::turns,
             .severity = Verdict::failed,
             .value = epoch.stroke_factor,
             .std = epoch.stroke_factor_std,
             .reason = strokes_text(k, epoch.stroke_factor, epoch.stroke_factor_std),
             .next = "Check the sign and unit of what was turned, and the length of a turn."});
    }
    for (const LengthChange& change : epoch.changes) {
        trust.findings.push_back(change_finding(net, epoch, change, between));
    }
    if (changes.common_strain) {
        trust.findings.push_back(creep_finding(*changes.common_strain, widest_creep, between));
    } else if (epoch.excess_actuator_std > 0.0) {
        trust.findings.push_back(
            {.kind = FindingKind::actuator_std,
             .severity = Verdict::doubtful,
             .value = epoch.excess_actuator_std,
             .reason = fmt::format("{} turns differ from those given by {:.2f} mm (root mean "
                                   "square), more than the standard deviation given. taut took it "
                                   "into account.",
                                   between, 1e3 * epoch.excess_actuator_std),
             .next = "Give it as the standard deviation of what was turned."});
    } else if (is_significant) {
        trust.findings.push_back(contradiction);
    }
}

/// Reports surveys with the same errors: they would count twice.
void add_repeats(Trust& trust, const EpochChain& chain) {
    constexpr double too_close = 0.7;
    for (int b = 1; b < chain.count(); ++b) {
        for (int a = 0; a < b; ++a) {
            const double difference = chain.difference_ratio(a, b);
            if (difference > 0.0 && difference < too_close) {
                trust.findings.push_back(
                    {.kind = FindingKind::repeated_survey,
                     .severity = Verdict::doubtful,
                     .value = difference,
                     .reason = fmt::format("Surveys {} and {} have the same errors: they differ by "
                                           "{:.2g} times what chance allows.",
                                           a + 1, b + 1, difference),
                     .next =
                         "Check that they are two surveys. If so, errors of the targets "
                         "themselves are in both, and the second adds less than taut assumes."});
            }
        }
    }
}

Trust trust_of_epochs(const CableNet& net, const std::vector<EpochResult>& epochs,
                      const std::vector<EpochChain::Changes>& changes) {
    Trust trust;
    for (size_t k = 0; k < epochs.size(); ++k) {
        for (const Trust::Finding& finding : epochs[k].trust.findings) {
            trust.findings.push_back(finding);
            trust.findings.back().reason = fmt::format("Survey {}: {}", k + 1, finding.reason);
        }
    }
    add_start(trust, net, epochs.front());
    const double widest_creep = most_creep / std::sqrt(static_cast<double>(epochs.size()) - 1.0);
    for (size_t k = 1; k < epochs.size(); ++k) {
        add_changes(trust, net, epochs[k], changes[k], widest_creep, k);
    }
    return trust;
}

/// The surveys with their noise estimated, with turns uncertain.
/// @param scales on return the factors on the noise
std::vector<Epoch> with_noise_found(const CableNet& net, std::span<const Epoch> epochs,
                                    const IdentifyOptions& alone, std::vector<double>& scales,
                                    const Progress& progress) {
    IdentifyOptions of_form = alone;
    if (!net.adjustable_edges().empty()) {
        std::erase_if(of_form.uncertain,
                      [](const auto& one) { return one.kind == Kind::adjustable; });
        of_form.uncertain.push_back(
            {.kind = Kind::adjustable,
             .std = std::max(std_of(alone.uncertain, Kind::adjustable), widest_turn(net)),
             .group = {}});
    }
    std::vector<Epoch> result(epochs.begin(), epochs.end());
    for (size_t k = 0; k < epochs.size(); ++k) {
        if (k > 0) {
            scales[k] = with_epoch(k, [&] {
                return identify(net_at_survey(net, epochs, k), epochs[k].survey, of_form, progress)
                    .noise_scale;
            });
        }
        result[k].survey = with_noise_times(std::move(result[k].survey), scales[k]);
    }
    return result;
}

/// Gives the widths in a result the names under which they were given or assumed.
using NameWidths = std::function<void(Identification&)>;

/// The results of the single surveys.
/// @param first the first survey alone, which gives the prior
std::vector<EpochResult> epoch_results(const EpochChain& chain, const Identification& first,
                                       const std::vector<EpochChain::Changes>& changes,
                                       const std::vector<Epoch>& epochs,
                                       const std::vector<double>& noise_scales,
                                       const NameWidths& name_widths) {
    std::vector<EpochResult> results;
    for (int k = 0; k < chain.count(); ++k) {
        Identification found = chain.found(k);
        name_widths(found);
        if (k == 0) {
            found.contradicted_prior = first.contradicted_prior;
            found.prior_was_given = first.prior_was_given;
        }
        const Survey& survey = epochs[static_cast<size_t>(k)].survey;
        const EpochChain::Changes& changed = changes[static_cast<size_t>(k)];
        results.push_back({.surveyed = static_cast<int>(survey.surveyed.size()),
                           .turned = epochs[static_cast<size_t>(k)].turned,
                           .load = epochs[static_cast<size_t>(k)].loads.colwise().norm().sum(),
                           .outliers = found.outliers,
                           .boundary_outliers = found.boundary_outliers,
                           .frame_offset = found.frame_offset,
                           .noise_ratio = found.noise_ratio,
                           .noise_scale = noise_scales[static_cast<size_t>(k)],
                           .change_ratio = changed.agreement.ratio(),
                           .change_limit = changed.agreement.limit(),
                           .changes = changed.lengths,
                           .excess_actuator_std = changed.excess_actuator_std,
                           .stroke_factor = changed.stroke_factor,
                           .stroke_factor_std = changed.stroke_factor_std,
                           .trust = trust_of(chain.net_at(k), survey, found)});
    }
    return results;
}

/// What identify_epochs() has found before all surveys are added up.
struct Comparison {
    const CableNet& net;
    const std::vector<Epoch>& epochs;  ///< with their noise
    const IdentifyOptions& options;    ///< with_own_widths()
    const std::vector<EpochChain::Changes>& changes;
};

Identification last_of(const EpochChain& chain, const Comparison& of,
                       const PosteriorSettings& wanted, const Progress& progress) {
    const int k = chain.reported();
    return identify_by_maximum_a_posteriori(chain.net_at(k),
                                            of.epochs[static_cast<size_t>(k)].survey,
                                            chain.given(k), {}, wanted, progress);
}

/// (prior-mixture) of all surveys, by the posterior of the prior that the first one leaves.
/// @return empty where one prior does, and where the surveys converge under too few
std::optional<Identification> over_priors(const Comparison& of, const std::vector<PriorNode>& nodes,
                                          const Progress& progress) {
    if (nodes.size() < 2) {
        return std::nullopt;
    }
    const size_t reported = reported_epoch(of.epochs);
    return mixture_over(
        net_at_survey(of.net, of.epochs, reported), of.epochs[reported].survey, nodes,
        {.count = of.options.draws, .seed = of.options.seed},
        [&](size_t k, const PosteriorSettings& wanted) -> std::optional<Identification> {
            EpochChain chain(of.net, of.epochs, of.options, nodes[k].prior, 0.0, of.changes);
            return chain.converge(progress) ? std::optional(last_of(chain, of, wanted, progress))
                                            : std::nullopt;
        });
}

Identification identify_all(const CableNet& net, std::span<const Epoch> epochs,
                            const IdentifyOptions& options, const NameWidths& name_widths,
                            const Progress& progress) {
    check_epochs(net, epochs, options);
    IdentifyOptions alone = options;
    alone.method = IdentificationMethod::map;
    alone.draws = 0;
    alone.forces = {};
    std::erase_if(alone.uncertain,
                  [](const UncertainParameter& one) { return one.kind == Kind::creep; });
    // The first survey alone gives the prior and the noise where they are not given.
    const Identification first =
        with_epoch(0, [&] { return identify(net, epochs.front().survey, alone, progress); });
    // Surveys are compared under it, and added up under all that the first leaves.
    const LengthPrior prior = central_prior(first.prior);
    std::vector<double> noise_scales(epochs.size(), first.noise_scale);
    const std::vector<Epoch> scaled =
        options.estimate_noise ? with_noise_found(net, epochs, alone, noise_scales, progress)
                               : std::vector<Epoch>(epochs.begin(), epochs.end());
    const double least_actuator_std =
        net.adjustable_edges().empty() ? 0.0 : small_actuator_std(scaled);
    // By trial: of two surveys' most cancels, but not where a load moves the edges in between.
    const double left_of_own = std::ranges::any_of(epochs, &Epoch::is_loaded) ? 1.0 : 0.5;
    const IdentifyOptions to_compare = with_own_widths(net, options, left_of_own);
    EpochChain each(net, scaled, to_compare, prior, least_actuator_std);
    const bool is_compared = each.find_changes(progress);
    const int last = each.count() - 1;
    const size_t reported = reported_epoch(epochs);
    std::vector<EpochChain::Changes> changed = each.changes();
    if (is_compared && to_compare.uncertain != options.uncertain) {
        // With the net it does not.
        EpochChain start(net, std::span(scaled).first(1), options, prior, least_actuator_std);
        changed[0] = start.find_changes(progress) ? start.changes()[0] : EpochChain::Changes();
    }
    Identification result;
    for (int k = 0; k <= last && result.status == IdentificationStatus::converged; ++k) {
        const EpochChain::Changes& changes = changed[static_cast<size_t>(k)];
        if (changes.is_of_all_turns) {
            result = each.found(each.reported());
            result.status = IdentificationStatus::survey_does_not_fit;
            result.message = fmt::format(
                "{} {}", strokes_text(k, changes.stroke_factor, changes.stroke_factor_std),
                what_to_check);
        }
        if (are_too_many_changes(net, changes.lengths.size())) {
            result = each.found(each.reported());
            result.status = IdentificationStatus::survey_does_not_fit;
            result.message =
                k == 0
                    ? fmt::format(
                          "At the first survey {} or more adjustable edges are not as long as "
                          "given. Check "
                          "that this is the net's file, and what was turned since it was written.",
                          changes.lengths.size())
                    : fmt::format("{} More than a tenth of all changed. {}",
                                  contradiction_text(k, changes.agreement.ratio()), what_to_check);
        }
    }
    Trust together;
    bool is_mixture = false;
    if (result.status == IdentificationStatus::converged) {
        const IdentifyOptions to_add =
            with_own_widths(net, options, std::sqrt(static_cast<double>(epochs.size())));
        EpochChain chain(net, scaled, to_add, prior, 0.0, changed);
        const std::optional<double> movement = chain.converge(progress);
        if (movement) {
            const Comparison of{net, scaled, to_add, changed};
            std::optional<Identification> mixture =
                first.prior.exact ? std::nullopt : over_priors(of, first.prior.nodes, progress);
            is_mixture = mixture.has_value();
            result = mixture ? *std::move(mixture)
                             : last_of(chain, of, {.count = options.draws, .seed = options.seed},
                                       progress);
            name_widths(result);
            add_repeats(together, chain);
        } else {
            result = chain.found(chain.reported());
        }
        for (int k = 0; !movement && k <= last; ++k) {
            if (chain.found(k).status != IdentificationStatus::converged) {
                result.status = chain.found(k).status;
                result.message = fmt::format("survey {}: {}", k + 1, chain.found(k).message);
            }
        }
        if (movement.value_or(0.0) > EpochChain::still) {
            together.findings.push_back(
                {.kind = FindingKind::no_convergence,
                 .severity = Verdict::doubtful,
                 .value = movement,
                 .reason = fmt::format("The estimate from all surveys had not converged: it still "
                                       "moved by {:.2g} standard deviations.",
                                       *movement),
                 .next = "Identify from the last survey alone, and compare."});
        }
        result.epochs = epoch_results(chain, first, changed, scaled, noise_scales, name_widths);
        result.epochs[reported].trust =
            trust_of(chain.net_at(chain.reported()), scaled[reported].survey, result);
    } else {
        result.epochs = epoch_results(each, first, changed, scaled, noise_scales, name_widths);
    }
    if (!is_compared) {
        together.findings.push_back(
            {.kind = FindingKind::epoch,
             .severity = Verdict::doubtful,
             .reason = "taut could not test whether lengths changed between the surveys: not every "
                       "survey converged with its adjustable lengths uncertain.",
             .next = "Look at each survey by itself."});
    }
    name_widths(result);
    const CommonDeviation common = result.prior.common;  // of all surveys
    result.prior = first.prior;
    result.prior.common = common;
    if (!is_mixture) {
        result.prior.nodes = {{.prior = prior}};
    }
    result.contradicted_prior = first.contradicted_prior;
    result.prior_was_given = options.prior.has_value();
    result.turned = turned_until(epochs, epochs.size() - 1);
    result.noise_scale = noise_scales[reported];
    result.method = to_string(IdentificationMethod::map);
    result.method_reason = fmt::format("{} surveys are given", epochs.size());
    result.how = fmt::format(
        "maximum a posteriori under the statics, by {} surveys, lengths {}{}", epochs.size(),
        prior.to_string(), first.contradicted_prior ? ", a prior that the first survey shows" : "");
    result.assumptions = assumptions_of(options.uncertain, options.uncertain, result);
    result.trust = trust_of_epochs(net, result.epochs, changed);
    std::ranges::move(together.findings, std::back_inserter(result.trust.findings));
    std::ranges::stable_sort(result.trust.findings, std::greater{}, &Trust::Finding::severity);
    return result;
}

}  // namespace

size_t reported_epoch(std::span<const Epoch> epochs) {
    size_t k = epochs.size();
    while (k > 0 && epochs[k - 1].is_loaded()) {
        --k;
        if (!epochs[k].turned.empty()) {
            throw std::invalid_argument(fmt::format(
                "survey {} was made after turns and under loads hung on the net, and none since "
                "without them: expected one, which the result is of",
                k + 1));
        }
    }
    if (k == 0) {
        throw std::invalid_argument("every survey was made under loads hung on the net");
    }
    return k - 1;
}

Identification identify_epochs(const CableNet& net, std::span<const Epoch> epochs,
                               const IdentifyOptions& options, const Progress& progress) {
    if (!options.assume_site) {
        return identify_all(
            net, epochs, options,
            [&](Identification& result) { name_given_widths(result, options.uncertain); },
            progress);
    }
    IdentifyOptions on_site = options;
    on_site.assume_site = false;
    KnownForces forces = measured_by(options.forces);
    forces.by_loads = std::ranges::any_of(epochs, &Epoch::is_loaded);
    std::vector<UncertainParameter> uncertain =
        with_site_assumptions(net, options.uncertain, forces);
    // With a mass as uncertain as the stiffness the chain does not converge where the weight
    // makes the tension.
    const bool by_mass =
        std::ranges::any_of(options.forces.measurements, &ForceMeasurement::is_by_mass);
    std::erase_if(uncertain, [&](const UncertainParameter& one) {
        return one.kind == Kind::mass && !by_mass &&
               std::ranges::find(options.uncertain, one) == options.uncertain.end();
    });
    on_site.uncertain = with_uncertain_widths(uncertain, options.uncertain);
    Identification result = identify_all(
        net, epochs, on_site,
        [&](Identification& found) {
            name_given_widths(found, on_site.uncertain);
            name_assumed_widths(found, uncertain, options.uncertain);
        },
        progress);
    result.assumptions = assumptions_of(uncertain, options.uncertain, result);
    return result;
}

}  // namespace taut
