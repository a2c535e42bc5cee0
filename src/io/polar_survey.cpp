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
#include "survey/node_names.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// Precision of angles and distances in words, and whether it was assumed.
struct PrecisionText {
    std::string angles;
    std::string distances;
    bool is_assumed = false;
};

/// Fills in standard deviations that the file does not give.
PrecisionText complete_precision(PolarSurvey& survey, const ReadSurveyOptions& options) {
    const double angle_std = options.angle_std.value_or(common_angle_std);
    const DistancePrecision distance = options.distance.value_or(DistancePrecision{});
    bool is_angle_given = true;
    bool is_distance_given = true;
    for (PolarObservation& observation : survey.observations) {
        if (!(observation.angle_std > 0.0)) {
            observation.angle_std = angle_std;
            is_angle_given = false;
        }
        if (!(observation.distance_std > 0.0)) {
            observation.distance_std = distance.std_at(observation.distance);
            is_distance_given = false;
        }
    }
    PrecisionText text{.angles = "as in the file", .distances = "as in the file"};
    if (!is_angle_given) {
        text.angles = fmt::format("{:.3g} mgon", 1e3 * angle_std / gon);
        text.is_assumed = !options.angle_std;
    }
    if (!is_distance_given) {
        text.distances =
            fmt::format("{:.3g} mm + {:.3g} ppm", 1e3 * distance.std_dev, 1e6 * distance.part);
        text.is_assumed = text.is_assumed || !options.distance;
    }
    return text;
}

/// Root mean square distance of targets with names of nodes from these after the best rigid motion
/// [m]; nothing for fewer than four.
std::optional<double> misfit_of_shape(const CableNet& net, const std::vector<SurveyPoint>& points) {
    constexpr Eigen::Index needed = 4;
    const std::map<std::string, int> node_of = nodes_by_name(net);
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

/// The survey with its angles, all of the first face, in another unit.
PolarSurvey with_angles_times(PolarSurvey survey, double factor) {
    for (PolarObservation& observation : survey.observations) {
        observation.direction *= factor;
        observation.zenith *= factor;
    }
    return survey;
}

std::optional<double> misfit_by_observations(const CableNet& net, const PolarSurvey& survey) {
    try {
        return misfit_of_shape(net, adjust_stations(survey).points);
    } catch (const SurveyError&) {
        return std::nullopt;
    }
}

/// "in degrees, not in gon", where that would bring the targets to the net.
/// @param misfit in the given unit, if there were any places
std::optional<std::string> angle_unit_hint(const CableNet& net, const PolarSurvey& survey,
                                           std::optional<double> misfit) {
    struct Mistake {
        double factor;
        const char* words;
    };
    const std::array mistakes{Mistake{degree / gon, "in degrees, not in gon"},
                              Mistake{gon / degree, "in gon, not in degrees"},
                              Mistake{1.0 / gon, "in radians, not in gon"},
                              Mistake{1.0 / degree, "in radians, not in degrees"}};
    constexpr double much_better = 0.25;
    const double near = misfit ? much_better * *misfit : mean_edge_length(net);
    for (const Mistake& mistake : mistakes) {
        const auto other = misfit_by_observations(net, with_angles_times(survey, mistake.factor));
        if (other && *other < near) {
            return mistake.words;
        }
    }
    return std::nullopt;
}

std::string name_of_observation(const PolarSurvey& survey, int index) {
    const PolarObservation& observation = survey.observations[index];
    return fmt::format("target '{}' from station '{}', line {}", observation.target,
                       survey.stations[observation.station].name, observation.line);
}

void report_adjustment(const PolarSurvey& survey, const StationAdjustment& adjusted,
                       const PrecisionText& precision, SurveyFile& file) {
    file.notes.push_back(
        fmt::format("{} observations of {} targets from {} station{}; angles {}, distances {}",
                    survey.observations.size(), adjusted.points.size(), survey.stations.size(),
                    survey.stations.size() == 1 ? "" : "s", precision.angles, precision.distances));
    if (adjusted.redundancy > 0) {
        file.notes.push_back(
            fmt::format("variance factor of targets observed more than once: {:.2f} (expected 1); "
                        "largest residual "
                        "{:.1f} standard deviations, {}",
                        adjusted.noise_ratio, adjusted.worst_residual,
                        name_of_observation(survey, adjusted.worst)));
    }
    if (precision.is_assumed) {
        file.warnings.push_back(
            fmt::format("gives no precision of its observations: that of a common total station is "
                        "assumed, angles {}, distances {}",
                        precision.angles, precision.distances));
    }
    constexpr double largest_by_chance = 6.0;
    if (adjusted.worst_residual > largest_by_chance) {
        file.warnings.push_back(fmt::format(
            "observations contradict each other by up to {:.1f} standard deviations: {}",
            adjusted.worst_residual, name_of_observation(survey, adjusted.worst)));
    }
}

}  // namespace

SurveyFile targets_of_observations(const CableNet& net, PolarSurvey observations,
                                   const ReadSurveyOptions& options, const std::string& format,
                                   const std::string& file_name) {
    const PrecisionText precision = complete_precision(observations, options);
    const auto fail = [&](int line, const std::string& what) {
        throw InputError(file_name, line > 0 ? std::to_string(line) : "", what);
    };
    const auto refuse_other_unit = [&](std::optional<double> misfit) {
        if (const auto hint = angle_unit_hint(net, observations, misfit)) {
            fail(observations.observations.front().line,
                 fmt::format(
                     "its angles are most likely {}: then the targets have the shape of the net",
                     *hint));
        }
    };
    StationAdjustment adjusted;
    try {
        adjusted = adjust_stations(observations);
    } catch (const SurveyError& error) {
        refuse_other_unit(std::nullopt);
        fail(error.line(), error.what());
    }
    const auto misfit = misfit_of_shape(net, adjusted.points);
    constexpr double suspicious = 0.1;  // mean edge lengths: more than any built net deviates
    if (misfit && *misfit > suspicious * mean_edge_length(net)) {
        refuse_other_unit(misfit);
    }
    SurveyFile file{
        .points = adjusted.points, .is_of_observations = true, .scale_std = adjusted.scale_std};
    file.notes.push_back(fmt::format("read as {}", format));
    report_adjustment(observations, adjusted, precision, file);
    return file;
}

}  // namespace taut
