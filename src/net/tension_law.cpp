// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/net/tension_law.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace taut {
namespace {

/// Small enough that no product in the energy overflows.
constexpr double largest_entry = 1e15;

/// Over a smaller step the slope would be dominated by rounding errors of the strain.
constexpr double smallest_strain_step = 1e-12;

bool is_magnitude(double value) {
    return std::abs(value) <= largest_entry;  // false for NaN
}

std::string size_problem(const TensionLaw& law) {
    return fmt::format("has {} strains and {} tensions, expected equal numbers, two at least",
                       law.strain.size(), law.tension.size());
}

/// The rule that the law breaks between its points k - 1 and k, or nothing.
std::string problem_at(const TensionLaw& law, Eigen::Index k) {
    if (!(law.strain(k) - law.strain(k - 1) > smallest_strain_step)) {
        return fmt::format(
            "goes from strain {} to {} at point {}, expected it to ascend by more than {:g}",
            law.strain(k - 1), law.strain(k), k, smallest_strain_step);
    }
    if (law.tension(k) < law.tension(k - 1)) {
        return fmt::format("falls from {} to {} at point {}, expected that it never falls",
                           law.tension(k - 1), law.tension(k), k);
    }
    return "";
}

/// T of T^3 / EA - strain T^2 = S^2, (sagging-law). Newton's method from above on a function that
/// is convex there: it comes down to the root, and ends where rounding errors stop it.
double sagging_tension(double EA, double S, double strain) {
    const double k = std::cbrt(S / EA * (S / EA));
    double t = strain >= 0.0 ? strain + k : std::min(k, S / EA / std::sqrt(-strain));
    constexpr int most_steps = 100;
    for (int step = 0; step < most_steps; ++step) {
        const double value = t * t * (t - strain) - k * k * k;
        const double next = t - value / (t * (3.0 * t - 2.0 * strain));
        if (!(next < t)) {
            break;
        }
        t = next;
    }
    return EA * t;
}

}  // namespace

std::string problem_of(const TensionLaw& law) {
    const Eigen::Index count = law.strain.size();
    if (law.tension.size() != count || count < 2) {
        return size_problem(law);
    }
    for (Eigen::Index k = 0; k < count; ++k) {
        if (!is_magnitude(law.strain(k)) || !is_magnitude(law.tension(k))) {
            return fmt::format("has ({}, {}) at point {}, expected finite numbers of at most {:g}",
                               law.strain(k), law.tension(k), k, largest_entry);
        }
    }
    if (law.strain(0) != 0.0 || law.tension(0) != 0.0) {
        return fmt::format("starts at ({}, {}), expected (0, 0)", law.strain(0), law.tension(0));
    }
    for (Eigen::Index k = 1; k < count; ++k) {
        if (std::string problem = problem_at(law, k); !problem.empty()) {
            return problem;
        }
    }
    if (law.sag != 0.0 && (count != 2 || !(law.sag > 0.0) || !is_magnitude(law.sag))) {
        return fmt::format("has a sag of {} N and {} points, expected a positive sag and two",
                           law.sag, count);
    }
    if (law.tension(1) == 0.0) {
        return "is flat at its start, expected it to rise: an edge that is slack at first has a "
               "larger unstressed length";
    }
    if (law.tension(count - 1) == law.tension(count - 2)) {
        return "ends flat, expected it to rise, since its last slope goes on: give it a last point "
               "beyond what the cable ever reaches";
    }
    return "";
}

Eigen::Index TensionLaw::part_of(double strain_there) const {
    Eigen::Index part = 0;
    while (part + 2 < strain.size() && strain_there >= strain(part + 1)) {
        ++part;
    }
    return part;
}

double TensionLaw::slope_of(Eigen::Index part) const {
    if (strain.size() != tension.size() || part + 1 >= strain.size()) {
        throw std::invalid_argument("the tension law " + size_problem(*this));
    }
    return (tension(part + 1) - tension(part)) / (strain(part + 1) - strain(part));
}

TensionLaw::Tangent sagging_tangent(double axial_stiffness, double sag, double strain) {
    const double T = sagging_tension(axial_stiffness, sag, strain);
    const double c = std::pow(sag / T, 2) / T;  // S^2 / T^3
    const double slope = 1.0 / (1.0 / axial_stiffness + 2.0 * c);
    return {.tension = T, .slope = slope, .curvature = 6.0 * c / T * slope * slope * slope};
}

TensionLaw::Tangent TensionLaw::at(double strain_there) const {
    const Eigen::Index part = part_of(strain_there);
    const double slope = slope_of(part);
    if (sags()) {
        return sagging_tangent(slope, sag, strain_there);
    }
    return {.tension = tension(part) + slope * (strain_there - strain(part)), .slope = slope};
}

TensionLaw::Tangent TensionLaw::blurred(double strain_there, double std_dev) const {
    if (!(std_dev > 0.0) || sags()) {
        return at(strain_there);
    }
    // The law is its first line plus, from each corner on, the change of slope times (x - corner)+.
    // The mean of (x - corner)+ over N(x, s^2) is s (phi(z) + z Phi(z)), its derivative Phi(z),
    // with z = (x - corner) / s.
    const auto density = [](double z) {
        return std::exp(-0.5 * z * z) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
    };
    const auto distribution = [](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); };
    Tangent result{.tension = slope_of(0) * strain_there, .slope = slope_of(0)};
    for (Eigen::Index corner = 1; corner + 1 < strain.size(); ++corner) {
        const double bend = slope_of(corner) - slope_of(corner - 1);
        const double z = (strain_there - strain(corner)) / std_dev;
        result.tension += bend * std_dev * (density(z) + z * distribution(z));
        result.slope += bend * distribution(z);
    }
    return result;
}

double TensionLaw::missed_by_blurred(double strain_there, double std_dev) const {
    const Tangent blurred_there = blurred(strain_there, std_dev);
    constexpr int quantiles = 40;  // equally probable ones
    double variance = 0.0;
    for (int i = 0; i < quantiles; ++i) {
        const double p = (i + 0.5) / quantiles;
        const double step = std::numbers::sqrt2 * boost::math::erf_inv(2.0 * p - 1.0) * std_dev;
        const double missed =
            at(strain_there + step).tension - blurred_there.tension - blurred_there.slope * step;
        variance += missed * missed / quantiles;
    }
    return variance;
}

double TensionLaw::strain_at(double tension_there) const {
    Eigen::Index part = 0;
    while (part + 2 < tension.size() && tension_there > tension(part + 1)) {
        ++part;
    }
    const double slope = slope_of(part);  // checks the sizes
    if (sags()) {
        return tension_there > 0.0 ? tension_there / slope - std::pow(sag / tension_there, 2)
                                   : -std::numeric_limits<double>::infinity();
    }
    return strain(part) + (tension_there - tension(part)) / slope;
}

std::pair<double, double> TensionLaw::strains_at(double tension_there) const {
    constexpr double rounding = 1e-6;
    const double strain_there = strain_at(tension_there);
    for (Eigen::Index part = 1; part + 1 < tension.size(); ++part) {
        if (tension(part) == tension(part + 1) &&
            std::abs(tension_there - tension(part)) <= rounding * tension(part)) {
            return {strain(part), strain(part + 1)};
        }
    }
    return {strain_there, strain_there};
}

TensionLaw TensionLaw::stiffened(double factor) const {
    TensionLaw result = *this;
    result.tension *= factor;
    return result;
}

double TensionLaw::steepest() const {
    double slope = 0.0;
    for (Eigen::Index part = 0; part + 1 < strain.size(); ++part) {
        slope = std::max(slope, slope_of(part));
    }
    return slope;
}

double TensionLaw::energy_between(double a, double b) const {
    if (sags()) {
        // The integral of T d strain = (T / EA + 2 S^2 / T^2) dT, over the difference of strains.
        const double A = at(a).tension;
        const double B = at(b).tension;
        const double S = sag * sag;
        const double flexibility = 1.0 / slope_of(0);
        const double of_energy = 0.5 * flexibility * (A + B) + 2.0 * S / (A * B);
        const double of_strain = flexibility + S / (A * B) * (1.0 / A + 1.0 / B);
        return (b - a) * of_energy / of_strain;
    }
    return 0.5 * (at(a).tension + at(b).tension) * (b - a) - corner_energy(a, b);
}

double TensionLaw::corner_energy(double a, double b) const {
    if (sags()) {
        return 0.5 * (at(a).tension + at(b).tension) * (b - a) - energy_between(a, b);
    }
    double energy = 0.0;
    const auto [low, high] = std::minmax(a, b);
    for (Eigen::Index corner = 1; corner + 1 < strain.size(); ++corner) {
        if (low < strain(corner) && strain(corner) < high) {
            const double bend = slope_of(corner) - slope_of(corner - 1);
            energy += 0.5 * bend * (b - strain(corner)) * (strain(corner) - a);
        }
    }
    return a < b ? energy : -energy;
}

}  // namespace taut
