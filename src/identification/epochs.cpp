// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/epochs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "estimation/hyperprior.hpp"
#include "identification/assumptions.hpp"
#include "identification/checked_result.hpp"
#include "identification/epoch_chain.hpp"
#include "identification/epoch_checks.hpp"
#include "identification/epoch_findings.hpp"
#include "identification/epoch_net.hpp"
#include "identification/identify_options.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/prior_mixture.hpp"
#include "identification/repeated_surveys.hpp"
#include "numerics/memory_budget.hpp"
#include "sampling/uncertain_widths.hpp"

namespace taut {
namespace {

using Verdict = Trust::Verdict;
using FindingKind = Trust::Finding::Kind;
using Kind = UncertainParameter::Kind;

/// Gives the widths in a result the names under which they were given or assumed.
using NameWidths = std::function<void(Identification&)>;

/// Whether every survey has its own in the chain, though all surveys have the same.
bool is_of_each_survey(const UncertainParameter& parameter) {
    return parameter.kind == Kind::supports || parameter.kind == Kind::loads_each;
}

/// The same with other widths of what each survey has its own of, (epoch-own).
IdentifyOptions with_own_widths(const CableNet& net, IdentifyOptions options, double factor) {
    const double widest_support = net.unstressed_lengths().minCoeff() / 3.0;  // may be uncertain
    for (UncertainParameter& one : options.uncertain) {
        if (is_of_each_survey(one)) {
            one.std_dev *= factor;
        }
        if (one.kind == Kind::supports) {
            one.std_dev = std::min(one.std_dev, widest_support);
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
                parameter.std_dev = one.std_dev;
            }
        }
    }
}

/// Surveys with their standard deviations, which may be estimated.
struct ScaledEpochs {
    std::vector<Epoch> epochs;
    std::vector<double> noise_scales;  ///< factors on the noise given
};

/// @param first the first survey alone
/// @param alone options of one survey
ScaledEpochs scaled_epochs(const CableNet& net, std::span<const Epoch> epochs,
                           const Identification& first, const IdentifyOptions& alone,
                           const Progress& progress) {
    ScaledEpochs result{.epochs = {epochs.begin(), epochs.end()},
                        .noise_scales = std::vector<double>(epochs.size(), first.noise_scale)};
    if (!alone.estimate_noise) {
        return result;
    }
    IdentifyOptions with_turns_uncertain = alone;
    if (!net.adjustable_edges().empty()) {
        std::vector<UncertainParameter>& uncertain = with_turns_uncertain.uncertain;
        std::erase_if(uncertain, [](const auto& one) { return one.kind == Kind::adjustable; });
        uncertain.push_back(
            {.kind = Kind::adjustable,
             .std_dev = std::max(std_of(alone.uncertain, Kind::adjustable), widest_turn(net)),
             .group = {}});
    }
    for (size_t k = 0; k < epochs.size(); ++k) {
        double& scale = result.noise_scales[k];
        if (k > 0) {
            scale = with_epoch(k, [&] {
                return identify(net_at_survey(net, epochs, k), epochs[k].survey,
                                with_turns_uncertain, progress)
                    .noise_scale;
            });
        }
        result.epochs[k].survey = with_noise_times(std::move(result.epochs[k].survey), scale);
    }
    return result;
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

/// What is given of all surveys, with their noise.
struct Surveys {
    const CableNet& net;
    const IdentifyOptions& options;
    const ScaledEpochs& scaled;
    const Identification& first;  ///< the first survey alone, which gives the prior
    LengthPrior prior;            ///< central_prior() of that
    const NameWidths& name_widths;

    [[nodiscard]] const std::vector<Epoch>& epochs() const { return scaled.epochs; }
};

/// The surveys beside each other, each fitted by itself.
struct Comparison {
    EpochChain chain;
    bool is_compared = false;
    std::vector<EpochChanges> changes;  ///< by survey
};

Comparison compared(const Surveys& all, const Progress& progress) {
    const CableNet& net = all.net;
    const double least_actuator_std =
        net.adjustable_edges().empty() ? 0.0 : small_actuator_std(all.epochs());
    // By trial: of two surveys' most cancels, but not where a load moves the edges in between.
    const double left_of_own = std::ranges::any_of(all.epochs(), &Epoch::is_loaded) ? 1.0 : 0.5;
    const IdentifyOptions to_compare = with_own_widths(net, all.options, left_of_own);
    Comparison result{
        .chain = EpochChain(net, all.epochs(), to_compare, all.prior, least_actuator_std),
        .changes = {}};
    result.is_compared = result.chain.find_changes(progress);
    result.changes = result.chain.changes();
    if (result.is_compared && to_compare.uncertain != all.options.uncertain) {
        // With the net it does not.
        EpochChain start(net, std::span(all.epochs()).first(1), all.options, all.prior,
                         least_actuator_std);
        result.changes[0] = start.find_changes(progress) ? start.changes()[0] : EpochChanges();
    }
    return result;
}

/// Brings a result of a chain to the survey as it is: targets that (epoch-slip) left out are
/// outliers of it.
void add_left_out(Identification& result, const EpochChain& chain, int k, const Survey& survey,
                  const EpochChanges& changes) {
    if (result.predicted.form.cols() == 0) {
        return;
    }
    const Points misses = result.predicted.form - survey.form;
    for (const SlipOrTarget& either : changes.slips_or_targets) {
        if (!std::ranges::binary_search(chain.survey_at(k).surveyed, either.node)) {
            const double statistic = either.lengths.front().statistic;
            result.outliers.push_back({.node = either.node,
                                       .distance = misses.col(either.node).norm(),
                                       .statistic = statistic * statistic});
        }
    }
    result.residuals = misses(Eigen::all, survey.surveyed).colwise().norm().transpose();
}

/// The results of the single surveys.
std::vector<EpochResult> epoch_results(const EpochChain& chain, const Surveys& all,
                                       const std::vector<EpochChanges>& changes) {
    std::vector<EpochResult> results;
    for (int k = 0; k < chain.count(); ++k) {
        Identification found = chain.found(k);
        all.name_widths(found);
        if (k == 0) {
            found.contradicted_prior = all.first.contradicted_prior;
            found.prior_was_given = all.first.prior_was_given;
        }
        const Epoch& epoch = all.epochs()[static_cast<size_t>(k)];
        const EpochChanges& changed = changes[static_cast<size_t>(k)];
        Trust trust = trust_of(chain.net_at(k), chain.survey_at(k), found);
        add_left_out(found, chain, k, epoch.survey, changed);
        results.push_back({.surveyed = static_cast<int>(epoch.survey.surveyed.size()),
                           .turned = epoch.turned,
                           .load = epoch.loads.colwise().norm().sum(),
                           .outliers = found.outliers,
                           .boundary_outliers = found.boundary_outliers,
                           .frame_offset = found.frame_offset,
                           .noise_ratio = found.noise_ratio,
                           .noise_scale = all.scaled.noise_scales[static_cast<size_t>(k)],
                           .change_ratio = changed.agreement.ratio(),
                           .change_limit = changed.agreement.limit(),
                           .changes = changed.lengths,
                           .excess_actuator_std = changed.excess_actuator_std,
                           .stroke_factor = changed.stroke_factor,
                           .stroke_factor_std = changed.stroke_factor_std,
                           .trust = std::move(trust)});
    }
    return results;
}

Identification reported_of(const EpochChain& chain, const PosteriorSettings& wanted,
                           const Progress& progress) {
    const int k = chain.reported();
    return identify_by_maximum_a_posteriori(chain.net_at(k), chain.survey_at(k), chain.given(k), {},
                                            wanted, progress);
}

/// (prior-mixture) of all surveys, by the posterior of the prior that the first one leaves.
/// @param to_add with_own_widths()
/// @param reported the chain under one prior
/// @return empty where one prior does, and where the surveys converge under too few
std::optional<Identification> over_priors(const Surveys& all, const IdentifyOptions& to_add,
                                          const std::vector<EpochChanges>& changes,
                                          const EpochChain& reported, const Progress& progress) {
    const std::vector<PriorNode>& nodes = all.first.prior.nodes;
    if (all.first.prior.exact || nodes.size() < 2) {
        return std::nullopt;
    }
    return mixture_over(
        reported.net_at(reported.reported()), reported.survey_at(reported.reported()), nodes,
        {.count = draws_wanted(all.net, to_add), .seed = to_add.seed},
        [&](size_t k, const PosteriorSettings& wanted) -> std::optional<Identification> {
            EpochChain chain(all.net, all.epochs(), to_add, nodes[k].prior, 0.0, changes);
            return chain.converge(progress) ? std::optional(reported_of(chain, wanted, progress))
                                            : std::nullopt;
        });
}

/// The status and message of a survey that did not converge.
void set_failure(Identification& result, const EpochChain& chain) {
    for (int k = 0; k < chain.count(); ++k) {
        if (chain.found(k).status != IdentificationStatus::converged) {
            result.status = chain.found(k).status;
            result.message = fmt::format("survey {}: {}", k + 1, chain.found(k).message);
        }
    }
}

/// What all surveys together give.
struct Together {
    Identification result;
    bool is_mixture = false;  ///< over_priors()
    Trust trust;              ///< besides what each survey and the changes lead to
};

/// (epoch-slip) of targets that surveys reject together. Adds to the changes.
/// @return whether there are any
bool find_slips(const EpochChain& chain, std::vector<EpochChanges>& changes) {
    bool is_any = false;
    for (int k = 1; k < chain.count(); ++k) {
        for (const Outlier& one : chain.found(k).outliers) {
            if (std::optional<SlipOrTarget> slip = slip_to_target(
                    chain.net_at(k), chain.survey_at(k), chain.found(k).predicted.form, one)) {
                changes[static_cast<size_t>(k)].slips_or_targets.push_back(*std::move(slip));
                is_any = true;
            }
        }
    }
    return is_any;
}

/// All surveys added up, with the changes found.
/// @param changes gains those that all together show
Together added_up(const Surveys& all, std::vector<EpochChanges>& changes,
                  const Progress& progress) {
    const IdentifyOptions to_add =
        with_own_widths(all.net, all.options, std::sqrt(static_cast<double>(all.epochs().size())));
    const MemoryCharge of_draws =
        charge_numbers(numbers_of_draw(all.net) * draws_wanted(all.net, to_add));
    EpochChain chain(all.net, all.epochs(), to_add, all.prior, 0.0, changes);
    const std::optional<double> movement = chain.converge(progress);
    if (movement && find_slips(chain, changes)) {
        return added_up(all, changes, progress);  // without these targets
    }
    Together together;
    Identification& result = together.result;
    if (movement) {
        std::optional<Identification> mixture = over_priors(all, to_add, changes, chain, progress);
        together.is_mixture = mixture.has_value();
        result = mixture ? *std::move(mixture)
                         : reported_of(
                               chain, {.count = draws_wanted(all.net, to_add), .seed = to_add.seed},
                               progress);
        add_repeats(together.trust, chain);
    } else {
        result = chain.found(chain.reported());
        set_failure(result, chain);
    }
    if (movement.value_or(0.0) > EpochChain::still) {
        together.trust.findings.push_back(
            {.kind = FindingKind::no_convergence,
             .severity = Verdict::doubtful,
             .value = movement,
             .reason = fmt::format("The estimate from all surveys had not converged: it still "
                                   "moved by {:.2g} standard deviations.",
                                   *movement),
             .advice = "Identify from the last survey alone, and compare."});
    }
    all.name_widths(result);
    result.epochs = epoch_results(chain, all, changes);
    const int k = chain.reported();
    const auto place = static_cast<size_t>(k);
    result.epochs[place].trust = trust_of(chain.net_at(k), chain.survey_at(k), result);
    add_left_out(result, chain, k, all.epochs()[place].survey, changes[place]);
    return together;
}

/// Surveys that cannot be of one net: the one reported by itself.
Together apart(const Surveys& all, const Comparison& comparison, const std::string& contradiction) {
    Together together;
    Identification& result = together.result;
    result = comparison.chain.found(comparison.chain.reported());
    result.status = IdentificationStatus::survey_does_not_fit;
    result.message = contradiction;
    all.name_widths(result);
    result.epochs = epoch_results(comparison.chain, all, comparison.changes);
    return together;
}

/// Sets what the result says of how it was found.
void describe(Identification& result, const Surveys& all, bool is_mixture) {
    const CommonDeviation common = result.prior.common;  // of all surveys
    result.prior = all.first.prior;
    result.prior.common = common;
    if (!is_mixture) {
        result.prior.nodes = {{.prior = all.prior}};
    }
    result.contradicted_prior = all.first.contradicted_prior;
    result.prior_was_given = all.options.prior.has_value();
    const size_t count = all.epochs().size();
    result.turned = turned_until(all.epochs(), count - 1);
    result.noise_scale = all.scaled.noise_scales[reported_epoch(all.epochs())];
    result.method = to_string(IdentificationMethod::map);
    result.method_reason = fmt::format("{} surveys are given", count);
    result.description =
        fmt::format("maximum a posteriori under the statics, by {} surveys, lengths {}{}", count,
                    to_string(all.prior),
                    all.first.contradicted_prior ? ", a prior that the first survey shows" : "");
    result.assumptions = assumptions_of(all.options.uncertain, all.options.uncertain, result);
}

Identification identify_all(const CableNet& net, std::span<const Epoch> epochs,
                            const IdentifyOptions& options, const NameWidths& name_widths,
                            const Progress& progress) {
    check_epochs(net, epochs, options);
    IdentifyOptions alone = options;
    alone.method = IdentificationMethod::map;
    alone.draws = 0;
    alone.forces = {};
    std::erase_if(alone.uncertain, [](const auto& one) { return one.kind == Kind::creep; });
    // The first survey alone gives the prior and the noise where they are not given.
    const Identification first =
        with_epoch(0, [&] { return identify(net, epochs.front().survey, alone, progress); });
    const ScaledEpochs scaled = scaled_epochs(net, epochs, first, alone, progress);
    // Surveys are compared under its prior, and added up under all that the first leaves.
    const Surveys all{.net = net,
                      .options = options,
                      .scaled = scaled,
                      .first = first,
                      .prior = central_prior(first.prior),
                      .name_widths = name_widths};
    Comparison comparison = compared(all, progress);
    const std::string contradiction = contradiction_of(net, comparison.changes);
    Together together = contradiction.empty() ? added_up(all, comparison.changes, progress)
                                              : apart(all, comparison, contradiction);
    if (!comparison.is_compared) {
        together.trust.findings.push_back(
            {.kind = FindingKind::epoch,
             .severity = Verdict::doubtful,
             .reason = "taut could not test whether lengths changed between the surveys: not every "
                       "survey converged with its adjustable lengths uncertain.",
             .advice = "Look at each survey by itself."});
    }
    Identification& result = together.result;
    describe(result, all, together.is_mixture);
    result.trust = trust_of_epochs(net, result.epochs, comparison.changes);
    const bool is_loaded = std::ranges::any_of(epochs, &Epoch::is_loaded);
    if (is_loaded && result.force_measurements == 0 &&
        result.status == IdentificationStatus::converged) {
        add_given_stiffness(together.trust, result, true);
    }
    std::ranges::move(together.trust.findings, std::back_inserter(result.trust.findings));
    std::ranges::stable_sort(result.trust.findings, std::greater{}, &Trust::Finding::severity);
    return std::move(together.result);
}

}  // namespace

Identification identify_epochs(const CableNet& net, std::span<const Epoch> epochs,
                               const IdentifyOptions& options, const Progress& progress) {
    if (!options.assume_site.value_or(true)) {
        IdentifyOptions with_sliding = options;
        with_sliding.uncertain = with_slips(net, options.uncertain);
        return identify_all(
            net, epochs, with_sliding,
            [&](Identification& result) { name_given_widths(result, options.uncertain); },
            progress);
    }
    IdentifyOptions on_site = options;
    on_site.assume_site = false;
    KnownForces forces = measured_by(options.forces);
    forces.by_loads = std::ranges::any_of(epochs, &Epoch::is_loaded);
    std::vector<UncertainParameter> uncertain =
        with_site_assumptions(net, options.uncertain, forces);
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
