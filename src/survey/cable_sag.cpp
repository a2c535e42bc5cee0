// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/cable_sag.hpp"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "net/check_index.hpp"

namespace taut {
namespace {

[[noreturn]] void refuse_sag(const CableNet& net, int edge, const std::string& what) {
    throw std::invalid_argument(fmt::format("the sag of edge '{}' {}", net.edge_id(edge), what));
}

/// The straight line between the ends of an edge, and the direction in which it sags: down, across
/// the line.
struct Chord {
    Eigen::Vector3d start;
    Eigen::Vector3d along;
    Eigen::Vector3d down;
    double length;
    double cosine;  ///< of its slope

    Chord(const CableNet& net, int edge, const Points& form) {
        const auto [s, t] = net.edges()[edge];
        start = form.col(s);
        length = (form.col(t) - start).norm();
        along = (form.col(t) - start) / length;
        const Eigen::Vector3d across = -Eigen::Vector3d::UnitZ() + along.z() * along;
        cosine = across.norm();
        constexpr double steepest = 0.05;
        if (!(cosine > steepest)) {
            refuse_sag(net, edge, "is that of a vertical cable: it has none");
        }
        down = across / cosine;
    }
};

/// The curvature q of y = a + b x + q x (l - x), and its standard deviation, x from 0 to l.
struct Parabola {
    double curvature;
    double std_dev;
};

Parabola parabola_through(const CableNet& net, const Chord& chord,
                          const std::vector<const SagPoint*>& points) {
    constexpr int fewest = 3;
    const int edge = points.front()->edge;
    if (std::ssize(points) < fewest) {
        refuse_sag(net, edge,
                   fmt::format("is given by {} points, expected three or more", points.size()));
    }
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    for (const SagPoint* const point : points) {
        const Eigen::Vector3d from_start = point->position - chord.start;
        const double x = from_start.dot(chord.along) / chord.length;
        const double distance = (from_start - x * chord.length * chord.along).norm();
        constexpr double farthest = 0.1;  // of the chord
        if (!(x > 0.0) || !(x < 1.0) || !(distance < farthest * chord.length)) {
            refuse_sag(net, edge,
                       fmt::format("has a point that is not on the cable: at {:.3g} of its length, "
                                   "{:.3g} m beside it",
                                   x, distance));
        }
        if (!(point->std_dev > 0.0) || !std::isfinite(point->std_dev)) {
            refuse_sag(
                net, edge,
                fmt::format("has a point with the standard deviation {} m, expected a positive "
                            "one",
                            point->std_dev));
        }
        const Eigen::Vector3d row(1.0, x, x * (1.0 - x));
        const double weight = 1.0 / (point->std_dev * point->std_dev);
        normal += weight * row * row.transpose();
        right_side += weight * from_start.dot(chord.down) * row;
    }
    const Eigen::LDLT<Eigen::Matrix3d> factor(normal);
    constexpr double singular = 1e-9;
    if (!(factor.vectorD().minCoeff() > singular * factor.vectorD().maxCoeff())) {
        refuse_sag(net, edge, "has points too close together for a parabola: spread them over it");
    }
    const Eigen::Matrix3d covariance = factor.solve(Eigen::Matrix3d::Identity());
    return {.curvature = factor.solve(right_side)(2), .std_dev = std::sqrt(covariance(2, 2))};
}

}  // namespace

std::vector<ForceMeasurement> tensions_by_sag(const CableNet& net, const Points& form,
                                              const std::vector<SagPoint>& points) {
    std::map<int, std::vector<const SagPoint*>> of_edges;
    for (const SagPoint& point : points) {
        check_index("edge", point.edge, net.edge_count());
        of_edges[point.edge].push_back(&point);
    }
    std::vector<ForceMeasurement> result;
    for (const auto& [edge, of_edge] : of_edges) {
        const Eigen::VectorXd& masses = net.data().mass;
        const double mass = masses.size() > 0 ? masses(edge) : 0.0;
        if (!(mass > 0.0)) {
            refuse_sag(net, edge, "needs its mass: the net has none of it (mass [kg/m])");
        }
        const Chord chord(net, edge, form);
        const Parabola found = parabola_through(net, chord, of_edge);
        const double sag = 0.25 * found.curvature;
        constexpr double largest_sag = 0.05;  // of the chord: the parabola is 1 % off there
        if (sag > largest_sag * chord.length) {
            refuse_sag(
                net, edge,
                fmt::format("is {:.3g} m of a length of {:.3g} m, expected at most a twentieth: "
                            "no parabola",
                            sag, chord.length));
        }
        constexpr double least_significant = 3.0;
        if (!(found.curvature > least_significant * found.std_dev)) {
            refuse_sag(
                net, edge,
                fmt::format("is {:.2f} +- {:.2f} mm: too little for a tension. Survey it closer, "
                            "or leave it out",
                            1e3 * sag, 0.25e3 * found.std_dev));
        }
        // y = m g cos(beta) l^2 / (2 T) x (1 - x)
        const double weight = mass * gravity * chord.cosine * chord.length * chord.length;
        const double tension = weight / (2.0 * found.curvature);
        const double part = found.std_dev / found.curvature;
        // 1/q of a normal q is skew: to second order its mean is higher by part^2.
        result.push_back({.edge = edge,
                          .tension = tension,
                          .std_dev = tension * part * (1.0 + part * part),
                          .source = ForceSource::sag});
    }
    return result;
}

}  // namespace taut
