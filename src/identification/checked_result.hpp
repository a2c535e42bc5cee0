// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "taut/identification/result.hpp"
#include "taut/identification/trust.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// By which scales a width given too small makes intervals hold less than 90 % instead of 95 %.
inline constexpr double far_too_small = 1.2;

/// Something else than noise or the prior of the lengths that is not as given.
struct OtherCause {
    double gain = 0.0;  ///< by which it makes the survey likelier, logarithm
    std::string name;
    bool is_load_likeliest = false;  ///< a missing one, of it, scale, frame and common mean

    [[nodiscard]] std::string advice() const;
};

/// A result whose assumptions are checked, and what was found. Keeps references to all three.
struct CheckedResult {
    const CableNet& net;
    const Survey& survey;
    const Identification& result;
    OtherCause other_cause;       ///< (other-causes): the one that explains most
    std::vector<int> noise_axes;  ///< along which the survey scatters more than along others
    Trust trust;

    CheckedResult(const CableNet& of_net, const Survey& of_survey, const Identification& found);

    void add(Trust::Finding finding) { trust.findings.push_back(std::move(finding)); }
    /// Of the worst of these axes, or of all.
    [[nodiscard]] const FoundScale& noise() const;
    /// (other-causes): whether noise explains more than the other cause, or is as given.
    [[nodiscard]] bool is_noise_likelier() const;
    /// Whether the survey scatters along one axis significantly more than along another.
    [[nodiscard]] bool has_uneven_noise() const;
    /// Whether the survey is of another scale, by more than is lost in its noise at the node
    /// furthest out.
    [[nodiscard]] bool has_scale() const;
    [[nodiscard]] bool has_mean() const;  ///< of all lengths, that does harm
    /// Whether so many lengths are outliers that the prior is too narrow rather than each cable
    /// wrong.
    [[nodiscard]] bool has_narrow_prior() const;
};

/// Up to six of the names, and how many more there are.
[[nodiscard]] std::string and_more(std::vector<std::string> names);

/// "0.40 +- 0.10 mm longer"
/// @param deviation, std [m]
/// @param bound before the number
[[nodiscard]] std::string longer_text(double deviation, double std_dev,
                                      std::string_view bound = "");

// Each adds the findings of one kind of check, docs/theory.md, Diagnostics.
void test_loads(CheckedResult& of);  ///< (load-check)
void test_frame(CheckedResult& of);
void test_noise(CheckedResult& of);
void test_targets(CheckedResult& of);
/// Where cables stretch by less than their lengths are known to, the form of the mean lengths may
/// be off by the width of the prior; not by far more.
void test_prediction(CheckedResult& of);
void test_places(CheckedResult& of);  ///< points whose names are other nodes'
void test_names(CheckedResult& of);
void test_prior(CheckedResult& of);
void test_lengths(CheckedResult& of);
void test_boundary(CheckedResult& of);
void test_elastic_supports(CheckedResult& of);
void test_forces(CheckedResult& of);
void test_uncertain(CheckedResult& of);

/// (given-stiffness): adds where force measurements or known loads contradict the stiffness as
/// given, with 95 %.
/// @param by_loads which of both
void add_given_stiffness(Trust& trust, const Identification& result, bool by_loads);

}  // namespace taut
