// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/pair.h>

#include <optional>
#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "dicts.hpp"
#include "states.hpp"
#include "taut/survey/cable_frequency.hpp"

namespace taut::python {
namespace {

std::optional<double> of_fundamental(const CableFrequency& self, double Fundamental::* field) {
    return self.fundamental ? std::optional((*self.fundamental).*field) : std::nullopt;
}

/// (n,) or (n, c).
Eigen::MatrixXd signals_argument(nb::handle value) {
    const auto signals = numbers(value, "signal");
    if (signals.ndim() != 1 && signals.ndim() != 2) {
        throw nb::value_error("signal: expected an array (n,) or (n, c)");
    }
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return Eigen::Map<const Rows>(
        signals.data(), static_cast<Eigen::Index>(signals.shape(0)),
        signals.ndim() == 1 ? 1 : static_cast<Eigen::Index>(signals.shape(1)));
}

}  // namespace

void bind_frequency(nb::module_& module) {
    nb::class_<CableFrequency> result(module, "CableFrequency",
                                      "What a record shows of a cable's natural frequencies.");
    make_picklable(result);
    result
        .def_prop_ro(
            "fundamental",
            [](const CableFrequency& self) {
                return of_fundamental(self, &Fundamental::frequency);
            },
            "Natural frequency of mode 1, by the fit to all modes [Hz]. None where something "
            "speaks against it: see message.")
        .def_prop_ro(
            "fundamental_std",
            [](const CableFrequency& self) { return of_fundamental(self, &Fundamental::std_dev); },
            "Its standard deviation [Hz].")
        .def_prop_ro(
            "inharmonicity",
            [](const CableFrequency& self) {
                return of_fundamental(self, &Fundamental::inharmonicity);
            },
            "B in f_n = n f_0 sqrt(1 + B n^2).")
        .def("to_dict", &dict_of_fields<CableFrequency>, nb::sig("def to_dict(self) -> dict"),
             "All of it, SI units.")
        .def("__repr__", [](const CableFrequency& self) {
            return self.fundamental
                       ? fmt::format("CableFrequency({:.4f} Hz, std {:.4f} Hz, {} peaks)",
                                     self.fundamental->frequency, self.fundamental->std_dev,
                                     self.peaks.size())
                       : fmt::format("CableFrequency(none: {})", self.message);
        });
    bind_fields<CableFrequency>(
        result, std::identity(),
        {{"peaks",
          "Ascending. Of each: frequency and std [Hz], level over the noise around it (a ratio of "
          "densities), mode (0: not explained)."},
         {"message", "Why there is no fundamental; else empty."},
         {"candidates",
          "Fundamentals that may explain the peaks, the likeliest first. Of each: frequency and "
          "std [Hz], inharmonicity, misfit (relative, RMS), modes of the peaks, probability."},
         {"warnings", "What is most likely wrong, a line each."},
         {"duration", "Of the record [s]."},
         {"resolution", "1 / length of a segment [Hz]."},
         {"spectrum_step", "Between values of spectrum, the first of which is at 0 [Hz]."},
         {"spectrum", "One-sided power spectral density, summed over the signals [unit^2/Hz]."}});
    module.def(
        "frequency",
        [](const ArrayLike& time, const ArrayLike& signal,
           const std::optional<std::pair<double, double>>& range) {
            const Eigen::MatrixXd signals = signals_argument(signal);
            const Eigen::VectorXd times = vector_argument(time, "time", signals.rows());
            std::optional<FrequencyRange> within;
            if (range) {
                within = {.lowest = range->first, .highest = range->second};
            }
            return without_lock(
                [&] { return cable_frequency(evenly_sampled(times, signals), within); });
        },
        nb::arg("time"), nb::arg("signal"), nb::kw_only(),
        nb::arg("search_range").none() = nb::none(),
        R"(Finds the fundamental of a cable in a vibration record.

The spectrum is that of Welch (IEEE Trans. Audio Electroacoust. 15, 1967): Hann windows that overlap by
half. Modes are numbered by the string with bending stiffness between hinges (H. Fletcher, J. Acoust.
Soc. Am. 36, 1964), f_n = n f_0 sqrt(1 + B n^2).

Args:
    time: of each sample, ascending (n,) [s]. Uneven times are interpolated to even ones.
    signal: acceleration, or any signal that is linear in the motion (n,), or of several axes (n, c).
    search_range: where the fundamental is known to lie, (lowest, highest) [Hz].)");
}

}  // namespace taut::python
