// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/cable_frequency.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "survey/mode_numbers.hpp"
#include "survey/spectrum_peaks.hpp"
#include "survey/welch_spectrum.hpp"

namespace taut {
namespace {

constexpr Eigen::Index fewest_samples = 256;
constexpr Eigen::Index most_numbers = Eigen::Index{1} << 27;
constexpr double fewest_periods = 10.0;   // of the fundamental in a record
constexpr Eigen::Index fewest_modes = 3;  // without a range
constexpr double likely = 0.95;           // of the probability of a fundamental
constexpr double highest_part = 0.4;      // of the rate: filters and interpolation blur more

void check_signals(const VibrationRecord& record) {
    const Eigen::MatrixXd& signals = record.signals;
    if (!(record.rate > 0.0) || !std::isfinite(record.rate)) {
        throw std::invalid_argument(
            fmt::format("the rate is {} Hz, expected a positive number", record.rate));
    }
    if (signals.rows() < fewest_samples || signals.cols() < 1) {
        throw std::invalid_argument(fmt::format("the record has {} samples, expected at least {}",
                                                signals.rows(), fewest_samples));
    }
    if (signals.size() > most_numbers) {
        throw std::invalid_argument(fmt::format("the record has {} numbers, expected at most {}",
                                                signals.size(), most_numbers));
    }
    if (!signals.allFinite() || signals.cwiseAbs().maxCoeff() > 1e100) {
        throw std::invalid_argument("the record holds a number that is not finite, or above 1e100");
    }
    if ((signals.colwise().maxCoeff() - signals.colwise().minCoeff()).maxCoeff() <= 0.0) {
        throw std::invalid_argument("the signals are constant: the sensor recorded no motion");
    }
}

/// Samples in a segment: an eighth of the record, so that 15 are averaged. Longer ones give peaks
/// of random vibration that are less certain, with standard deviations that are too small. More
/// than 100 s gain nothing: no peak of a cable is narrower.
Eigen::Index segment_length(const VibrationRecord& record) {
    constexpr double longest = 100.0;  // s
    const Eigen::Index part = record.signals.rows() / 8;
    return std::max<Eigen::Index>(std::min(part, static_cast<Eigen::Index>(longest * record.rate)),
                                  8);
}

std::string hertz(double frequency) {
    return fmt::format("{:.4g} Hz", frequency);
}

/// Mains are so steady, and so often in a record, that a fundamental there is none of a cable.
bool is_mains(const Fundamental& fundamental) {
    constexpr double tolerance = 0.002;
    return std::ranges::any_of(std::initializer_list<double>{50.0, 60.0}, [&](double mains) {
        return std::abs(fundamental.frequency - mains) <
               std::max(tolerance * mains, 3.0 * fundamental.std_dev);
    });
}

/// The fundamental of the peaks that another does not explain, if they have one.
std::optional<Fundamental> second_fundamental(const CableFrequency& found,
                                              const FrequencyRange& range) {
    std::vector<FrequencyPeak> rest;
    std::ranges::copy_if(found.peaks, std::back_inserter(rest),
                         [](const FrequencyPeak& peak) { return peak.mode == 0; });
    constexpr double suspicious = 0.5;
    const std::vector<Fundamental> others =
        rest.empty() ? std::vector<Fundamental>() : number_modes(rest, range, false);
    return !others.empty() && others.front().probability > suspicious && !is_mains(others.front())
               ? std::optional(others.front())
               : std::nullopt;
}

/// Sets why there is no fundamental, if something speaks against the likeliest one.
/// @param range of fundamentals
/// @param is_given whether by the caller
void object(CableFrequency& found, const FrequencyRange& range, bool is_given) {
    if (found.peaks.empty()) {
        found.message = fmt::format("no peak rises above the noise between {} and {}",
                                    hertz(found.searched.lowest), hertz(found.searched.highest));
        return;
    }
    if (found.candidates.empty()) {
        found.message = "no fundamental in the range explains a peak";
        return;
    }
    const Fundamental& first = found.candidates.front();
    const double periods = first.frequency * found.duration;
    if (periods < fewest_periods) {
        found.message = fmt::format("the record holds {:.1f} periods of {}, expected at least {:g}",
                                    periods, hertz(first.frequency), fewest_periods);
        return;
    }
    const auto seen = std::ranges::count_if(first.modes, [](int mode) { return mode > 0; });
    const bool is_sparse = 2 * seen < *std::ranges::max_element(first.modes);
    std::optional<Fundamental> second = second_fundamental(found, range);
    if (first.probability < likely && found.candidates.size() > 1 &&
        found.candidates[1].probability > 0.1 * first.probability) {
        second = found.candidates[1];
    }
    if (!is_given && seen < fewest_modes) {
        found.message = fmt::format(
            "no fundamental explains {} peaks, and of fewer the modes are not known", fewest_modes);
    } else if (second) {
        found.message = fmt::format("fundamentals of {} and {} explain peaks about equally well",
                                    hertz(first.frequency), hertz(second->frequency));
    } else if (first.probability < likely || (!is_given && is_sparse)) {
        found.message = "no fundamental explains enough of the peaks";
    } else if (!is_given && is_mains(first)) {
        found.message = fmt::format("the fundamental of {} is most likely that of the mains",
                                    hertz(first.frequency));
    }
    found.needs_range = !found.message.empty();
}

std::vector<std::string> warnings_of(const VibrationRecord& record, const CableFrequency& found) {
    constexpr double large_jitter = 0.1;
    std::vector<std::string> warnings;
    if (record.is_resampled && record.jitter > large_jitter) {
        warnings.push_back(fmt::format(
            "the time steps vary by {:.0f} % (RMS); interpolation to even steps weakens "
            "frequencies above {}",
            100.0 * record.jitter, hertz(0.25 * record.rate)));
    }
    const auto highest = std::ranges::max_element(found.peaks, {}, &FrequencyPeak::level);
    if (found.fundamental && highest->mode == 0) {
        warnings.push_back(fmt::format("the highest peak, {}, is none of the cable's modes",
                                       hertz(highest->frequency)));
    }
    return warnings;
}

}  // namespace

CableFrequency cable_frequency(const VibrationRecord& record,
                               const std::optional<FrequencyRange>& range) {
    check_signals(record);
    if (range &&
        !(range->lowest > 0.0 && range->highest > range->lowest && std::isfinite(range->highest))) {
        throw std::invalid_argument(
            fmt::format("the range is {:g} Hz to {:g} Hz, expected two positive frequencies, the "
                        "lower first",
                        range->lowest, range->highest));
    }
    WelchSpectrum spectrum = welch_spectrum(record, segment_length(record));
    CableFrequency found;
    found.duration = static_cast<double>(record.signals.rows()) / record.rate;
    found.resolution = spectrum.resolution;
    found.spectrum_step = spectrum.step;
    // Below, the window does not separate an oscillation from a trend.
    constexpr double least_cells = 3.0;
    found.searched = {.lowest = least_cells * spectrum.resolution,
                      .highest = highest_part * record.rate};
    found.peaks = spectrum_peaks(spectrum, found.duration, found.searched);
    found.spectrum = std::move(spectrum.density);
    // By default also those of too few periods, so that none of them passes as its octave.
    const FrequencyRange anywhere{.lowest = 2.0 / found.duration,
                                  .highest = found.searched.highest};
    const FrequencyRange within = range.value_or(anywhere);
    if (!found.peaks.empty()) {
        found.candidates = number_modes(found.peaks, within, range.has_value());
    }
    constexpr size_t most_candidates = 5;
    found.candidates.resize(std::min(found.candidates.size(), most_candidates));
    if (!found.candidates.empty()) {
        for (size_t i = 0; i < found.peaks.size(); ++i) {
            found.peaks[i].mode = found.candidates.front().modes[i];
        }
    }
    object(found, within, range.has_value());
    if (found.message.empty()) {
        found.fundamental = found.candidates.front();
    }
    found.warnings = warnings_of(record, found);
    if (range && found.fundamental) {
        const Fundamental likeliest = number_modes(found.peaks, anywhere, false).front();
        const double f = likeliest.frequency;
        if (likeliest.probability >= likely && (f < range->lowest || f > range->highest)) {
            found.warnings.push_back(fmt::format(
                "the peaks are rather those of a fundamental outside of the range, {}", hertz(f)));
        }
    }
    return found;
}

}  // namespace taut
