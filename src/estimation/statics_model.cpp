// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/statics_model.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "sampling/uncertain_widths.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// The stretch that corresponds to an edge's tension, and its derivative by the extension.
struct Stretch {
    double value;
    double rate;
};

/// (rounded-law); without a width the extension itself. Written as a quotient to avoid cancellation
/// when the edge is far from taut.
Stretch stretch(double extension, double width) {
    if (!(width > 0.0)) {
        return {.value = extension, .rate = 1.0};
    }
    const double root = std::hypot(extension, 2.0 * width);
    const double value =
        extension > 0.0 ? 0.5 * (root + extension) : 2.0 * width * width / (root - extension);
    return {.value = value, .rate = value / root};
}

Supports supports_of(const std::vector<UncertainParameter>& uncertain) {
    return std_of(uncertain, UncertainParameter::Kind::supports) > 0.0 ? Supports::uncertain
                                                                       : Supports::fixed;
}

}  // namespace

StaticsNumbering::StaticsNumbering(const CableNet& net, Supports of_supports)
    : supports(of_supports),
      local(number_for_elimination(net, Ordering::thorough)),
      local_of(net.node_count()),
      interior_of(net.edge_count(), -1),
      free_nodes(local.node_of.begin(), local.node_of.begin() + local.free_count),
      nodes(supports == Supports::uncertain ? local.node_of : free_nodes) {
    for (size_t i = 0; i < local.node_of.size(); ++i) {
        local_of[local.node_of[i]] = static_cast<int>(i);
    }
    for (size_t i = 0; i < net.interior_edges().size(); ++i) {
        interior_of[net.interior_edges()[i]] = static_cast<int>(i);
    }
}

StaticsModel::StaticsModel(const CableNet& net, const std::vector<UncertainParameter>& uncertain,
                           bool frame_is_unknown, const Points& test_loads)
    : common(net, uncertain, frame_is_unknown, test_loads),
      slack(net.edge_count(), false),
      m_net(&net),
      m_own_stiffness_stds(taut::own_stiffness_stds(net, uncertain)),
      m_numbering(std::make_shared<const StaticsNumbering>(net, supports_of(uncertain))) {}

double StaticsModel::unstressed_length(int edge, const Iterate& iterate) const {
    const int i = m_numbering->interior_of[edge];
    const double cold = m_net->unstressed_lengths()(edge) + (i >= 0 ? iterate.deviations(i) : 0.0);
    return (cold + common.slip(edge, iterate.common)) *
           (1.0 + common.thermal_strain(edge, iterate.common));
}

/// The tension law, blurred or fixed, at a strain; without factors of uncertain parameters.
TensionLaw::Tangent StaticsModel::law_tangent(int edge, double strain) const {
    if (!m_fixed_laws.empty()) {  // (drawn-law)
        const auto& [at, tangent] = m_fixed_laws[edge];
        return {.tension = tangent.tension + tangent.slope * (strain - at), .slope = tangent.slope};
    }
    const double strain_std = blur.strain_stds.size() > 0 ? blur.strain_stds(edge) : 0.0;
    return m_net->tension_law(edge)->blurred(strain, strain_std);
}

void StaticsModel::fix_tension_laws(const Iterate& iterate) {
    std::vector<FixedLaw> fixed(m_net->edge_count());
    const Eigen::VectorXd spans = edge_lengths(*m_net, iterate.form);
    for (int e = 0; e < m_net->edge_count(); ++e) {
        if (m_net->bent_law(e) != nullptr) {
            const double unstressed = unstressed_length(e, iterate);
            const double strain = stretch(spans(e) - unstressed, corner_width).value / unstressed;
            fixed[e] = {.strain = strain, .tangent = law_tangent(e, strain)};
        }
    }
    m_fixed_laws = std::move(fixed);
}

EdgeRates StaticsModel::rates(int edge, const Iterate& iterate) const {
    const auto [s, t] = m_net->edges()[edge];
    const double unstressed = unstressed_length(edge, iterate);
    const double stiffness = common.stiffness_factor(edge, iterate.common);
    const Eigen::Vector3d vector = iterate.form.col(s) - iterate.form.col(t);
    const double length = vector.norm();
    const Stretch e = stretch(length - unstressed, m_net->can_be_slack(edge) ? corner_width : 0.0);
    double axial = stiffness * m_net->axial_stiffness()(edge) / unstressed;
    double tension = axial * e.value;
    double by_stiffness = tension;
    double by_sag = 0.0;
    if (const TensionLaw* law = m_net->tension_law(edge); law != nullptr && law->sags()) {
        const double S = law->sag * common.sag_factor(iterate.common);
        const auto tangent =
            sagging_tangent(stiffness * m_net->axial_stiffness()(edge), S, e.value / unstressed);
        by_sag = 2.0 * tangent.slope * std::pow(S / tangent.tension, 2);
        by_stiffness = tangent.tension * tangent.slope / (axial * unstressed);  // (sagging-law)
        axial = tangent.slope / unstressed;
        tension = tangent.tension;
    } else if (law != nullptr) {
        const auto tangent = law_tangent(edge, e.value / unstressed);
        axial = stiffness * tangent.slope / unstressed;
        tension = stiffness * tangent.tension;
        by_stiffness = tension;
    }
    const double heated = 1.0 + common.thermal_strain(edge, iterate.common);
    return {.direction = vector / length,
            .tension = tension,
            .across = tension / length,
            .axial = axial * e.rate,
            .by_length = -heated * axial * (e.value / unstressed + e.rate),
            .by_sag = by_sag,
            .by_stiffness = by_stiffness};
}

EdgeVariation StaticsModel::common_variation(int edge, int k, const Iterate& iterate) const {
    const auto [first, second] = m_net->edges()[edge];
    const double heated = 1.0 + common.thermal_strain(edge, iterate.common);
    EdgeVariation result{.stiffness = common.stiffness_rate(k, edge),
                         .length = unstressed_length(edge, iterate) * common.thermal_rate(k, edge) /
                                       (heated * heated) +
                                   common.slip_rate(k, edge),
                         .sag = common.sag_rate(k)};
    if (!are_supports_uncertain()) {
        // (frame): of known supports; uncertain ones carry the motion in their own places.
        result.motion = common.support_rate(k, first) - common.support_rate(k, second);
    }
    return result;
}

Eigen::VectorXd StaticsModel::tensions(const Iterate& iterate) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(m_net->edge_count());
    for (int e = 0; e < m_net->edge_count(); ++e) {
        if (!slack[e]) {
            result(e) = rates(e, iterate).tension;
        }
    }
    return result;
}

Eigen::VectorXd StaticsModel::load_factors(const Iterate& iterate) const {
    Eigen::VectorXd result = Eigen::VectorXd::Ones(m_net->node_count());
    for (const ElasticSupport& support : m_net->elastic_supports()) {
        result(support.node) = common.support_factor(iterate.common);
    }
    return result;
}

Points StaticsModel::designed_elastic_forces(const Iterate& iterate) const {
    Points result = elastic_forces(*m_net, iterate.form);
    for (const Points& by_places :
         {common.frame_loads(iterate.common), common.place_loads(iterate.common)}) {
        if (by_places.cols() > 0) {
            result -= by_places;
        }
    }
    return result;
}

Points StaticsModel::imbalance(const Iterate& iterate) const {
    Points forces = common.support_factor(iterate.common) * designed_elastic_forces(iterate) -
                    m_net->loads() - iterate.loads * load_factors(iterate).asDiagonal();
    if (const Points change = common.load_change(iterate.common); change.cols() > 0) {
        forces -= change;
    }
    for (int e = 0; e < m_net->edge_count(); ++e) {
        if (!slack[e]) {
            const auto [s, t] = m_net->edges()[e];
            const Eigen::Vector3d force = rates(e, iterate).force();
            forces.col(s) += force;
            forces.col(t) -= force;
        }
    }
    return forces;
}

Points StaticsModel::support_deviations(const Iterate& iterate) const {
    Points result = Points::Zero(3, m_net->node_count());
    const Points moved = iterate.form - m_net->nodes() - common.support_motion(iterate.common);
    result(Eigen::all, m_net->supports()) = moved(Eigen::all, m_net->supports());
    return result;
}

double StaticsModel::quadratic_terms(const Observations& observations, const Iterate& change,
                                     double of_supports) const {
    double sum = observations.squared_norm(change.form) +
                 change.deviations.cwiseAbs2().cwiseQuotient(prior_variances(observations)).sum() +
                 change.common.squaredNorm();
    sum += of_supports;
    const bool has_cross = observations.cross_load_variance.cols() > 0;
    for (const int node : m_net->free_nodes()) {
        const Eigen::Vector3d load = change.loads.col(node);
        const Eigen::Vector3d variance = observations.load_variance.col(node);
        if (has_cross && !observations.cross_load_variance.col(node).isZero(0.0)) {
            sum += load.dot(observations.load_covariance(node).llt().solve(load));
        } else {
            sum += (variance.array() > 0.0)
                       .select(load.array().square() / variance.array(), 0.0)
                       .sum();
        }
    }
    return sum;
}

double StaticsModel::objective(const Observations& observations, const Iterate& iterate) const {
    const Iterate misfit{.form = iterate.form - observations.form,
                         .deviations = iterate.deviations - observations.mean,
                         .loads = iterate.loads - observations.load_mean,
                         .common = iterate.common - observations.common_mean};
    double of_evidence = 0.0;
    if (observations.evidence) {
        const Eigen::VectorXd x = iterate.lengths_and_common(observations.evidence_pull.size());
        of_evidence = 0.5 * (observations.evidence->root.transpose() * x).squaredNorm() -
                      observations.evidence_pull.dot(x);
    }
    const Points of_supports = observations.support_mean - support_deviations(iterate);
    const Eigen::VectorXd of_forces =
        observations.tension - observations.measured(tensions(iterate), iterate.common);
    return of_evidence +
           0.5 * (quadratic_terms(observations, misfit, 0.0) +
                  observations.support_weights.cwiseProduct(of_supports.cwiseAbs2()).sum() +
                  observations.tension_weights.dot(of_forces.cwiseAbs2()));
}

}  // namespace taut
