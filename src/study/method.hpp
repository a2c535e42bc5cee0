// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/trial.hpp"
#include "taut/export/adjustment.hpp"
#include "taut/identification/model.hpp"
#include "taut/identification/result.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// A method of identification, ready to be tried on surveys of one net. It and its copies refer to
/// the net and the model that it was made with, which must outlive them; prior and uncertain are
/// copied. It throws and returns what identify() does. Several threads may call one at once unless
/// uses_all_threads says otherwise.
struct Method {
    std::string name;                     ///< "gp_as_in_paper", "gp", "balance" or "map"
    std::optional<int> training_samples;  ///< that it was trained on; empty: none are needed
    double training_seconds = 0.0;        ///< wall time, a share where trained with others [s]
    bool needs_all_nodes = false;         ///< takes no survey with hidden nodes
    /// Its dense algebra uses all threads: it and its copies may be called from one thread at a
    /// time only.
    bool uses_all_threads = false;
    /// Identifies lengths from the surveys of a trial, without using its truth.
    std::function<Identification(const Trial&)> identify;
    /// The same for many trials, by their index, where common work is faster done at once; may be
    /// empty. The function it returns refers to the trials.
    std::function<std::function<Identification(size_t)>(const std::vector<Trial>&)> identify_each;
};

/// "gp_as_in_paper": what identify() does with a model trained as in the paper. The predicted form
/// may be out of balance.
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Method method_as_in_paper(const CableNet& net,
                                                               const LengthModel& model);

/// "gp": what identify() does with any other model.
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Method method_by_processes(const CableNet& net,
                                                                const LengthModel& model);

/// "balance".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Method method_by_force_balance(const CableNet& net,
                                                                    const LengthPrior& prior);

/// "map".
/// @param uncertain besides the lengths
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Method
method_by_maximum_a_posteriori(const CableNet& net, const LengthPrior& prior,
                               const std::vector<UncertainParameter>& uncertain = {});

/// "map" of all surveys of a trial at once, identify_epochs().
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Method method_by_epochs(const CableNet& net,
                                                             const LengthPrior& prior);

}  // namespace taut
