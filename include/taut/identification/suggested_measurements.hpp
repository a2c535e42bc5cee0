// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/progress.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/forces.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// What can be measured besides the targets of a survey.
enum class MeasurementKind {
    load_cell,  ///< the tension of an edge, to 2 %, by a load cell or a tension meter
    frequency,  ///< the first natural frequency of an edge
    sag,        ///< of an edge, by three points at its quarters
    target,     ///< a free node that the survey has no target on
    load,       ///< a second survey, while a known load hangs on a node; one at most
};

/// "load-cell", "frequency", "sag", "target", "load".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(MeasurementKind kind);

/// @throws std::invalid_argument for another word
[[nodiscard]] TAUT_CORE_EXPORT MeasurementKind parse_measurement_kind(std::string_view text);

/// What measurements are to make sure.
enum class SoughtQuantity {
    mean_tension,   ///< over all cables
    worst_tension,  ///< the one that is least known
    form,           ///< root mean square over all coordinates of the free nodes
};

/// "mean-tension", "worst-tension", "form".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(SoughtQuantity quantity);

/// @throws std::invalid_argument for another word
[[nodiscard]] TAUT_CORE_EXPORT SoughtQuantity parse_sought_quantity(std::string_view text);

/// How measurements are suggested.
struct SuggestOptions {
    SoughtQuantity quantity = SoughtQuantity::mean_tension;  ///< that is to become surer
    /// Cost of one measurement, positive, in any one unit; 1 of a kind that is not given.
    std::map<MeasurementKind, double> costs = {};
    double load = 0.0;              ///< hung on a node; 0: a twentieth of the mean tension [N]
    double frequency_std = 0.01;    ///< standard deviation, as a part of the frequency
    double free_length_std = 0.01;  ///< of a vibrating cable [m]
    int most = 5;                   ///< number of measurements
    /// Whether with_site_assumptions() hold for all kinds of measurements, and what lengths have in
    /// common is uncertain, as identify() takes it by default.
    bool assume_site = true;
};

/// A measurement, and what is left uncertain with it and those before it.
struct SuggestedMeasurement {
    MeasurementKind kind = MeasurementKind::target;  ///< what is measured
    int edge = -1;                                   ///< index in the net; -1: it is at a node
    int node = -1;                                   ///< index in the net; -1: it is at an edge
    double expected = 0.0;  ///< as designed: tension [N], frequency [Hz], sag [m]; the load [N]
    double std_dev = 0.0;   ///< standard deviation of the measurement, in that unit; 0: none
    double remaining_std = 0.0;  ///< of the sought quantity, see MeasurementSuggestions
    double total_cost = 0.0;     ///< with those before it
};

/// Which measurements to make next, one after the other.
struct MeasurementSuggestions {
    SoughtQuantity quantity = SoughtQuantity::mean_tension;  ///< that becomes surer
    double mean_tension = 0.0;                               ///< as designed [N]
    /// Standard deviation of the sought quantity by the survey alone: of tensions [N], of the form
    /// [m].
    double std_dev = 0.0;
    std::vector<SuggestedMeasurement> steps;  ///< none where none helps by one per cent
    std::vector<std::string> left_out;        ///< kinds that are not among them, and why
};

/// The measurements that lower a standard deviation most for their cost, after a survey: each the
/// best given those before it, by the exact update of the normal distribution that
/// predicted_precision() has, docs/theory.md (suggestion). A load is known to the width of
/// "test-loads", load cells share an error by "forces", frequencies and sags by "mass". Single
/// measurements are tried: where many edges are equally badly known, none lowers the worst tension.
/// @param form equilibrium of the nominal lengths (3 x n) [m]
/// @param survey which nodes, and their noise; its form is not used
/// @param forces that are measured anyhow; the tensions are not used
/// @param progress asked whether to stop; gets no reports
/// @throws Interrupted where a stop was requested
/// @throws std::invalid_argument as predicted_precision(); for a survey without noise; for costs
/// and standard deviations that
///   are not positive and finite (free_length_std: negative), a negative load, fewer than one
///   measurement, and a net of more than 3,000 coordinates and lengths
/// @throws SurveyError as predicted_precision()
/// @throws NumericalError likewise
[[nodiscard]] TAUT_CORE_EXPORT MeasurementSuggestions suggested_measurements(
    const CableNet& net, const Points& form, const Survey& survey, const LengthPrior& prior,
    const Forces& forces, const std::vector<UncertainParameter>& uncertain,
    const SuggestOptions& options = {}, const Progress& progress = {});

}  // namespace taut
