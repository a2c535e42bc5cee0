// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "io/polar_survey.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "numerics/small_dense.hpp"
#include "survey/mean_edge_length.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// What is told of a precision, and of where it is from.
struct PrecisionText {
    std::string angles;
    std::string distances;
    bool is_assumed = false;
};

/// Standard deviations where the file has none.
PrecisionText tell_precision(PolarSurvey& survey, const ReadSurveyOptions& options) {
    const double angle_std = options.angle_std.value_or(common_angle_std);
    const DistancePrecision distance = options.distance.value_or(DistancePrecision{});
    bool is_angle_told = true;
    bool is_distance_told = true;
    for (PolarObservation& reading : survey.readings) {
        if (!(reading.angle_std > 0.0)) {
            reading.angle_std = angle_std;
            is_angle_told = false;
        }
        if (!(reading.distance_std > 0.0)) {
            reading.distance_std = distance.std_at(reading.distance);
            is_distance_told = false;
        }
    }
    PrecisionText text{.angles = "as the file tells", .distances = "as the file tells"};
    if (!is_angle_told) {
        text.angles = fmt::format("{:.3g} mgon", 1e3 * angle_std / gon);
        text.is_assumed = !options.angle_std;
    }
    if (!is_distance_told) {
        text.distances =
            fmt::format("{:.3g} mm + {:.3g} ppm", 1e3 * distance.std, 1e6 * distance.part);
        text.is_assumed = text.is_assumed || !options.distance;
    }
    return text;
}

/// How far targets with the names of nodes lie from these after the best rigid motion, root mean
/// square [m]; nothing for fewer than four.
std::optional<double> misfit_of_shape(const CableNet& net, const std::vector<SurveyPoint>& points) {
    constexpr Eigen::Index needed = 4;
    std::map<std::string, int> node_of;
    for (int node = 0; node < net.node_count(); ++node) {
        node_of.emplace(net.node_id(node), node);
    }
    std::vector<std::pair<int, Eigen::Vector3d>> named;
    for (const SurveyPoint& point : points) {
        if (const auto found = node_of.find(point.id); found != node_of.end()) {
            named.emplace_back(found->second, point.position);
        }
    }
    const auto count = std::ssize(named);
    if (count < needed) {
        return std::nullopt;
    }
    Eigen::Matrix3Xd measured(3, count);
    Eigen::Matrix3Xd known(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        known.col(i) = net.nodes().col(named[i].first);
        measured.col(i) = named[i].second;
    }
    const Eigen::Matrix4d motion = rigid_motion(measured, known);
    const Eigen::Matrix3Xd left =
        known - ((motion.topLeftCorner<3, 3>() * measured).colwise() + motion.col(3).head<3>());
    return std::sqrt(left.squaredNorm() / static_cast<double>(count));
}

/// As if the angles, all of the first face, had been read in another unit.
PolarSurvey with_angles_times(PolarSurvey survey, double factor) {
    for (PolarObservation& reading : survey.readings) {
        reading.direction *= factor;
        reading.zenith *= factor;
    }
    return survey;
}

std::optional<double> misfit_by_readings(const CableNet& net, const PolarSurvey& survey) {
    try {
        return misfit_of_shape(net, adjust_stations(survey).points);
    } catch (const SurveyError&) {
        return std::nullopt;
    }
}

/// "in degrees, where gon was told", where that would bring the targets to the net.
/// @param misfit as the angles were told, if they gave any places
std::optional<std::string> angle_unit_hint(const CableNet& net, const PolarSurvey& survey,
                                           std::optional<double> misfit) {
    struct Mistake {
        double factor;
        const char* words;
    };
    const std::array mistakes{Mistake{degree / gon, "in degrees, where gon was told"},
                              Mistake{gon / degree, "in gon, where degrees were told"},
                              Mistake{1.0 / gon, "in radians, where gon was told"},
                              Mistake{1.0 / degree, "in radians, where degrees were told"}};
    constexpr double much_better = 0.25;
    const double near = misfit ? much_better * *misfit : mean_edge_length(net);
    for (const Mistake& mistake : mistakes) {
        const auto other = misfit_by_readings(net, with_angles_times(survey, mistake.factor));
        if (other && *other < near) {
            return mistake.words;
        }
    }
    return std::nullopt;
}

std::string name_of_reading(const PolarSurvey& survey, int index) {
    const PolarObservation& reading = survey.readings[index];
    return fmt::format("target '{}' from station '{}', line {}", reading.target,
                       survey.stations[reading.station].name, reading.line);
}

void tell_adjustment(const PolarSurvey& survey, const StationAdjustment& adjusted,
                     const PrecisionText& precision, SurveyFile& file) {
    file.notes.push_back(
        fmt::format("{} readings of {} targets from {} station{}; angles {}, distances {}",
                    survey.readings.size(), adjusted.points.size(), survey.stations.size(),
                    survey.stations.size() == 1 ? "" : "s", precision.angles, precision.distances));
    if (adjusted.redundancy > 0) {
        file.notes.push_back(fmt::format(
            "targets that were read more than once: residuals {:.2f} times what that precision "
            "lets expect, the largest {:.1f} standard deviations, {}",
            adjusted.noise_ratio, adjusted.worst_residual,
            name_of_reading(survey, adjusted.worst)));
    }
    if (precision.is_assumed) {
        file.warnings.push_back(
            fmt::format("tells no precision of its readings: a common total station's is taken, "
                        "angles {}, distances {} (--angle, --range)",
                        precision.angles, precision.distances));
    }
    constexpr double largest_by_chance = 6.0;
    if (adjusted.worst_residual > largest_by_chance) {
        file.warnings.push_back(
            fmt::format("readings contradict each other by up to {:.1f} standard deviations: {}",
                        adjusted.worst_residual, name_of_reading(survey, adjusted.worst)));
    }
}

}  // namespace

SurveyFile targets_of_readings(const CableNet& net, PolarSurvey readings,
                               const ReadSurveyOptions& options, const std::string& format,
                               const std::string& file_name) {
    const PrecisionText precision = tell_precision(readings, options);
    const auto fail = [&](int line, const std::string& what) {
        throw InputError(file_name, line > 0 ? std::to_string(line) : "", what);
    };
    const auto refuse_other_unit = [&](std::optional<double> misfit) {
        if (const auto hint = angle_unit_hint(net, readings, misfit)) {
            fail(readings.readings.front().line,
                 fmt::format("its angles are most likely {}: read so, the targets have the shape "
                             "of the net",
                             *hint));
        }
    };
    StationAdjustment adjusted;
    try {
        adjusted = adjust_stations(readings);
    } catch (const SurveyError& error) {
        refuse_other_unit(std::nullopt);
        fail(error.line(), error.what());
    }
    const auto misfit = misfit_of_shape(net, adjusted.points);
    constexpr double suspicious = 0.1;  // mean edge lengths: beyond any built net's deviations
    if (misfit && *misfit > suspicious * mean_edge_length(net)) {
        refuse_other_unit(misfit);
    }
    SurveyFile file{
        .points = adjusted.points, .is_of_readings = true, .scale_std = adjusted.scale_std};
    file.notes.push_back(fmt::format("read as {}", format));
    tell_adjustment(readings, adjusted, precision, file);
    return file;
}

}  // namespace taut
