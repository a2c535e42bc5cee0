// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/linearised_statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "numerics/parallel.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Part of a node's axial stiffness that is added to hold a loose node in place.
constexpr double smallest_relative_stiffness = 1e-10;

std::vector<bool> interior_flags(const CableNet& net) {
    std::vector<bool> flags(net.edge_count(), false);
    for (const int edge : net.interior_edges()) {
        flags[edge] = true;
    }
    return flags;
}

Supports supports_of(const std::vector<UncertainParameter>& uncertain) {
    return std_of(uncertain, UncertainParameter::Kind::supports) > 0.0 ? Supports::uncertain
                                                                       : Supports::fixed;
}

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
        const Eigen::VectorXd stretch =
            (edge_lengths(net, net.nodes()) - net.unstressed_lengths()).cwiseMax(0.0);
        result.stiffness = stretch.cwiseProduct(own_stiffness_stds(net, uncertain))
                               .cwiseAbs2()(net.interior_edges());
    }
    return result;
}

LinearisedStatics::LinearisedStatics(const CableNet& net,
                                     const std::vector<UncertainParameter>& uncertain,
                                     bool frame_is_unknown, const BoundaryReleases& released,
                                     Lengths lengths)
    : m_net(net),
      m_uncertain(uncertain),
      m_common(net, uncertain, frame_is_unknown, released),
      m_own_stiffness_stds(own_stiffness_stds(net, uncertain)),
      m_local(number_for_elimination(net, Ordering::thorough)),
      m_local_of(net.node_count()),
      m_interior_of(net.edge_count(), -1),
      m_free_nodes(m_local.node_of.begin(), m_local.node_of.begin() + m_local.free_count),
      m_nodes(m_free_nodes),
      m_slack(net.edge_count(), false),
      m_matrix(m_local, interior_flags(net), supports_of(uncertain), lengths, m_common.count()) {
    for (size_t i = 0; i < m_local.node_of.size(); ++i) {
        m_local_of[m_local.node_of[i]] = static_cast<int>(i);
    }
    for (size_t i = 0; i < net.interior_edges().size(); ++i) {
        m_interior_of[net.interior_edges()[i]] = static_cast<int>(i);
    }
    if (supports_of(uncertain) == Supports::uncertain) {
        m_nodes = m_local.node_of;
    }
}

void LinearisedStatics::set_released(const BoundaryReleases& released) {
    m_common = CommonParameters(m_net, m_uncertain, m_common.has_frame(), released);
    m_matrix.set_border_count(m_common.count());
}

double LinearisedStatics::unstressed_length(int edge, const Iterate& iterate) const {
    const int i = m_interior_of[edge];
    const double cold = m_net.unstressed_lengths()(edge) + (i >= 0 ? iterate.deviations(i) : 0.0);
    return cold * (1.0 + m_common.thermal_strain(edge, iterate.common));
}

TensionLaw::Tangent LinearisedStatics::law_tangent(int edge, double strain) const {
    if (!m_fixed_laws.empty()) {  // (drawn-law)
        const auto& [at, tangent] = m_fixed_laws[edge];
        return {.tension = tangent.tension + tangent.slope * (strain - at), .slope = tangent.slope};
    }
    const double strain_std = m_blur.strain_stds.size() > 0 ? m_blur.strain_stds(edge) : 0.0;
    return m_net.tension_law(edge)->blurred(strain, strain_std);
}

void LinearisedStatics::fix_tension_laws(const Iterate& iterate) {
    std::vector<FixedLaw> fixed(m_net.edge_count());
    const Eigen::VectorXd lengths = edge_lengths(m_net, iterate.form);
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (m_net.tension_law(e) != nullptr) {
            const double unstressed = unstressed_length(e, iterate);
            const double strain =
                stretch(lengths(e) - unstressed, m_corner_width).value / unstressed;
            fixed[e] = {.strain = strain, .tangent = law_tangent(e, strain)};
        }
    }
    m_fixed_laws = std::move(fixed);
}

/// docs/theory.md, (edge rates)
LinearisedStatics::EdgeRates LinearisedStatics::rates(int edge, const Iterate& iterate) const {
    const auto [s, t] = m_net.edges()[edge];
    const double unstressed = unstressed_length(edge, iterate);
    const double stiffness = m_common.stiffness_factor(edge, iterate.common);
    const Eigen::Vector3d vector = iterate.form.col(s) - iterate.form.col(t);
    const double length = vector.norm();
    const Stretch e = stretch(length - unstressed, m_corner_width);
    double axial = stiffness * m_net.axial_stiffness()(edge) / unstressed;
    double tension = axial * e.value;
    if (m_net.tension_law(edge) != nullptr) {
        const auto [at_strain, slope] = law_tangent(edge, e.value / unstressed);
        axial = stiffness * slope / unstressed;
        tension = stiffness * at_strain;
    }
    const double heated = 1.0 + m_common.thermal_strain(edge, iterate.common);
    return {.direction = vector / length,
            .tension = tension,
            .across = tension / length,
            .axial = axial * e.rate,
            .by_length = -heated * axial * (e.value / unstressed + e.rate)};
}

/// Variance of an edge's length from the covariances of its two ends, treated as independent. An
/// end at a known support contributes nothing.
double LinearisedStatics::length_variance(int edge, const Iterate& iterate) const {
    const auto [s, t] = m_net.edges()[edge];
    const Eigen::Vector3d u = (iterate.form.col(s) - iterate.form.col(t)).normalized();
    double variance = 0.0;
    for (const int node : {s, t}) {
        if (m_local_of[node] < std::ssize(m_nodes)) {
            variance += u.dot(form_covariance(node) * u);
        }
    }
    return variance;
}

/// (own-stiffness): T kappa = dT/dd times the length [m2].
double LinearisedStatics::stiffness_as_length(int edge, const Iterate& iterate) const {
    const EdgeRates e = rates(edge, iterate);
    const double least = 1e-6 * m_net.axial_stiffness()(edge) / m_net.unstressed_lengths()(edge);
    const double length = m_own_stiffness_stds(edge) * std::max(0.0, e.tension) /
                          std::max(std::abs(e.by_length), least);
    return length * length;
}

LawBlur LinearisedStatics::blur_found(const Iterate& iterate) const {
    constexpr double slowest = 0.5;        // smallest factor in one round
    constexpr double most_variance = 1e2;  // of the prior's variance, where the tension law is flat
    const double squared_unit = m_length_unit * m_length_unit;
    const Eigen::VectorXd lengths = edge_lengths(m_net, iterate.form);
    LawBlur found = m_blur;
    for (int e = 0; e < m_net.edge_count(); ++e) {
        const int i = m_interior_of[e];
        if (i >= 0 && m_blur.stiffness.size() > 0 && !m_slack[e]) {
            found.stiffness(i) =
                std::min(stiffness_as_length(e, iterate), most_variance * m_widest_prior);
        }
        const TensionLaw* law = m_net.tension_law(e);
        if (law == nullptr || m_slack[e]) {
            continue;
        }
        const double unstressed = unstressed_length(e, iterate);
        const double variance =
            i >= 0 ? squared_unit * m_covariance.extensions(e) : length_variance(e, iterate);
        const double std = std::max(std::sqrt(std::max(0.0, variance)) / unstressed,
                                    slowest * m_blur.strain_stds(e));
        found.strain_stds(e) = std;
        if (i >= 0) {
            const double strain = lengths(e) / unstressed - 1.0;
            const double slope = std::max(law->blurred(strain, std).slope, 1e-6 * law->steepest());
            found.missed(i) =
                std::min(law->missed_by_blurred(strain, std) * std::pow(unstressed / slope, 2),
                         most_variance * m_widest_prior);
        }
    }
    return found;
}

void LinearisedStatics::set_weights(const Observations& observations) {
    // By the mean precision, so that a released edge with its wide prior does not set the scale;
    // without edges that are nearly exact.
    m_widest_prior = observations.variance.maxCoeff();
    double precision = 0.0;
    int count = 0;
    for (const double variance : observations.variance) {
        if (variance > 1e-10 * m_widest_prior) {
            precision += 1.0 / variance;
            ++count;
        }
    }
    m_length_unit = std::sqrt(count / precision);
    m_multiplier_unit =
        1.0 /
        (m_length_unit * m_net.axial_stiffness().cwiseQuotient(m_net.unstressed_lengths()).mean());
    const double squared_unit = m_length_unit * m_length_unit;
    SaddlePointFactor& matrix = m_matrix.inner;
    matrix.place_weights =
        squared_unit * (observations.weights + observations.support_weights)(Eigen::all, m_nodes);
    if (observations.cross_weights.cols() > 0) {
        matrix.cross_place_weights = squared_unit * observations.cross_weights(Eigen::all, m_nodes);
    } else {
        matrix.cross_place_weights.setZero();
    }
    matrix.length_weights(m_net.interior_edges()) =
        squared_unit * prior_variances(observations).cwiseInverse();
    matrix.load_variances = m_multiplier_unit * m_multiplier_unit *
                            observations.load_variance(Eigen::all, m_free_nodes);
    matrix.force_weights = observations.tension_weights / (m_multiplier_unit * m_multiplier_unit);
}

void LinearisedStatics::add_edge(int edge, const Iterate& iterate,
                                 const Observations& observations) {
    const auto [s, t] = m_local.edges[edge];
    const EdgeRates e = rates(edge, iterate);
    const double unit = m_length_unit * m_multiplier_unit;
    SaddlePointFactor& matrix = m_matrix.inner;
    const Eigen::Matrix3d stiffness = e.stiffness();
    matrix.edge_stiffness[edge] = unit * stiffness;
    matrix.length_rates.col(edge) = unit * e.length_rate();
    matrix.force_place_rates.col(edge) = unit * e.axial * e.direction;
    matrix.force_length_rates(edge) = m_interior_of[edge] >= 0 ? unit * e.by_length : 0.0;
    for (const int node : {s, t}) {
        if (node < m_local.free_count) {
            matrix.node_stiffness[node] +=
                unit * (stiffness + smallest_relative_stiffness * stiffness.trace() *
                                        Eigen::Matrix3d::Identity());
        }
    }
    for (int k = 0; k < m_common.count(); ++k) {  // (common)
        const EdgeVariation variation = common_variation(edge, k, iterate);
        const double rate = add_to_column(edge, e, variation, observations.tension_weights(edge),
                                          m_matrix.border[k]);
        m_tension_rates(edge, k) = rate;
        m_matrix.force_rates(edge, k) = m_multiplier_unit * rate;
        m_matrix.extension_rates(edge, k) =
            (e.direction.dot(variation.motion) - variation.length) / m_length_unit;
    }
}

LinearisedStatics::EdgeVariation LinearisedStatics::common_variation(int edge, int k,
                                                                     const Iterate& iterate) const {
    const auto [first, second] = m_net.edges()[edge];
    const double heated = 1.0 + m_common.thermal_strain(edge, iterate.common);
    EdgeVariation result{.stiffness = m_common.stiffness_rate(k, edge),
                         .length = unstressed_length(edge, iterate) *
                                   m_common.thermal_rate(k, edge) / (heated * heated)};
    if (!are_supports_uncertain()) {
        // (frame): of known supports; uncertain ones carry the motion in their own places.
        result.motion = m_common.support_rate(k, first) - m_common.support_rate(k, second);
    }
    return result;
}

double LinearisedStatics::tension_rate_of(const EdgeRates& e, const EdgeVariation& variation) {
    return e.tension * variation.stiffness + e.axial * e.direction.dot(variation.motion) +
           e.by_length * variation.length;
}

/// Change of the force at an edge's first end, in units of the multipliers.
Eigen::Vector3d LinearisedStatics::force_of(const EdgeRates& e,
                                            const EdgeVariation& variation) const {
    const double along = e.direction.dot(variation.motion);
    return m_multiplier_unit * (tension_rate_of(e, variation) * e.direction +
                                e.across * (variation.motion - along * e.direction));
}

/// Adds a factor times the derivative of an edge's tension by its places, (force-measurement).
void LinearisedStatics::add_place_rates(int edge, double factor, Eigen::Matrix3Xd& places) const {
    const auto [s, t] = m_local.edges[edge];
    for (const auto& [node, sign] : {std::pair(s, 1.0), std::pair(t, -1.0)}) {
        if (node < places.cols()) {
            places.col(node) += sign * factor * m_matrix.inner.force_place_rates.col(edge);
        }
    }
}

/// Adds the entries of an edge to the column of a number.
/// @return change of its tension [N]
double LinearisedStatics::add_to_column(int edge, const EdgeRates& e,
                                        const EdgeVariation& variation, double force_weight,
                                        BorderedFactor::Inner& column) const {
    const auto [s, t] = m_local.edges[edge];
    const SaddlePointFactor& matrix = m_matrix.inner;
    const double rate = tension_rate_of(e, variation);
    const Eigen::Vector3d force = force_of(e, variation);
    for (const auto& [node, sign] : {std::pair(s, 1.0), std::pair(t, -1.0)}) {
        if (node < m_local.free_count) {
            column.multipliers.col(node) += sign * force;
        }
    }
    if (force_weight > 0.0) {
        const double pull = matrix.force_weights(edge) * m_multiplier_unit * rate;
        add_place_rates(edge, pull, column.places);
        column.lengths(edge) += pull * matrix.force_length_rates(edge);
    }
    return rate;
}

/// Adds the entries of the common parameters that belong to no edge.
void LinearisedStatics::set_border(const Observations& observations) {
    for (int k = 0; k < m_common.count(); ++k) {
        m_matrix.border[k].multipliers -=
            m_multiplier_unit * m_common.load_rate(k) * m_net.loads()(Eigen::all, m_free_nodes);
    }
    m_matrix.corner =
        Eigen::MatrixXd::Identity(m_common.count(), m_common.count()) +
        m_tension_rates.transpose() * observations.tension_weights.asDiagonal() * m_tension_rates;
    if (m_common.moves_supports()) {
        add_motions_to_border(observations);
    }
}

/// (epoch-evidence)
void LinearisedStatics::set_evidence(const Observations& observations) {
    const Eigen::MatrixXd& information = observations.evidence->information;
    const std::vector<int>& edges = m_net.interior_edges();
    const auto lengths = std::ssize(edges);
    const Eigen::Index common = information.rows() - lengths;
    m_matrix.inner.length_couplings(edges, edges) =
        m_length_unit * m_length_unit * information.topLeftCorner(lengths, lengths);
    for (Eigen::Index k = 0; k < common; ++k) {
        m_matrix.border[k].lengths(edges) +=
            m_length_unit * information.col(lengths + k).head(lengths);
    }
    m_matrix.corner.topLeftCorner(common, common) += information.bottomRightCorner(common, common);
}

void LinearisedStatics::add_evidence(const Iterate& iterate, const Observations& observations,
                                     BorderedFactor::Vector& right_side) const {
    const Eigen::VectorXd& pull = observations.evidence_pull;
    const Eigen::VectorXd misfit =
        pull - observations.evidence->information * iterate.lengths_and_common(pull.size());
    const auto lengths = std::ssize(m_net.interior_edges());
    right_side.inner.lengths(m_net.interior_edges()) += m_length_unit * misfit.head(lengths);
    right_side.border.head(pull.size() - lengths) += misfit.tail(pull.size() - lengths);
}

/// (frame), (boundary): motions of known supports are observed by the survey of these, motions of
/// uncertain ones by their prior.
void LinearisedStatics::add_motions_to_border(const Observations& observations) {
    const auto weighted = [&](int node, const Eigen::Vector3d& rate) -> Eigen::Vector3d {
        if (are_supports_uncertain()) {
            return observations.support_weights.col(node).cwiseProduct(rate);
        }
        return observations.weight(node) * rate;
    };
    for (int k = 0; k < m_common.count(); ++k) {
        for (const int node : m_net.supports()) {
            const Eigen::Vector3d pull = weighted(node, m_common.support_rate(k, node));
            for (int i = 0; i < m_common.count(); ++i) {
                m_matrix.corner(i, k) += m_common.support_rate(i, node).dot(pull);
            }
            if (are_supports_uncertain()) {
                m_matrix.border[k].places.col(m_local_of[node]) -= m_length_unit * pull;
            }
        }
    }
}

Points LinearisedStatics::support_deviations(const Iterate& iterate) const {
    Points result = Points::Zero(3, m_net.node_count());
    const Points moved = iterate.form - m_net.nodes() - m_common.support_motion(iterate.common);
    result(Eigen::all, m_net.supports()) = moved(Eigen::all, m_net.supports());
    return result;
}

/// Prior mean of the supports' deviations less these (3 x n) [m].
Points LinearisedStatics::support_misfit(const Iterate& iterate,
                                         const Observations& observations) const {
    return observations.support_mean - support_deviations(iterate);
}

bool LinearisedStatics::linearise(const Iterate& iterate, const Observations& observations) {
    set_weights(observations);
    SaddlePointFactor& matrix = m_matrix.inner;
    std::ranges::fill(matrix.edge_stiffness, Eigen::Matrix3d::Zero());
    std::ranges::fill(matrix.node_stiffness, Eigen::Matrix3d::Zero());
    matrix.length_rates.setZero();
    matrix.force_place_rates.setZero();
    matrix.force_length_rates.setZero();
    const auto node_count = std::ssize(m_nodes);
    for (BorderedFactor::Inner& column : m_matrix.border) {
        column = empty_vector().inner;
    }
    m_tension_rates.setZero(m_net.edge_count(), m_common.count());
    m_matrix.force_rates.setZero();
    m_matrix.extension_rates.setZero();
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (!m_slack[e]) {
            add_edge(e, iterate, observations);
        }
    }
    set_border(observations);
    if (observations.evidence) {
        set_evidence(observations);
    }
    m_multipliers.setZero(3, m_local.free_count);
    m_place_reactions.setZero(3, node_count);
    m_length_reactions.setZero(m_net.edge_count());
    m_common_reactions.setZero(m_common.count());
    if (!m_matrix.factorize()) {
        return false;
    }
    set_reactions(m_matrix.solve(right_side(iterate, observations)).inner.multipliers);
    return true;
}

void LinearisedStatics::set_reactions(const Eigen::Matrix3Xd& multipliers) {
    m_multipliers = multipliers;
    const SaddlePointFactor& matrix = m_matrix.inner;
    for (int node = 0; node < m_local.free_count; ++node) {
        m_place_reactions.col(node) = matrix.node_stiffness[node] * multipliers.col(node);
    }
    const auto node_count = std::ssize(m_nodes);
    for (int e = 0; e < m_net.edge_count(); ++e) {
        m_length_reactions(e) = 0.0;
        const auto [s, t] = m_local.edges[e];
        for (const auto& [node, other, sign] : {std::tuple(s, t, 1.0), std::tuple(t, s, -1.0)}) {
            if (node < m_local.free_count) {
                m_length_reactions(e) +=
                    sign * matrix.length_rates.col(e).dot(multipliers.col(node));
                if (other < node_count) {
                    m_place_reactions.col(other) -=
                        matrix.edge_stiffness[e] * multipliers.col(node);
                }
            }
        }
    }
    for (int k = 0; k < m_common.count(); ++k) {
        m_common_reactions(k) = m_matrix.border[k].multipliers.cwiseProduct(multipliers).sum();
    }
}

BorderedFactor::Vector LinearisedStatics::right_side(const Iterate& iterate,
                                                     const Observations& observations) const {
    Points forces = -m_common.load_factor(iterate.common) * m_net.loads() - iterate.loads;
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (!m_slack[e]) {
            const auto [s, t] = m_net.edges()[e];
            const Eigen::Vector3d force = rates(e, iterate).force();
            forces.col(s) += force;
            forces.col(t) -= force;
        }
    }
    // (uncertain-parameters): a load gives way to its reaction.
    forces -= observations.load_mean - iterate.loads;
    const Points measured = observations.weighted(observations.form - iterate.form);
    const Points of_supports =
        observations.support_weights.cwiseProduct(support_misfit(iterate, observations));
    const Points misfit = measured + of_supports;
    BorderedFactor::Vector result{
        .inner = {.places = m_length_unit * misfit(Eigen::all, m_nodes) - m_place_reactions,
                  .lengths = -m_length_reactions,
                  .multipliers = -m_multiplier_unit * forces(Eigen::all, m_free_nodes) +
                                 m_matrix.inner.load_variances.cwiseProduct(m_multipliers)},
        .border = observations.common_mean - iterate.common - m_common_reactions};
    result.inner.lengths(m_net.interior_edges()) +=
        m_length_unit *
        (observations.mean - iterate.deviations).cwiseQuotient(prior_variances(observations));
    if (m_common.moves_supports()) {
        for (int k = 0; k < m_common.count(); ++k) {
            for (const int node : m_net.supports()) {
                result.border(k) += m_common.support_rate(k, node).dot(
                    are_supports_uncertain() ? Eigen::Vector3d(-of_supports.col(node))
                                             : Eigen::Vector3d(measured.col(node)));
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
void LinearisedStatics::add_force_measurements(const Iterate& iterate,
                                               const Observations& observations,
                                               BorderedFactor::Vector& right_side) const {
    const SaddlePointFactor& matrix = m_matrix.inner;
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (!(observations.tension_weights(e) > 0.0) || m_slack[e]) {
            continue;
        }
        const double misfit = observations.tension(e) - rates(e, iterate).tension;
        const double pull = matrix.force_weights(e) * m_multiplier_unit * misfit;
        add_place_rates(e, pull, right_side.inner.places);
        right_side.inner.lengths(e) += pull * matrix.force_length_rates(e);
        right_side.border +=
            observations.tension_weights(e) * misfit * m_tension_rates.row(e).transpose();
    }
}

Iterate LinearisedStatics::step(const Iterate& iterate, const Observations& observations) const {
    const BorderedFactor::Vector solution = m_matrix.solve(right_side(iterate, observations));
    Iterate change{.form = Points::Zero(3, m_net.node_count()),
                   .deviations = m_length_unit * solution.inner.lengths(m_net.interior_edges()),
                   .loads = observations.load_mean - iterate.loads,
                   .common = solution.border};
    change.form = m_common.support_motion(solution.border);
    change.form(Eigen::all, m_nodes) = m_length_unit * solution.inner.places;
    change.loads(Eigen::all, m_free_nodes) +=
        m_matrix.inner.load_variances.cwiseProduct(m_multipliers + solution.inner.multipliers) /
        m_multiplier_unit;
    return change;
}

double LinearisedStatics::size_of(const Iterate& step) const {
    double size = std::max(step.form.cwiseAbs().maxCoeff(), step.deviations.cwiseAbs().maxCoeff());
    if (step.common.size() > 0) {
        size = std::max(size, m_length_unit * step.common.cwiseAbs().maxCoeff());
    }
    const bool is_finite = std::isfinite(size) && step.form.allFinite() &&
                           step.deviations.allFinite() && step.common.allFinite();
    return is_finite ? size : std::numeric_limits<double>::infinity();
}

/// The terms of squared_norm() and objective() that need no linearisation.
/// @param of_supports that of the supports' prior
double LinearisedStatics::quadratic_terms(const Observations& observations, const Iterate& change,
                                          double of_supports) const {
    double sum = observations.squared_norm(change.form) +
                 change.deviations.cwiseAbs2().cwiseQuotient(prior_variances(observations)).sum() +
                 change.common.squaredNorm();
    sum += of_supports;
    sum += (observations.load_variance.array() > 0.0)
               .select(change.loads.array().square() / observations.load_variance.array(), 0.0)
               .sum();
    return sum;
}

double LinearisedStatics::squared_norm(const Observations& observations,
                                       const Iterate& change) const {
    const Points of_supports = change.form - m_common.support_motion(change.common);
    double sum =
        quadratic_terms(observations, change,
                        observations.support_weights.cwiseProduct(of_supports.cwiseAbs2()).sum());
    if (observations.evidence) {
        const Eigen::VectorXd x = change.lengths_and_common(observations.evidence_pull.size());
        sum += (observations.evidence->root.transpose() * x).squaredNorm();
    }
    const double unit = 1.0 / (m_length_unit * m_multiplier_unit);
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (observations.tension_weights(e) > 0.0 && !m_slack[e]) {
            const auto [s, t] = m_net.edges()[e];
            const int i = m_interior_of[e];
            const double tension =
                unit *
                    (m_matrix.inner.force_place_rates.col(e).dot(change.form.col(s) -
                                                                 change.form.col(t)) +
                     (i >= 0 ? m_matrix.inner.force_length_rates(e) * change.deviations(i) : 0.0)) +
                m_tension_rates.row(e).dot(change.common);
            sum += observations.tension_weights(e) * tension * tension;
        }
    }
    return sum;
}

double LinearisedStatics::objective(const Observations& observations,
                                    const Iterate& iterate) const {
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
    const Eigen::VectorXd of_forces = observations.tension - tensions(iterate);
    return of_evidence + 0.5 * (quadratic_terms(observations, misfit, 0.0) +
                                observations.support_weights
                                    .cwiseProduct(support_misfit(iterate, observations).cwiseAbs2())
                                    .sum() +
                                observations.tension_weights.dot(of_forces.cwiseAbs2()));
}

Eigen::VectorXd LinearisedStatics::tensions(const Iterate& iterate) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(m_net.edge_count());
    for (int e = 0; e < m_net.edge_count(); ++e) {
        if (!m_slack[e]) {
            result(e) = rates(e, iterate).tension;
        }
    }
    return result;
}

Eigen::VectorXd LinearisedStatics::length_variances() const {
    return m_length_unit * m_length_unit * m_covariance.lengths(m_net.interior_edges());
}

Eigen::VectorXd LinearisedStatics::extension_variances() const {
    return m_length_unit * m_length_unit * m_covariance.extensions(m_net.interior_edges());
}

Eigen::Matrix3d LinearisedStatics::form_covariance(int node) const {
    if (m_local_of[node] >= std::ssize(m_nodes)) {  // (frame)
        Eigen::Matrix3Xd rates(3, m_common.count());
        for (int k = 0; k < m_common.count(); ++k) {
            rates.col(k) = m_common.support_rate(k, node);
        }
        return rates * m_covariance.border * rates.transpose();
    }
    return m_length_unit * m_length_unit * m_covariance.places[m_local_of[node]];
}

Eigen::VectorXd LinearisedStatics::tension_variances() const {
    return m_covariance.forces / (m_multiplier_unit * m_multiplier_unit);
}

/// V + V Z V, Z the inverse over the multipliers.
Eigen::Matrix3d LinearisedStatics::load_covariance(int node) const {
    const int local = m_local_of[node];
    const Eigen::Vector3d variance = m_matrix.inner.load_variances.col(local);
    const Eigen::Matrix3d V = variance.asDiagonal();
    return (V + V * m_covariance.multipliers[local] * V) / (m_multiplier_unit * m_multiplier_unit);
}

/// a' Z g, with g the weighted sum of all a.
Eigen::VectorXd LinearisedStatics::covariances_with(const Eigen::VectorXd& weights) const {
    const SaddlePointFactor& matrix = m_matrix.inner;
    const auto node_count = std::ssize(m_nodes);
    BorderedFactor::Vector sum = empty_vector();
    sum.inner.lengths = weights.cwiseProduct(matrix.force_length_rates);
    sum.border = m_multiplier_unit * m_tension_rates.transpose() * weights;
    for (int e = 0; e < m_net.edge_count(); ++e) {
        add_place_rates(e, weights(e), sum.inner.places);
    }
    const BorderedFactor::Vector varied = m_matrix.solve(sum);
    Eigen::VectorXd result(m_net.edge_count());
    for (int e = 0; e < m_net.edge_count(); ++e) {
        double of_edge = matrix.force_length_rates(e) * varied.inner.lengths(e) +
                         m_multiplier_unit * m_tension_rates.row(e).dot(varied.border);
        const auto [s, t] = m_local.edges[e];
        for (const auto& [node, sign] : {std::pair(s, 1.0), std::pair(t, -1.0)}) {
            if (node < node_count) {
                of_edge +=
                    sign * matrix.force_place_rates.col(e).dot(varied.inner.places.col(node));
            }
        }
        result(e) = of_edge / (m_multiplier_unit * m_multiplier_unit);
    }
    return result;
}

Eigen::MatrixXd LinearisedStatics::evidence_covariance(int common_count) const {
    const std::vector<int>& edges = m_net.interior_edges();
    const auto lengths = static_cast<int>(std::ssize(edges));
    Eigen::MatrixXd result(lengths + common_count, lengths + common_count);
    parallel_for(0, lengths + common_count, [&](int k) {
        BorderedFactor::Vector unit = empty_vector();
        (k < lengths ? unit.inner.lengths(edges[k]) : unit.border(k - lengths)) = 1.0;
        const BorderedFactor::Vector column = m_matrix.solve(unit);
        result.col(k) << m_length_unit * column.inner.lengths(edges),
            column.border.head(common_count);
    });
    result.leftCols(lengths) *= m_length_unit;
    return 0.5 * (result + result.transpose());
}

Eigen::MatrixXd LinearisedStatics::length_covariance(const std::vector<int>& edges) const {
    const auto count = std::ssize(edges);
    Eigen::MatrixXd result(count, count);
    parallel_for(std::ptrdiff_t{0}, count, [&](std::ptrdiff_t k) {
        BorderedFactor::Vector unit = empty_vector();
        unit.inner.lengths(edges[k]) = 1.0;
        result.col(k) = m_length_unit * m_length_unit * m_matrix.solve(unit).inner.lengths(edges);
    });
    return 0.5 * (result + result.transpose());
}

LinearisedStatics::LengthResponse LinearisedStatics::response_to_lengths(
    const Eigen::MatrixXd& weights) const {
    const std::vector<int>& edges = m_net.interior_edges();
    LengthResponse result{.lengths = Eigen::MatrixXd(weights.rows(), weights.cols()),
                          .common = Eigen::MatrixXd(m_common.count(), weights.cols())};
    parallel_for(Eigen::Index{0}, weights.cols(), [&](Eigen::Index k) {
        BorderedFactor::Vector sum = empty_vector();
        sum.inner.lengths(edges) = weights.col(k);
        const BorderedFactor::Vector varied = m_matrix.solve(sum);
        result.lengths.col(k) = m_length_unit * m_length_unit * varied.inner.lengths(edges);
        result.common.col(k) = m_length_unit * varied.border.head(m_common.count());
    });
    return result;
}

}  // namespace taut
