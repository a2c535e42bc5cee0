// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/epoch_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "identification/epoch_net.hpp"
#include "identification/identify_options.hpp"
#include "sampling/uncertain_widths.hpp"
#include "taut/identification/force_units.hpp"

namespace taut {
namespace {

/// Two surveys of which most targets agree to the last digit are one, counted twice.
bool is_repeated(const Survey& a, const Survey& b) {
    std::vector<int> both;
    std::ranges::set_intersection(a.surveyed, b.surveyed, std::back_inserter(both));
    const auto same =
        std::ranges::count_if(both, [&](int node) { return a.form.col(node) == b.form.col(node); });
    return !both.empty() && 2 * same > std::ssize(both);
}

void check_options(const CableNet& net, std::span<const Epoch> epochs,
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
    check_draws(net, draws_wanted(net, options));
    check_uncertain_parameters(net, options.uncertain);
    check_forces(net, options.forces);
    (void)force_unit_warning(net, options.forces.measurements);
    const double steps = std::sqrt(static_cast<double>(epochs.size()) - 1.0);
    if (const double creep = std_of(options.uncertain, UncertainParameter::Kind::creep);
        creep * steps > most_creep) {
        throw std::invalid_argument(
            fmt::format("a creep of {:.3g} % strains edges by more than 1 % in {} surveys, "
                        "expected less",
                        1e2 * creep, epochs.size()));
    }
}

void check_changes_before(const CableNet& net, std::span<const Epoch> epochs, size_t k) {
    check_turned(net, epochs[k].turned);
    const Points& loads = epochs[k].loads;
    if (epochs[k].is_loaded() && (loads.cols() != net.node_count() || !loads.allFinite())) {
        throw std::invalid_argument(
            fmt::format("the loads at survey {} are {} columns, expected one finite force a "
                        "node: {}",
                        k + 1, loads.cols(), net.node_count()));
    }
    try {
        check_turned(net, turned_until(epochs, k));
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("until survey {} {}", k + 1, error.what()));
    }
}

}  // namespace

void check_epochs(const CableNet& net, std::span<const Epoch> epochs,
                  const IdentifyOptions& options) {
    check_options(net, epochs, options);
    check_forces_on_runs(net, options.forces);
    for (size_t k = 0; k < epochs.size(); ++k) {
        const Survey& survey = epochs[k].survey;
        with_epoch(k, [&] { check_survey(net, survey); });
        check_changes_before(net, epochs, k);
        if (!survey.is_noisy()) {
            throw EpochError(static_cast<int>(k),
                             "is exact: several surveys need their noise (standard deviations)");
        }
        for (size_t j = 0; j < k; ++j) {
            if (is_repeated(epochs[j].survey, survey)) {
                throw EpochError(static_cast<int>(k),
                                 fmt::format("repeats survey {} as survey {} to the last digit: "
                                             "one survey would be counted twice",
                                             j + 1, k + 1));
            }
        }
    }
}

int reported_epoch(std::span<const Epoch> epochs) {
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
    return static_cast<int>(k) - 1;
}

}  // namespace taut
