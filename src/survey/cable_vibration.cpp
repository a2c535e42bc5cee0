// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/cable_vibration.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

#include "net/check_index.hpp"

namespace taut {
namespace {

using std::numbers::pi;

constexpr double density_of_steel = 7850;  // [kg/m3]

/// T l^2 / EI of a cable with fixed ends, whose frequency is given as Omega = omega l^2 sqrt(m/EI).
/// With a, b > 0, a b = Omega, b^2 - a^2 = T l^2 / EI, its deflection is a sum of cos, sin of a x/l
/// and cosh, sinh of b x/l; the ends are at rest where
///
///   2 a b (1 / cosh b - cos a) + (b^2 - a^2) sin a tanh b = 0.
///
/// The n-th root a goes from n pi, a string's, to (n + 1/2) pi, nearly a beam's without tension.
double fixed_ends(double omega, int mode) {
    const double first = mode * pi;
    const auto balance = [&](double a) {
        const double b = omega / a;
        return 2.0 * omega * (1.0 / std::cosh(b) - std::cos(a)) +
               (b * b - a * a) * std::sin(a) * std::tanh(b);
    };
    // Without tension a = b, which is a little beyond (n + 1/2) pi of the first mode.
    const double upper = std::min(std::sqrt(omega), 1.01 * (first + 0.5 * pi));
    if (!(upper > first) || balance(first) * balance(upper) > 0.0) {
        return -1.0;  // slower than a beam without tension
    }
    std::uintmax_t most_steps = 100;
    const auto [left, right] = boost::math::tools::toms748_solve(
        balance, first, upper, boost::math::tools::eps_tolerance<double>(), most_steps);
    const double a = 0.5 * (left + right);
    return std::pow(omega / a, 2) - a * a;
}

/// Between two ends of a range, all of it alike.
struct Range {
    double least;
    double most;
    [[nodiscard]] double middle() const { return 0.5 * (least + most); }
    [[nodiscard]] double std_dev() const { return (most - least) / (2.0 * std::sqrt(3.0)); }
};

[[noreturn]] void refuse_frequency(const CableNet& net, int edge, const std::string& what) {
    throw std::invalid_argument(
        fmt::format("the frequency of edge '{}' {}", net.edge_id(edge), what));
}

}  // namespace

VibratingCable vibrating_cable(const CableNet& net, const Points& form, int edge) {
    check_index("edge", edge, net.edge_count());
    const auto of_edge = [edge](const Eigen::VectorXd& values) {
        return values.size() > 0 ? values(edge) : 0.0;
    };
    const auto [s, t] = net.edges()[edge];
    return {.length = (form.col(s) - form.col(t)).norm(),
            .mass = of_edge(net.data().mass),
            .bending_stiffness = of_edge(net.data().bending_stiffness)};
}

double tension_of_frequency(const VibratingCable& cable, double frequency, int mode,
                            CableEnds ends) {
    if (!(frequency > 0.0) || !(cable.length > 0.0) || !(cable.mass > 0.0) ||
        !(cable.bending_stiffness >= 0.0) || mode < 1 || ends == CableEnds::unknown) {
        throw std::invalid_argument(fmt::format(
            "a cable of {} m, {} kg/m and EI {} N m2 with {} Hz in mode {}, expected positive "
            "numbers, and ends that are hinged or fixed",
            cable.length, cable.mass, cable.bending_stiffness, frequency, mode));
    }
    const double l = cable.length;
    const double EI = cable.bending_stiffness;
    const double string = cable.mass * std::pow(2.0 * l * frequency / mode, 2);
    if (ends == CableEnds::hinged || EI <= 1e-12 * string * l * l) {
        return string - EI * std::pow(mode * pi / l, 2);
    }
    const double omega = 2.0 * pi * frequency * l * l * std::sqrt(cable.mass / EI);
    return fixed_ends(omega, mode) * EI / (l * l);
}

namespace {

ForceMeasurement tension_of_cable(const CableNet& net, const VibratingCable& cable,
                                  const FrequencyMeasurement& measured, double free_length_std) {
    const int edge = measured.edge;
    const double length = cable.length;  // not bound: lambdas below use them
    const double mass = cable.mass;
    const double given = cable.bending_stiffness;
    if (!(mass > 0.0)) {
        refuse_frequency(net, edge, "needs its mass: the net has none of it (mass [kg/m])");
    }
    if (!(free_length_std >= 0.0) || !(free_length_std < 0.5 * length)) {
        refuse_frequency(
            net, edge,
            fmt::format("has a free length of {:.3g} m with the standard deviation {:.3g} m, "
                        "expected less than half of it",
                        length, free_length_std));
    }
    if (!(measured.std_dev > 0.0) || !(measured.std_dev < 0.5 * measured.frequency)) {
        refuse_frequency(
            net, edge,
            fmt::format("is {:.4g} Hz with the standard deviation {:.4g} Hz, expected one above "
                        "0 and below half of it",
                        measured.frequency, measured.std_dev));
    }
    const double EA = net.axial_stiffness()(edge);
    const double of_bar = EA * mass / (4.0 * pi * density_of_steel);  // E A^2 / (4 pi)
    const auto tension = [&](double bending_stiffness, CableEnds ends) {
        return tension_of_frequency({length, mass, bending_stiffness}, measured.frequency,
                                    measured.mode, ends);
    };
    const CableEnds ends =
        net.data().cable_ends.empty() ? CableEnds::unknown : net.data().cable_ends[edge];
    const Range of_ends{
        .least = tension(given > 0.0 ? given : 0.5 * of_bar,
                         ends == CableEnds::hinged ? ends : CableEnds::fixed),
        .most = tension(given, ends == CableEnds::fixed ? ends : CableEnds::hinged)};
    if (!(of_ends.middle() > 0.0)) {
        refuse_frequency(
            net, edge,
            fmt::format("is {:.4g} Hz in mode {}, which a cable of its mass and bending "
                        "stiffness has without tension",
                        measured.frequency, measured.mode));
    }
    // Irvine's lambda^2, at most: of a horizontal cable. The first mode in the plane of the sag is
    // sqrt(1 + 8 lambda^2 / pi^4) times as fast for a small one; the others are not.
    const double tightest = std::max(of_ends.least, 0.5 * of_ends.most);
    const double sag = std::pow(mass * gravity * length / tightest, 2) * EA / tightest;
    constexpr double largest_sag = 1.0;
    if (sag > largest_sag) {
        refuse_frequency(
            net, edge,
            fmt::format("is that of a cable that sags too much for a string (Irvine's parameter "
                        "is {:.2g}, expected at most 1): its tension does not follow from it",
                        sag));
    }
    const Range of_sag{
        .least = measured.mode == 1 ? 1.0 / (1.0 + 8.0 * sag / std::pow(pi, 4)) : 1.0, .most = 1.0};
    const double found = of_ends.middle() * of_sag.middle();
    return {.edge = edge,
            .tension = found,
            .std_dev = 2.0 * found *
                       std::hypot(measured.std_dev / measured.frequency, free_length_std / length),
            .source = ForceSource::frequency,
            .mode = measured.mode,
            .shared_std = std::hypot(of_ends.std_dev(), of_sag.std_dev() * found)};
}

}  // namespace

ForceMeasurement tension_by_frequency(const CableNet& net, const Points& form,
                                      const FrequencyMeasurement& measured,
                                      double free_length_std) {
    return tension_of_cable(net, vibrating_cable(net, form, measured.edge), measured,
                            free_length_std);
}

std::optional<double> expected_frequency(const CableNet& net, int edge, double length,
                                         double tension) {
    VibratingCable cable = vibrating_cable(net, net.nodes(), edge);
    cable.length = length;
    if (!(cable.mass > 0.0) || !(length > 0.0) || !(tension > 0.0)) {
        return std::nullopt;
    }
    double frequency = std::sqrt(tension / cable.mass) / (2.0 * length);  // of a string
    constexpr int steps = 30;  // the tension is nearly its square: each gains some digits
    try {
        for (int k = 0; k < steps; ++k) {
            const ForceMeasurement found = tension_of_cable(
                net, cable, {.edge = edge, .frequency = frequency, .std_dev = 0.01 * frequency},
                0.0);
            frequency *= std::sqrt(tension / found.tension);
        }
    } catch (const std::invalid_argument&) {  // its own check says whether it is a string
        return std::nullopt;
    }
    return frequency;
}

}  // namespace taut
