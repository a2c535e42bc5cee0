// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/misfit_hint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "numerics/small_dense.hpp"
#include "survey/match_by_place.hpp"
#include "survey/mean_edge_length.hpp"
#include "survey/median.hpp"
#include "survey/node_names.hpp"

namespace taut {
namespace {

/// Points that fit: half of them within this part of the mean edge length.
constexpr double fitting_part = 0.1;
constexpr double scale_of_unit = 0.01;  ///< relative tolerance within which a scale is a unit

/// A change of axes that turns a survey into its mirror image.
struct Mirroring {
    Eigen::Matrix3d matrix;
    const char* words;
};

const std::array<Mirroring, 4>& mirrorings() {
    static const std::array<Mirroring, 4> known = [] {
        Eigen::Matrix3d exchanged;
        exchanged << 0, 1, 0, 1, 0, 0, 0, 0, 1;
        const auto negated = [](int axis) {
            Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
            matrix(axis, axis) = -1.0;
            return matrix;
        };
        return std::array<Mirroring, 4>{
            {{exchanged,
              "its x and y are exchanged, as north before east: exchange them, in a table by the "
              "columns id,y,x,z"},
             {negated(0), "its x has the other sign: negate it"},
             {negated(1), "its y has the other sign: negate it"},
             {negated(2), "its z has the other sign, as depths have: negate it"}}};
    }();
    return known;
}

/// Measured and nominal places of the nodes that the points name, a column each.
struct NamedPlaces {
    Eigen::Matrix3Xd measured;
    Eigen::Matrix3Xd nominal;
};

NamedPlaces named_places(const CableNet& net, const std::vector<SurveyPoint>& points) {
    const std::map<std::string, int> node_of = nodes_by_name(net);
    NamedPlaces places;
    Eigen::Index count = 0;
    places.measured.resize(3, static_cast<Eigen::Index>(points.size()));
    places.nominal.resize(3, static_cast<Eigen::Index>(points.size()));
    for (const SurveyPoint& point : points) {
        if (const auto found = node_of.find(point.id); found != node_of.end()) {
            places.measured.col(count) = point.position;
            places.nominal.col(count) = net.nodes().col(found->second);
            ++count;
        }
    }
    places.measured.conservativeResize(3, count);
    places.nominal.conservativeResize(3, count);
    return places;
}

double median_distance(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
    return median_of((a - b).colwise().norm());
}

/// A motion with a scale that moves measured places nearest to nominal ones.
struct SimilarityFit {
    double scale = 1.0;
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double median = 0.0;  ///< distance that is left [m]
};

SimilarityFit fit_similarity(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& nominal) {
    const Eigen::Vector3d from = measured.rowwise().mean();
    const Eigen::Vector3d to = nominal.rowwise().mean();
    const Eigen::Matrix3Xd a = measured.colwise() - from;
    const Eigen::Matrix3Xd b = nominal.colwise() - to;
    SimilarityFit fit;
    fit.rotation = rigid_motion(a, b).topLeftCorner<3, 3>();
    const Eigen::Matrix3Xd turned = fit.rotation * a;
    fit.scale = turned.cwiseProduct(b).sum() / a.squaredNorm();
    fit.median = median_distance(fit.scale * turned, b);
    return fit;
}

struct KnownUnit {
    const char* name;
    const char* words;
    double length;  ///< [m]
};

/// The unit of a length, to a hundredth; nothing where it is none.
std::optional<KnownUnit> known_unit(double length) {
    constexpr std::array<KnownUnit, 5> units{{{"m", "metres", 1.0},
                                              {"mm", "millimetres", 1e-3},
                                              {"cm", "centimetres", 1e-2},
                                              {"ft", "feet", 0.3048},
                                              {"in", "inches", 0.0254}}};
    for (const KnownUnit& unit : units) {
        if (std::abs(length / unit.length - 1.0) < scale_of_unit) {
            return unit;
        }
    }
    return std::nullopt;
}

/// @param scale that brings the points to the net; @param unit they were taken in [m]
std::string scale_words(double scale, double unit) {
    if (const auto right = known_unit(scale * unit)) {
        const auto taken = known_unit(unit);
        return fmt::format("its coordinates are in {}, not in {}: give the unit {}", right->words,
                           taken ? taken->words : "that unit", right->name);
    }
    return fmt::format(
        "its points are {:.4g} times as far apart as the net's nodes, which no unit explains: is "
        "it "
        "of this net, and is the instrument's scale factor 1?",
        1.0 / scale);
}

bool is_another_scale(double scale) {
    return std::abs(scale - 1.0) > scale_of_unit;
}

/// In the net's frame exactly one mirroring fits. In a frame turned about the vertical, mirrorings
/// of x, of y and their exchange differ by a rotation only: there only up and down differ.
std::string mirrored_words(const NamedPlaces& places, double limit) {
    for (const Mirroring& mirroring : mirrorings()) {
        if (median_distance(mirroring.matrix * places.measured, places.nominal) < limit) {
            return mirroring.words;
        }
    }
    const Mirroring& exchanged = mirrorings().front();
    const SimilarityFit fit = fit_similarity(exchanged.matrix * places.measured, places.nominal);
    return fit.rotation(2, 2) < 0.0 ? mirrorings().back().words : exchanged.words;
}

std::string misfit_of_named(const CableNet& net, const NamedPlaces& places, double unit,
                            bool frame_is_fitted) {
    constexpr Eigen::Index enough = 6;
    constexpr double much_better = 0.5;
    if (places.measured.cols() < enough) {
        return "";
    }
    const double limit = fitting_part * mean_edge_length(net);
    const SimilarityFit as_it_is = fit_similarity(places.measured, places.nominal);
    const SimilarityFit mirrored =
        fit_similarity(mirrorings().front().matrix * places.measured, places.nominal);
    if (mirrored.median < limit && mirrored.median < much_better * as_it_is.median) {
        const bool is_scaled = is_another_scale(mirrored.scale);
        const NamedPlaces scaled{.measured = mirrored.scale * places.measured,
                                 .nominal = places.nominal};
        return fmt::format("; the survey is mirrored: {}{}",
                           mirrored_words(is_scaled ? scaled : places, limit),
                           is_scaled ? "; and " + scale_words(mirrored.scale, unit) : "");
    }
    if (as_it_is.median > limit) {
        return "";
    }
    if (is_another_scale(as_it_is.scale)) {
        return "; " + scale_words(as_it_is.scale, unit);
    }
    if (!frame_is_fitted &&
        median_distance(places.measured, places.nominal) > 0.5 * mean_edge_length(net)) {
        return fmt::format(
            "; its points fit the net after a rigid motion (half of them to {:.3g} mm): it is in "
            "another frame. Survey three named supports to fit it to, or give control points",
            1e3 * as_it_is.median);
    }
    return "";
}

/// Whether match_by_place() matches 19 of 20 points after a linear map of their places.
bool fit_by_place(const CableNet& net, std::vector<SurveyPoint> points,
                  const Eigen::Matrix3d& matrix) {
    constexpr double most = 0.95;
    for (SurveyPoint& point : points) {
        point.position = matrix * point.position;
    }
    const std::vector<PlaceMatch> matches = match_by_place(net, points, [](int) { return false; });
    const auto matched =
        std::ranges::count_if(matches, [](const PlaceMatch& match) { return !match.unmatched; });
    return !points.empty() &&
           static_cast<double>(matched) >= most * static_cast<double>(points.size());
}

std::string misfit_by_place(const CableNet& net, const std::vector<SurveyPoint>& points,
                            double unit) {
    if (fit_by_place(net, points, Eigen::Matrix3d::Identity())) {
        return "";  // a symmetric net also fits its mirror image
    }
    for (const Mirroring& mirroring : mirrorings()) {
        if (fit_by_place(net, points, mirroring.matrix)) {
            return fmt::format("; the survey is mirrored: {}", mirroring.words);
        }
    }
    for (const double right : {1.0, 1e-3, 1e-2, 0.3048, 0.0254}) {
        const double scale = right / unit;
        if (is_another_scale(scale) &&
            fit_by_place(net, points, scale * Eigen::Matrix3d::Identity())) {
            return "; " + scale_words(scale, unit);
        }
    }
    return "";
}

/// Names a point near its node as it stands, and one that is so in another unit only.
std::string mixed_units(const CableNet& net, const std::vector<SurveyPoint>& points) {
    constexpr double foot = 0.3048;
    constexpr std::array<double, 7> units{1.0,        1e-3,        1e3,       foot,
                                          1.0 / foot, 1e-3 / foot, 1e3 * foot};
    const std::map<std::string, int> node_of = nodes_by_name(net);
    const double reach = 0.5 * mean_edge_length(net);
    int as_they_stand = 0;
    int in_another = 0;
    for (const SurveyPoint& point : points) {
        const auto found = node_of.find(point.id);
        if (found == node_of.end()) {
            return "";
        }
        const Eigen::Vector3d node = net.nodes().col(found->second);
        const auto* const unit = std::ranges::find_if(
            units, [&](double factor) { return (factor * point.position - node).norm() < reach; });
        if (unit == units.end()) {
            return "";
        }
        int& line = *unit == 1.0 ? as_they_stand : in_another;
        line = line == 0 ? point.line : line;
    }
    return as_they_stand == 0 || in_another == 0
               ? ""
               : fmt::format("; lines {} and {} fit it in two units: expected one for all",
                             std::min(as_they_stand, in_another),
                             std::max(as_they_stand, in_another));
}

}  // namespace

std::string misfit_hint(const CableNet& net, const std::vector<SurveyPoint>& points, double unit,
                        bool frame_is_fitted) {
    std::string hint = misfit_of_named(net, named_places(net, points), unit, frame_is_fitted);
    if (hint.empty()) {
        hint = misfit_by_place(net, points, unit);
    }
    return hint.empty() ? mixed_units(net, points) : hint;
}

}  // namespace taut
