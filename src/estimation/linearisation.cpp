// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/linearisation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

#include "taut/numerical_error.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Part of a node's axial stiffness that is added to hold a loose node in place.
constexpr double smallest_relative_stiffness = 1e-10;

/// @param lengths coupled where observations have evidence
std::unique_ptr<BorderedFactor> new_matrix(const StaticsNumbering& numbers, Lengths lengths) {
    std::vector<bool> unknown;
    unknown.reserve(numbers.interior_of.size());
    for (const int i : numbers.interior_of) {
        unknown.push_back(i >= 0);
    }
    return std::make_unique<BorderedFactor>(numbers.local, unknown, numbers.supports, lengths);
}

}  // namespace

std::optional<Linearisation> linearise(const StaticsModel& model, const Iterate& iterate,
                                       const Observations& observations,
                                       std::optional<Linearisation> before) {
    Linearisation result;
    result.m_model = std::make_shared<const StaticsModel>(model);
    result.m_matrix =
        before ? std::move(before->m_matrix)
               : new_matrix(model.numbering(),
                            observations.evidence ? Lengths::coupled : Lengths::independent);
    return result.factorize(iterate, observations) ? std::optional(std::move(result))
                                                   : std::nullopt;
}

Linearisation Linearisation::under(StaticsModel model) && {
    m_model = std::make_shared<const StaticsModel>(std::move(model));
    return std::move(*this);
}

LinearisedFit linearised_fit(const StaticsModel& model, Iterate iterate,
                             const Observations& observations) {
    std::optional<Linearisation> found = linearise(model, iterate, observations);
    if (!found) {
        if (std::ranges::all_of(model.slack, std::identity())) {
            throw NumericalError(
                fmt::format("no edge carries a force at this form: unstressed lengths are {:.4g} m "
                            "in the mean, "
                            "distances {:.4g} m. Check units and lengths",
                            model.net().unstressed_lengths().mean(),
                            edge_lengths(model.net(), iterate.form).mean()));
        }
        throw NumericalError(
            "the statics of the net are singular at this form. Check the net and the prior");
    }
    Covariance covariance = found->covariance();
    return {std::move(iterate), *std::move(found), std::move(covariance)};
}

std::optional<LinearisedFit> LinearisedFit::stepped(const Observations& observations) && {
    const StaticsModel& same = model();  // lives until the linearisation does no longer
    std::optional<Linearisation> found =
        linearise(same, iterate, observations, std::move(linearisation));
    if (!found) {
        return std::nullopt;
    }
    const Iterate step = found->step(iterate, observations);
    if (!std::isfinite(found->size_of(step))) {
        return std::nullopt;
    }
    Covariance of_it = found->covariance();
    return LinearisedFit{iterate.moved(step), *std::move(found), std::move(of_it)};
}

bool Linearisation::factorize(const Iterate& iterate, const Observations& observations) {
    const int edge_count = m_model->net().edge_count();
    const int common_count = m_model->common.count();
    m_load_factors = m_model->load_factors(iterate)(m_model->numbering().free_nodes);
    set_weights(observations);
    SaddlePointFactor& matrix = m_matrix->inner;
    std::ranges::fill(matrix.edge_stiffness, Eigen::Matrix3d::Zero());
    std::ranges::fill(matrix.node_stiffness, Eigen::Matrix3d::Zero());
    matrix.length_rates.setZero();
    matrix.force_place_rates.setZero();
    matrix.force_length_rates.setZero();
    m_matrix->set_border_count(common_count);
    std::ranges::fill(m_matrix->border, empty_vector().inner);
    m_tension_rates.setZero(edge_count, common_count);
    m_measured_rates = m_tension_rates;
    for (int e = 0; e < edge_count; ++e) {
        if (!m_model->slack[e]) {
            add_edge(e, iterate, observations);
        }
    }
    set_border(observations);
    add_elastic_supports(iterate);
    if (observations.evidence) {
        set_evidence(observations);
    }
    m_reactions = empty_vector();
    m_multipliers = m_reactions.inner.multipliers;
    if (!m_matrix->factorize()) {
        return false;
    }
    set_reactions(m_matrix->solve(right_side(iterate, observations)).inner.multipliers);
    return true;
}

void Linearisation::set_weights(const Observations& observations) {
    const StaticsNumbering& numbers = m_model->numbering();
    const CableNet& net = m_model->net();
    // By the mean precision, so that a released edge with its wide prior does not set the scale;
    // without edges that are nearly exact.
    const double widest_prior = observations.variance.maxCoeff();
    double precision = 0.0;
    int count = 0;
    for (const double variance : observations.variance) {
        if (variance > 1e-10 * widest_prior) {
            precision += 1.0 / variance;
            ++count;
        }
    }
    m_length_unit = std::sqrt(count / precision);
    m_multiplier_unit =
        1.0 /
        (m_length_unit * net.axial_stiffness().cwiseQuotient(net.unstressed_lengths()).mean());
    const double squared_unit = m_length_unit * m_length_unit;
    SaddlePointFactor& matrix = m_matrix->inner;
    matrix.place_weights = squared_unit * (observations.weights + observations.support_weights)(
                                              Eigen::all, numbers.nodes);
    if (observations.cross_weights.cols() > 0) {
        matrix.cross_place_weights =
            squared_unit * observations.cross_weights(Eigen::all, numbers.nodes);
    } else {
        matrix.cross_place_weights.setZero();
    }
    matrix.length_weights(net.interior_edges()) =
        squared_unit * m_model->prior_variances(observations).cwiseInverse();
    matrix.load_variances = m_multiplier_unit * m_multiplier_unit *
                            observations.load_variance(Eigen::all, numbers.free_nodes) *
                            m_load_factors.cwiseAbs2().asDiagonal();
    if (observations.cross_load_variance.cols() > 0) {
        matrix.cross_load_variances =
            m_multiplier_unit * m_multiplier_unit *
            observations.cross_load_variance(Eigen::all, numbers.free_nodes) *
            m_load_factors.cwiseAbs2().asDiagonal();
    } else {
        matrix.cross_load_variances.setZero();
    }
    matrix.force_weights = observations.tension_weights / (m_multiplier_unit * m_multiplier_unit);
}

void Linearisation::add_edge(int edge, const Iterate& iterate, const Observations& observations) {
    const StaticsNumbering& numbers = m_model->numbering();
    const auto [s, t] = numbers.local.edges[edge];
    const EdgeRates e = m_model->rates(edge, iterate);
    const double unit = m_length_unit * m_multiplier_unit;
    SaddlePointFactor& matrix = m_matrix->inner;
    const Eigen::Matrix3d stiffness = e.stiffness();
    matrix.edge_stiffness[edge] = unit * stiffness;
    matrix.length_rates.col(edge) = unit * e.length_rate();
    matrix.force_place_rates.col(edge) = unit * e.axial * e.direction;
    matrix.force_length_rates(edge) = numbers.interior_of[edge] >= 0 ? unit * e.by_length : 0.0;
    for (const int node : {s, t}) {
        if (node < numbers.local.free_count) {
            matrix.node_stiffness[node] +=
                unit * (stiffness + smallest_relative_stiffness * stiffness.trace() *
                                        Eigen::Matrix3d::Identity());
        }
    }
    for (int k = 0; k < m_model->common.count(); ++k) {  // (common)
        const EdgeVariation variation = m_model->common_variation(edge, k, iterate);
        const double bias = observations.tension_bias(edge, k);
        const double rate = add_to_column(edge, e, variation, bias,
                                          observations.tension_weights(edge), m_matrix->border[k]);
        m_tension_rates(edge, k) = rate;
        m_measured_rates(edge, k) = rate + bias;
        m_matrix->force_rates(edge, k) = m_multiplier_unit * rate;
        m_matrix->force_biases(edge, k) = m_multiplier_unit * bias;
        m_matrix->extension_rates(edge, k) =
            (e.direction.dot(variation.motion) - variation.length) / m_length_unit;
    }
}

/// Adds a factor times the derivative of an edge's tension by its places, (force-measurement).
void Linearisation::add_place_rates(int edge, double factor, Eigen::Matrix3Xd& places) const {
    const auto [s, t] = m_model->numbering().local.edges[edge];
    for (const auto& [node, sign] : {std::pair(s, 1.0), std::pair(t, -1.0)}) {
        if (node < places.cols()) {
            places.col(node) += sign * factor * m_matrix->inner.force_place_rates.col(edge);
        }
    }
}

/// Adds the entries of an edge to the column of a number.
/// @param bias how far the number moves a force measurement from the tension [N]
/// @return change of its tension [N]
double Linearisation::add_to_column(int edge, const EdgeRates& e, const EdgeVariation& variation,
                                    double bias, double force_weight,
                                    BorderedFactor::Inner& column) const {
    const auto [s, t] = m_model->numbering().local.edges[edge];
    const SaddlePointFactor& matrix = m_matrix->inner;
    const double rate = e.tension_by(variation);
    const Eigen::Vector3d force = m_multiplier_unit * e.force_by(variation);
    for (const auto& [node, sign] : {std::pair(s, 1.0), std::pair(t, -1.0)}) {
        if (node < m_model->numbering().local.free_count) {
            column.multipliers.col(node) += sign * force;
        }
    }
    if (force_weight > 0.0) {
        const double pull = matrix.force_weights(edge) * m_multiplier_unit * (rate + bias);
        add_place_rates(edge, pull, column.places);
        column.lengths(edge) += pull * matrix.force_length_rates(edge);
    }
    return rate;
}

/// Adds the entries of the common parameters that belong to no edge.
void Linearisation::set_border(const Observations& observations) {
    const CommonParameters& common = m_model->common;
    for (int k = 0; k < common.count(); ++k) {
        if (const Points& rate = common.load_rate(k); rate.cols() > 0) {
            m_matrix->border[k].multipliers -=
                m_multiplier_unit * rate(Eigen::all, m_model->numbering().free_nodes);
        }
    }
    m_matrix->corner =
        Eigen::MatrixXd::Identity(common.count(), common.count()) +
        m_measured_rates.transpose() * observations.tension_weights.asDiagonal() * m_measured_rates;
    if (common.moves_supports()) {
        add_motions_to_border(observations);
    }
}

/// (elastic-supports)
void Linearisation::add_elastic_supports(const Iterate& iterate) {
    const CommonParameters& common = m_model->common;
    const double factor = common.support_factor(iterate.common);
    const std::vector<SpringPair>& pairs = m_model->numbering().local.spring_pairs;
    for (size_t k = 0; k < pairs.size(); ++k) {
        m_matrix->inner.pair_stiffness[k] =
            m_length_unit * m_multiplier_unit * factor * pairs[k].stiffness;
    }
    const Points forces = m_model->designed_elastic_forces(iterate);
    for (const ElasticSupport& support : m_model->net().elastic_supports()) {
        const int local = m_model->numbering().local_of[support.node];
        m_matrix->inner.node_stiffness[local] +=
            m_length_unit * m_multiplier_unit * factor * support.stiffness;
        const Eigen::Vector3d force = forces.col(support.node) - iterate.loads.col(support.node);
        for (int k = 0; k < common.count(); ++k) {
            m_matrix->border[k].multipliers.col(local) +=
                m_multiplier_unit * factor *
                (common.support_stiffness_rate(k) * force -
                 common.place_load_rate(k, support.node));
        }
    }
}

/// (frame), (boundary): motions of known supports are observed by the survey of these, motions of
/// uncertain ones by their prior.
void Linearisation::add_motions_to_border(const Observations& observations) {
    const CommonParameters& common = m_model->common;
    const auto weighted = [&](int node, const Eigen::Vector3d& rate) -> Eigen::Vector3d {
        if (m_model->are_supports_uncertain()) {
            return observations.support_weights.col(node).cwiseProduct(rate);
        }
        return observations.weight(node) * rate;
    };
    for (int k = 0; k < common.count(); ++k) {
        for (const int node : m_model->net().supports()) {
            const Eigen::Vector3d pull = weighted(node, common.support_rate(k, node));
            for (int i = 0; i < common.count(); ++i) {
                m_matrix->corner(i, k) += common.support_rate(i, node).dot(pull);
            }
            if (m_model->are_supports_uncertain()) {
                m_matrix->border[k].places.col(m_model->numbering().local_of[node]) -=
                    m_length_unit * pull;
            }
        }
    }
}

/// (epoch-evidence)
void Linearisation::set_evidence(const Observations& observations) {
    const Eigen::MatrixXd& information = observations.evidence->information;
    const std::vector<int>& edges = m_model->net().interior_edges();
    const auto lengths = std::ssize(edges);
    const Eigen::Index common = information.rows() - lengths;
    m_matrix->inner.length_couplings(edges, edges) =
        m_length_unit * m_length_unit * information.topLeftCorner(lengths, lengths);
    for (Eigen::Index k = 0; k < common; ++k) {
        m_matrix->border[k].lengths(edges) +=
            m_length_unit * information.col(lengths + k).head(lengths);
    }
    m_matrix->corner.topLeftCorner(common, common) += information.bottomRightCorner(common, common);
}

void Linearisation::set_reactions(const Eigen::Matrix3Xd& multipliers) {
    const StaticsNumbering& numbers = m_model->numbering();
    const int free_count = numbers.local.free_count;
    m_multipliers = multipliers;
    const SaddlePointFactor& matrix = m_matrix->inner;
    for (int node = 0; node < free_count; ++node) {
        m_reactions.inner.places.col(node) = matrix.node_stiffness[node] * multipliers.col(node);
    }
    for (int e = 0; e < m_model->net().edge_count(); ++e) {
        const auto [s, t] = numbers.local.edges[e];
        for (const auto& [node, other, sign] : {std::tuple(s, t, 1.0), std::tuple(t, s, -1.0)}) {
            if (node < free_count) {
                m_reactions.inner.lengths(e) +=
                    sign * matrix.length_rates.col(e).dot(multipliers.col(node));
                if (other < std::ssize(numbers.nodes)) {
                    m_reactions.inner.places.col(other) -=
                        matrix.edge_stiffness[e] * multipliers.col(node);
                }
            }
        }
    }
    for (size_t k = 0; k < numbers.local.spring_pairs.size(); ++k) {
        const auto [first, second] =
            std::pair(numbers.local.spring_pairs[k].first, numbers.local.spring_pairs[k].second);
        const Eigen::Matrix3d& stiffness = matrix.pair_stiffness[k];
        m_reactions.inner.places.col(first) += stiffness * multipliers.col(second);
        m_reactions.inner.places.col(second) += stiffness.transpose() * multipliers.col(first);
    }
    for (int k = 0; k < m_model->common.count(); ++k) {
        m_reactions.border(k) = m_matrix->border[k].multipliers.cwiseProduct(multipliers).sum();
    }
}

BorderedFactor::Vector Linearisation::empty_vector() const {
    const StaticsNumbering& numbers = m_model->numbering();
    return {.inner = {.places = Eigen::Matrix3Xd::Zero(3, std::ssize(numbers.nodes)),
                      .lengths = Eigen::VectorXd::Zero(m_model->net().edge_count()),
                      .multipliers = Eigen::Matrix3Xd::Zero(3, numbers.local.free_count)},
            .border = Eigen::VectorXd::Zero(m_model->common.count())};
}

BorderedFactor::Vector Linearisation::right_side(const Iterate& iterate,
                                                 const Observations& observations) const {
    const StaticsNumbering& numbers = m_model->numbering();
    const CommonParameters& common = m_model->common;
    // (uncertain-parameters): a load gives way to its reaction.
    const Points given_way =
        (observations.load_mean - iterate.loads)(Eigen::all, numbers.free_nodes) *
        m_load_factors.asDiagonal();
    const Points forces = m_model->imbalance(iterate)(Eigen::all, numbers.free_nodes) - given_way;
    const Points measured = observations.weighted(observations.form - iterate.form);
    const Points of_supports = observations.support_weights.cwiseProduct(
        observations.support_mean - m_model->support_deviations(iterate));
    const Points misfit = measured + of_supports;
    BorderedFactor::Vector result{
        .inner = {.places =
                      m_length_unit * misfit(Eigen::all, numbers.nodes) - m_reactions.inner.places,
                  .lengths = -m_reactions.inner.lengths,
                  .multipliers =
                      -m_multiplier_unit * forces + m_matrix->inner.loads_by(m_multipliers)},
        .border = observations.common_mean - iterate.common - m_reactions.border};
    result.inner.lengths(m_model->net().interior_edges()) +=
        m_length_unit * (observations.mean - iterate.deviations)
                            .cwiseQuotient(m_model->prior_variances(observations));
    if (common.moves_supports()) {
        const Points pull = m_model->are_supports_uncertain() ? Points(-of_supports) : measured;
        for (int k = 0; k < common.count(); ++k) {
            for (const int node : m_model->net().supports()) {
                result.border(k) += common.support_rate(k, node).dot(pull.col(node));
            }
        }
    }
    add_force_measurements(iterate, observations, result);
    if (observations.evidence) {
        add_evidence(iterate, observations, result);
    }
    return result;
}

/// (force-measurement)
void Linearisation::add_force_measurements(const Iterate& iterate, const Observations& observations,
                                           BorderedFactor::Vector& right_side) const {
    const SaddlePointFactor& matrix = m_matrix->inner;
    for (int e = 0; e < m_model->net().edge_count(); ++e) {
        if (!(observations.tension_weights(e) > 0.0) || m_model->slack[e]) {
            continue;
        }
        const double misfit = observations.tension(e) - m_model->rates(e, iterate).tension -
                              observations.tension_bias.row(e).dot(iterate.common);
        const double pull = matrix.force_weights(e) * m_multiplier_unit * misfit;
        add_place_rates(e, pull, right_side.inner.places);
        right_side.inner.lengths(e) += pull * matrix.force_length_rates(e);
        right_side.border +=
            observations.tension_weights(e) * misfit * m_measured_rates.row(e).transpose();
    }
}

void Linearisation::add_evidence(const Iterate& iterate, const Observations& observations,
                                 BorderedFactor::Vector& right_side) const {
    const std::vector<int>& edges = m_model->net().interior_edges();
    const Eigen::VectorXd& pull = observations.evidence_pull;
    const Eigen::VectorXd misfit =
        pull - observations.evidence->information * iterate.lengths_and_common(pull.size());
    const auto lengths = std::ssize(edges);
    right_side.inner.lengths(edges) += m_length_unit * misfit.head(lengths);
    right_side.border.head(pull.size() - lengths) += misfit.tail(pull.size() - lengths);
}

Iterate Linearisation::step(const Iterate& iterate, const Observations& observations) const {
    const StaticsNumbering& numbers = m_model->numbering();
    const CableNet& net = m_model->net();
    const BorderedFactor::Vector solution = m_matrix->solve(right_side(iterate, observations));
    Iterate change{.form = m_model->common.support_motion(solution.border),
                   .deviations = m_length_unit * solution.inner.lengths(net.interior_edges()),
                   .loads = observations.load_mean - iterate.loads,
                   .common = solution.border};
    change.form(Eigen::all, numbers.nodes) = m_length_unit * solution.inner.places;
    change.loads(Eigen::all, numbers.free_nodes) +=
        m_matrix->inner.loads_by(m_multipliers + solution.inner.multipliers) *
        m_load_factors.cwiseInverse().asDiagonal() / m_multiplier_unit;
    return change;
}

double Linearisation::size_of(const Iterate& step) const {
    double size = std::max(step.form.cwiseAbs().maxCoeff(), step.deviations.cwiseAbs().maxCoeff());
    if (step.common.size() > 0) {
        size = std::max(size, m_length_unit * step.common.cwiseAbs().maxCoeff());
    }
    const bool is_finite = std::isfinite(size) && step.form.allFinite() &&
                           step.deviations.allFinite() && step.common.allFinite();
    return is_finite ? size : std::numeric_limits<double>::infinity();
}

double Linearisation::squared_norm(const Observations& observations, const Iterate& change) const {
    const Points of_supports = change.form - m_model->common.support_motion(change.common);
    double sum = m_model->quadratic_terms(
        observations, change,
        observations.support_weights.cwiseProduct(of_supports.cwiseAbs2()).sum());
    if (observations.evidence) {
        const Eigen::VectorXd x = change.lengths_and_common(observations.evidence_pull.size());
        sum += (observations.evidence->root.transpose() * x).squaredNorm();
    }
    const SaddlePointFactor& matrix = m_matrix->inner;
    const double unit = 1.0 / (m_length_unit * m_multiplier_unit);
    for (int e = 0; e < m_model->net().edge_count(); ++e) {
        if (observations.tension_weights(e) > 0.0 && !m_model->slack[e]) {
            const auto [s, t] = m_model->net().edges()[e];
            const int i = m_model->numbering().interior_of[e];
            const double by_length =
                i >= 0 ? matrix.force_length_rates(e) * change.deviations(i) : 0.0;
            const double tension =
                unit *
                    (matrix.force_place_rates.col(e).dot(change.form.col(s) - change.form.col(t)) +
                     by_length) +
                m_measured_rates.row(e).dot(change.common);
            sum += observations.tension_weights(e) * tension * tension;
        }
    }
    return sum;
}

}  // namespace taut
