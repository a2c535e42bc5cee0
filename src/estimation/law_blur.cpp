// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/law_blur.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/linearisation.hpp"
#include "sampling/uncertain_widths.hpp"
#include "statics/elastic_stretch.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Variance of an edge's length from the covariances of its two ends, treated as independent. An
/// end at a known support contributes nothing.
double length_variance(const StaticsModel& model, const Covariance& covariance, int edge,
                       const Iterate& iterate) {
    const auto [s, t] = model.net().edges()[edge];
    const Eigen::Vector3d u = (iterate.form.col(s) - iterate.form.col(t)).normalized();
    double variance = 0.0;
    for (const int node : {s, t}) {
        if (model.numbering().has_place(node)) {
            variance += u.dot(covariance.places[node] * u);
        }
    }
    return variance;
}

/// (own-stiffness): T kappa = dT/dd times the length [m2].
double stiffness_as_length(const StaticsModel& model, int edge, const Iterate& iterate) {
    const CableNet& net = model.net();
    const EdgeRates e = model.rates(edge, iterate);
    const double least = 1e-6 * net.axial_stiffness()(edge) / net.unstressed_lengths()(edge);
    const double tension =
        net.is_strut(edge) ? std::abs(e.by_stiffness) : std::max(0.0, e.by_stiffness);
    const double length =
        model.own_stiffness_stds()(edge) * tension / std::max(std::abs(e.by_length), least);
    return length * length;
}

}  // namespace

bool LawBlur::agrees_with(const LawBlur& other) const {
    constexpr double same = 0.1;
    const auto agree = [same](const auto& a, const auto& b) {
        return ((a - b).array().abs() <= same * b.array()).all();
    };
    // Compared by their roots; below a nanometre they count as none.
    constexpr double smallest = 1e-18;
    return agree(strain_stds, other.strain_stds) &&
           agree((stiffness.array() + smallest).sqrt().matrix(),
                 (other.stiffness.array() + smallest).sqrt().matrix());
}

Eigen::VectorXd LawBlur::length_variances(Eigen::Index count) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(count);
    if (missed.size() > 0) {
        result += missed;
    }
    if (stiffness.size() > 0) {
        result += stiffness;
    }
    return result;
}

LawBlur blur_by(const CableNet& net, double extension_std,
                const std::vector<UncertainParameter>& uncertain) {
    LawBlur result;
    if (!net.is_linear()) {
        result.strain_stds = extension_std * net.unstressed_lengths().cwiseInverse();
        result.missed = Eigen::VectorXd::Zero(net.interior_edge_count());
    }
    if (std_of(uncertain, UncertainParameter::Kind::stiffness_each) > 0.0) {
        result.stiffness = elastic_stretches(net)
                               .cwiseAbs()
                               .cwiseProduct(own_stiffness_stds(net, uncertain))
                               .cwiseAbs2()(net.interior_edges());
    }
    return result;
}

LawBlur blur_found(const StaticsModel& model, const Covariance& covariance, const Iterate& fitted,
                   const Observations& observations) {
    constexpr double slowest = 0.5;        // smallest factor in one round
    constexpr double most_variance = 1e2;  // of the prior's variance, where the tension law is flat
    const double widest_prior = observations.variance.maxCoeff();
    const Eigen::VectorXd lengths = edge_lengths(model.net(), fitted.form);
    LawBlur found = model.blur;
    for (int e = 0; e < lengths.size(); ++e) {
        const int i = model.numbering().interior_of[e];
        if (i >= 0 && found.stiffness.size() > 0 && !model.slack[e]) {
            found.stiffness(i) =
                std::min(stiffness_as_length(model, e, fitted), most_variance * widest_prior);
        }
        const TensionLaw* law = model.net().bent_law(e);
        if (law == nullptr || model.slack[e]) {
            continue;
        }
        const double unstressed = model.unstressed_length(e, fitted);
        const double variance =
            i >= 0 ? covariance.extensions(i) : length_variance(model, covariance, e, fitted);
        const double std_dev = std::max(std::sqrt(std::max(0.0, variance)) / unstressed,
                                        slowest * model.blur.strain_stds(e));
        found.strain_stds(e) = std_dev;
        if (i >= 0) {
            const double strain = lengths(e) / unstressed - 1.0;
            const double slope =
                std::max(law->blurred(strain, std_dev).slope, 1e-6 * law->steepest());
            found.missed(i) =
                std::min(law->missed_by_blurred(strain, std_dev) * std::pow(unstressed / slope, 2),
                         most_variance * widest_prior);
        }
    }
    return found;
}

}  // namespace taut
