// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "files/message.hpp"
#include "interchange/surveys/survey_reader.hpp"
#include "interchange/surveys/survey_xml.hpp"
#include "survey/covariance.hpp"

namespace taut {
namespace {

/// A point, and the indices of its coordinates among the unknowns of the adjustment.
struct GamaPoint {
    SurveyPoint point;
    pugi::xml_node node;
    std::array<size_t, 3> unknown{};
};

/// A coordinate, in small letters, or in capitals where it took part in fixing the frame.
std::optional<double> gama_coordinate(const SurveyXml& xml, pugi::xml_node node, const char* small,
                                      const char* capital) {
    const auto value = xml.number(node, small);
    return value ? value : xml.number(node, capital);
}

/// Of an unknown: its variance, and its covariances with the next two [mm2].
using GamaCovariances = std::array<double, 3>;

/// Those of all unknowns: the first numbers of each row of the covariance matrix, of which the
/// upper band stands there by rows.
std::vector<GamaCovariances> gama_covariances(const SurveyXml& xml, pugi::xml_node matrix) {
    const auto dim = xml.number(matrix, "dim");
    const auto band = xml.number(matrix, "band");
    const auto is_count = [](std::optional<double> value) {
        return value && *value >= 0.0 && *value == std::floor(*value);
    };
    if (!is_count(dim) || !is_count(band)) {
        xml.fail(matrix, "has a cov-mat without dim and band, expected whole numbers");
    }
    std::vector<GamaCovariances> rows;
    double behind = 0.0;  // numbers of this row that are still to come
    size_t column = 0;    // of this row, counted from its diagonal
    for (const pugi::xml_node value : matrix.children("flt")) {
        if (behind > 0.0) {
            behind -= 1.0;
            ++column;
            if (column < rows.back().size()) {
                rows.back()[column] = xml.number(value, value.text().get(), "flt");
            }
            continue;
        }
        rows.push_back({xml.number(value, value.text().get(), "flt")});
        column = 0;
        if (rows.back().front() < 0.0) {
            xml.fail(value, fmt::format("has the variance {}, expected 0 or more",
                                        quote(value.text().get())));
        }
        behind = std::min(*band, *dim - static_cast<double>(rows.size()));
    }
    if (behind > 0.0 || static_cast<double>(rows.size()) != *dim) {
        xml.fail(matrix, fmt::format("has a cov-mat with {} whole rows, expected {} as dim says",
                                     rows.size() - (behind > 0.0 ? 1 : 0), *dim));
    }
    return rows;
}

/// Of a point, whose coordinates are consecutive unknowns [mm].
PlaceNoise gama_noise(const std::vector<GamaCovariances>& rows, const GamaPoint& point) {
    const GamaCovariances& x = rows[point.unknown[0]];
    const GamaCovariances& y = rows[point.unknown[1]];
    const GamaCovariances& z = rows[point.unknown[2]];
    Eigen::Matrix3d covariance;
    covariance << x[0], x[1], x[2],  //
        x[1], y[0], y[1],            //
        x[2], y[1], z[0];
    return noise_of(covariance);
}

/// Whether x, y and z of the adjustment are right-handed: its axes are two of n, e, s, w.
bool is_right_handed(std::string_view axes) {
    constexpr std::array<std::string_view, 4> right{"en", "nw", "ws", "se"};
    return std::ranges::find(right, axes) != right.end();
}

}  // namespace

ForeignSurvey read_gama(const std::string& text, const std::string& file_name) {
    const SurveyXml xml(text, file_name);
    ForeignSurvey survey{.format = "GNU Gama adjustment", .unit = 1.0, .std_unit = 1e-3};
    const pugi::xml_node coordinates = xml.root().child("coordinates");
    std::vector<GamaPoint> points;
    size_t unknowns = 0;
    for (const pugi::xml_node node : coordinates.child("adjusted").children("point")) {
        const std::string id(trimmed(node.child("id").text().get()));
        const auto x = gama_coordinate(xml, node, "x", "X");
        const auto y = gama_coordinate(xml, node, "y", "Y");
        const auto z = gama_coordinate(xml, node, "z", "Z");
        const int line = xml.line_of(node);
        if (x && y && z) {
            points.push_back({.point = {.id = id, .position = {*x, *y, *z}, .line = line},
                              .node = node,
                              .unknown = {unknowns, unknowns + 1, unknowns + 2}});
        } else {
            survey.left_out.push_back(
                {.line = line, .reason = fmt::format("point {} has no x, y and z", quote(id))});
        }
        for (const auto& value : {x, y, z}) {
            unknowns += value ? 1 : 0;
        }
    }
    const pugi::xml_node matrix = coordinates.child("cov-mat");
    const std::vector<GamaCovariances> covariances =
        matrix ? gama_covariances(xml, matrix) : std::vector<GamaCovariances>();
    if (matrix && covariances.size() < unknowns) {
        xml.fail(matrix, fmt::format("has a cov-mat of {} unknowns, expected at least the {} "
                                     "adjusted coordinates",
                                     covariances.size(), unknowns));
    }
    for (const pugi::xml_node node : coordinates.child("fixed").children("point")) {
        const auto x = gama_coordinate(xml, node, "x", "X");
        const auto y = gama_coordinate(xml, node, "y", "Y");
        const auto z = gama_coordinate(xml, node, "z", "Z");
        if (x && y && z) {
            survey.points.push_back({.id = std::string(trimmed(node.child("id").text().get())),
                                     .position = {*x, *y, *z},
                                     .line = xml.line_of(node)});
            if (matrix) {
                survey.points.back().noise_std = Eigen::Vector3d::Zero();
                survey.has_known_points = true;
            }
        }
    }
    for (GamaPoint& found : points) {
        if (matrix) {
            const PlaceNoise noise = gama_noise(covariances, found);
            found.point.noise_std = noise.std_dev;
            found.point.noise_correlations = noise.correlations;
            if (!are_possible_correlations(noise.correlations)) {
                xml.fail(found.node,
                         "has a covariance that is not positive definite, expected one "
                         "that three coordinates can have");
            }
        }
        survey.points.push_back(std::move(found.point));
    }
    const std::string_view given =
        xml.root().child("network-general-parameters").attribute("axes-xy").value();
    // What Gama takes where nothing is given.
    const std::string_view axes = given.empty() ? "ne" : given;
    if (!is_right_handed(axes)) {
        for (SurveyPoint& point : survey.points) {
            std::swap(point.position.x(), point.position.y());
            if (point.noise_std) {
                std::swap(point.noise_std->x(), point.noise_std->y());
                std::swap(point.noise_correlations.y(), point.noise_correlations.z());
            }
        }
    }
    survey.notes.push_back(fmt::format(
        "columns: adjusted and fixed points, axes-xy {}{}: {} as x, y, z; id as id{}", quote(axes),
        given.empty() ? " (not given)" : "", is_right_handed(axes) ? "x, y, z" : "y, x, z",
        matrix ? "; cov-mat [mm2] as sx, sy, sz and their correlations" : ""));
    return survey;
}

}  // namespace taut
