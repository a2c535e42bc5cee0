// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/path_law.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace taut {
namespace {

/// The x > 0 with b x^2 + a x = mu, for b > 0.
double positive_root(double a, double b, double mu) {
    const double root = std::sqrt(a * a + 4.0 * b * mu);
    return a > 0.0 ? 2.0 * mu / (root + a) : (root - a) / (2.0 * b);
}

/// The w in (0, W) with excess - c w + mu / w - mu / (W - w) = 0. The left side falls with w.
double middle_root(double excess, double axial, double width, double mu) {
    constexpr int most_steps = 100;
    double low = 0.0;
    double high = width;
    double w = 0.5 * width;
    for (int k = 0; k < most_steps && high - low > 1e-14 * high; ++k) {
        const double room = width - w;
        const double value = excess - axial * w + mu / w - mu / room;
        (value > 0.0 ? low : high) = w;
        // Newton's method on value * w (W - w), which has no poles.
        const double scaled = value * w * room;
        const double slope =
            value * (room - w) - (axial + mu / (w * w) + mu / (room * room)) * w * room;
        const double next = w - scaled / slope;
        w = next > low && next < high ? next : 0.5 * (low + high);
        if (std::abs(scaled) <= 1e-15 * mu * width) {
            break;
        }
    }
    return w;
}

/// Sets w, z and y of a part where the edge has this tension.
void set_part(PathPart& part, double width, double tension, double mu) {
    const double excess = tension - part.begin;
    if (part.has_low && part.has_high) {
        part.stretch = middle_root(excess, part.axial, width, mu);
        part.room = width - part.stretch;
    } else if (part.has_high) {
        part.room = positive_root(excess - part.axial * width, part.axial, mu);
        part.stretch = width - part.room;
    } else if (part.has_low) {
        part.stretch = positive_root(-excess, part.axial, mu);
    } else {
        part.stretch = excess / part.axial;
    }
    part.low = part.has_low ? mu / part.stretch : 0.0;
    part.high = part.has_high ? mu / part.room : 0.0;
}

/// Stiffness of a part, dT/dw.
double stiffness_of(const PathPart& part) {
    return part.axial + (part.has_low ? part.low / part.stretch : 0.0) +
           (part.has_high ? part.high / part.room : 0.0);
}

/// Growth of T at constant w that makes the equations of the part hold.
double push_of(const PathPart& part, double tension) {
    const double misfit = tension - part.begin - part.axial * part.stretch + part.low - part.high;
    return misfit + (part.has_low ? part.low_wanted / part.stretch : 0.0) -
           (part.has_high ? part.high_wanted / part.room : 0.0);
}

}  // namespace

size_t part_count(const TensionLaw* law) {
    return law == nullptr ? 1 : static_cast<size_t>(law->strain.size() - 1);
}

double start_parts(const TensionLaw* law, double axial, double unstressed, double stretch,
                   double mu, std::span<PathPart> parts) {
    const auto count = std::ssize(parts);
    const auto width = [&](Eigen::Index k) {
        return (law->strain(k + 1) - law->strain(k)) * unstressed;
    };
    for (Eigen::Index k = 0; k < count; ++k) {
        parts[k] = {
            .begin = law == nullptr ? 0.0 : law->tension(k),
            .axial = law == nullptr ? axial : (law->tension(k + 1) - law->tension(k)) / width(k),
            .has_low = k > 0,
            .has_high = k + 1 < count};
    }
    if (count == 1) {  // T (T / c - stretch) = mu
        const double tension = positive_root(-stretch, 1.0 / parts[0].axial, mu);
        set_part(parts[0], 0.0, tension, mu);
        return tension;
    }
    const auto set = [&](double tension) {
        for (Eigen::Index k = 0; k < count; ++k) {
            set_part(parts[k], width(k), tension, mu);
        }
    };
    // The T with T (e(T) - stretch) = mu, by Newton's method while it halves the difference, else
    // by bisection.
    constexpr int most_steps = 200;
    double low = 0.0;
    double high = std::numeric_limits<double>::infinity();
    double before = high;
    double tension =
        std::max(mu / unstressed, law->at(std::max(0.0, stretch / unstressed)).tension);
    for (int step = 0; step < most_steps; ++step) {
        set(tension);
        const double play = elongation(parts) - stretch;
        const double difference = tension * play - mu;
        (difference < 0.0 ? low : high) = tension;
        if (std::abs(difference) <= 1e-6 * mu ||
            (high < std::numeric_limits<double>::infinity() && high - low <= 1e-15 * high)) {
            break;
        }
        const double slope = play + tension * tangent_of(parts, tension).flexibility;
        const double next = tension - difference / slope;
        if (std::abs(difference) < 0.5 * before && next > low && next < high) {
            tension = next;
        } else {
            tension = std::isinf(high) ? 2.0 * tension
                      : low > 0.0      ? std::sqrt(low * high)
                                       : 0.1 * high;
        }
        before = std::abs(difference);
    }
    return tension;
}

double elongation(std::span<const PathPart> parts) {
    return std::transform_reduce(parts.begin(), parts.end(), 0.0, std::plus<>(),
                                 [](const PathPart& part) { return part.stretch; });
}

void aim_parts(std::span<PathPart> parts, double mu) {
    for (PathPart& part : parts) {
        part.low_wanted = part.has_low ? mu - part.low * part.stretch : 0.0;
        part.high_wanted = part.has_high ? mu - part.high * part.room : 0.0;
    }
}

void correct_parts(std::span<PathPart> parts) {
    for (PathPart& part : parts) {
        part.low_wanted -= part.low_rate * part.stretch_rate;
        part.high_wanted += part.high_rate * part.stretch_rate;
    }
}

/// dw = (dT + push) / stiffness, with the changes of z and y eliminated.
PathTangent tangent_of(std::span<const PathPart> parts, double tension) {
    PathTangent result{.flexibility = 0.0, .drift = 0.0};
    for (const PathPart& part : parts) {
        const double stiffness = stiffness_of(part);
        result.flexibility += 1.0 / stiffness;
        result.drift += push_of(part, tension) / stiffness;
    }
    return result;
}

void find_part_rates(std::span<PathPart> parts, double tension, double tension_rate) {
    for (PathPart& part : parts) {
        part.stretch_rate = (tension_rate + push_of(part, tension)) / stiffness_of(part);
        part.low_rate =
            part.has_low ? (part.low_wanted - part.low * part.stretch_rate) / part.stretch : 0.0;
        part.high_rate =
            part.has_high ? (part.high_wanted + part.high * part.stretch_rate) / part.room : 0.0;
    }
}

double limit_step(std::span<const PathPart> parts, double part_kept, double step) {
    const auto limit = [&](double value, double rate) {
        if (rate < 0.0) {
            step = std::min(step, (part_kept - 1.0) * value / rate);
        }
    };
    for (const PathPart& part : parts) {
        if (part.has_low) {
            limit(part.stretch, part.stretch_rate);
            limit(part.low, part.low_rate);
        }
        if (part.has_high) {
            limit(part.room, -part.stretch_rate);
            limit(part.high, part.high_rate);
        }
    }
    return step;
}

void move_parts(std::span<PathPart> parts, double step) {
    for (PathPart& part : parts) {
        part.stretch += step * part.stretch_rate;
        part.room -= step * part.stretch_rate;
        part.low += step * part.low_rate;
        part.high += step * part.high_rate;
    }
}

PathProducts products_after(std::span<const PathPart> parts, double step) {
    PathProducts result{.sum = 0.0, .count = 0};
    for (const PathPart& part : parts) {
        const double change = step * part.stretch_rate;
        if (part.has_low) {
            result.sum += (part.low + step * part.low_rate) * (part.stretch + change);
            ++result.count;
        }
        if (part.has_high) {
            result.sum += (part.high + step * part.high_rate) * (part.room - change);
            ++result.count;
        }
    }
    return result;
}

}  // namespace taut
