// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/exact_balance.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "estimation/balance_equations.hpp"
#include "estimation/length_likelihoods.hpp"
#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/slack_set.hpp"
#include "identification/completion.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Prior widths of the lengths, in standard deviations of the noise floor: wide enough to leave
/// them free, and no wider, since variances far below the prior are lost in rounding errors. The
/// second is for lengths that the form determines so badly that the first would bind them.
constexpr double narrow_bound = 1e2;
constexpr double wide_bound = 1e4;
constexpr double widest_part_of_bound = 3.0;

/// An exact form is met to rounding errors by the lengths that balance it. If it is missed by more
/// than this part of an edge length, the intervals would be those of an exact survey around wrong
/// lengths.
constexpr double rounding_of_form = 1e-7;

/// Length deviations (m_I) from y, with any edge that balances with no positive length.
struct BalancedDeviations {
    Eigen::VectorXd deviations;
    Eigen::VectorXd spread;  ///< to either side, where a tension law is flat [m]
    int impossible_edge = -1;
};

BalancedDeviations balanced_deviations(const CableNet& net, const Points& form,
                                       const BalanceEquations& balance) {
    const Eigen::VectorXd y = balance.solve();
    const Eigen::VectorXd lengths = edge_lengths(net, form);
    BalancedDeviations result{.deviations = Eigen::VectorXd(y.size()),
                              .spread = Eigen::VectorXd::Zero(y.size())};
    for (Eigen::Index i = 0; i < y.size(); ++i) {
        const int edge = net.interior_edges()[i];
        const auto [least, greatest] = unstressed_lengths_from(net, edge, lengths(edge), y(i));
        if (!(least > 0.0 && std::isfinite(greatest))) {
            result.impossible_edge = edge;
            return result;
        }
        result.deviations(i) = 0.5 * (least + greatest) - net.unstressed_lengths()(edge);
        result.spread(i) = 0.5 * (greatest - least);
    }
    return result;
}

/// Likelihoods of the lengths by an exact form, around its balance.
class ExactForm {
public:
    ExactForm(const CableNet& net, const Survey& survey, const LengthPrior& prior)
        : m_net(net),
          m_survey(survey),
          m_noise(with_noise_floor(net, survey)),
          m_none_rejected(net.node_count(), false),
          m_balanced(nominal_iterate(net)),
          m_knowledge(net, prior),
          m_model(net) {
        m_balanced.form = survey.form;
        m_model.slack =
            slack_by_lengths(net, edge_lengths(net, m_balanced.form), m_knowledge.priors);
        const BalanceEquations balance(net, m_balanced.form, m_model.slack);
        const BalancedDeviations balanced = balanced_deviations(net, m_balanced.form, balance);
        m_balanced.deviations = balanced.deviations;
        m_spread = balanced.spread;
        m_impossible_edge = balanced.impossible_edge;
        m_undetermined = balance.undetermined();
    }

    ExactForm(const ExactForm&) = delete;
    ExactForm& operator=(const ExactForm&) = delete;

    /// An edge that balances with no positive length; -1: none.
    [[nodiscard]] int impossible_edge() const { return m_impossible_edge; }
    [[nodiscard]] const Points& form() const { return m_balanced.form; }

    [[nodiscard]] std::vector<LengthLikelihood> likelihoods(const LengthPrior& prior) const {
        const double unit = m_noise.maxCoeff();
        auto result = likelihoods_within(narrow_bound * unit);
        const auto replace = [&](double bound, const auto& applies) {
            std::vector<size_t> edges;
            for (size_t i = 0; i < result.size(); ++i) {
                const auto edge = static_cast<size_t>(m_net.interior_edges()[i]);
                if (!m_model.slack[edge] && applies(i)) {
                    edges.push_back(i);
                }
            }
            if (!edges.empty()) {
                const auto found = likelihoods_within(bound);
                for (const size_t i : edges) {
                    result[i] = found[i];
                }
            }
        };
        replace(wide_bound * unit, [&](size_t i) {
            return !m_undetermined[i] &&
                   result[i].std_dev > widest_part_of_bound * narrow_bound * unit;
        });
        replace(prior.std_dev(), [&](size_t i) { return m_undetermined[i]; });
        bound_where_flat(result, prior);
        return result;
    }

private:
    /// Where a tension law is flat, all lengths of that part are equally likely. If the prior
    /// allows none of them, the predicted form shows it.
    void bound_where_flat(std::vector<LengthLikelihood>& likelihoods,
                          const LengthPrior& prior) const {
        for (size_t i = 0; i < likelihoods.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            const double middle = m_balanced.deviations(k);
            if (m_spread(k) > 0.0 && std::abs(middle) - m_spread(k) < prior.reach()) {
                likelihoods[i].least = middle - m_spread(k);
                likelihoods[i].most = middle + m_spread(k);
            }
        }
    }

    /// With a normal prior of this standard deviation around the balance, which is taken out again.
    [[nodiscard]] std::vector<LengthLikelihood> likelihoods_within(double length_std) const {
        Observations observations = observe(m_net, m_survey, m_noise, m_none_rejected, length_std);
        observations.mean = m_balanced.deviations;
        const LinearisedFit fit = linearised_fit(m_model, m_balanced, observations);
        return length_likelihoods(m_knowledge, m_model, fit.covariance, observations, m_balanced);
    }

    const CableNet& m_net;
    const Survey& m_survey;
    Points m_noise;
    std::vector<bool> m_none_rejected;
    Iterate m_balanced;
    PriorKnowledge m_knowledge;
    StaticsModel m_model;
    Eigen::VectorXd m_spread;          ///< m_I, as BalancedDeviations
    std::vector<bool> m_undetermined;  ///< m_I
    int m_impossible_edge = -1;
};

/// @param edge that balances with no positive length; -1: none
/// @return whether there is one, and the result reports it
bool has_impossible_edge(Identification& result, const CableNet& net, int edge) {
    if (edge < 0) {
        return false;
    }
    result.status = IdentificationStatus::survey_does_not_fit;
    result.message = fmt::format(
        "the forces at the surveyed form balance with no positive length of edge '{}'. Check that "
        "the survey is exact",
        net.edge_id(edge));
    return true;
}

/// Sets the status where the predicted form is not the surveyed one.
void check_exact_form(Identification& result, const CableNet& net, const LengthPrior& prior) {
    if (result.status != IdentificationStatus::converged) {
        return;
    }
    const double miss = std::sqrt(result.residuals.cwiseAbs2().mean());
    if (miss > rounding_of_form * edge_lengths(net, net.nodes()).mean()) {
        result.status = IdentificationStatus::survey_not_exact;
        result.message = fmt::format(
            "is given as exact, but no lengths of the prior {} give its form: those found miss it "
            "by {:.3g} mm RMS. Give its noise, or another prior",
            to_string(prior), 1e3 * miss);
    }
}

}  // namespace

Identification identify_by_exact_balance(const CableNet& net, const Survey& survey,
                                         const LengthPrior& prior) {
    const ExactForm exact(net, survey, prior);
    Identification result{.method = "balance", .length_prior = prior};
    if (has_impossible_edge(result, net, exact.impossible_edge())) {
        return result;
    }
    result.length_prior = prior;
    set_edges(result, net, std::vector(net.interior_edge_count(), prior), exact.likelihoods(prior));
    predict_form(result, net, survey, exact.form());
    check_exact_form(result, net, prior);
    return result;
}

Identification check_exactness(const CableNet& net, const Survey& survey,
                               const LengthPrior& prior) {
    const std::vector<LengthPrior> priors(net.interior_edge_count(), prior);
    const std::vector<bool> slack = slack_by_lengths(net, edge_lengths(net, survey.form), priors);
    const BalancedDeviations balanced =
        balanced_deviations(net, survey.form, BalanceEquations(net, survey.form, slack));
    Identification result{.length_prior = prior};
    if (has_impossible_edge(result, net, balanced.impossible_edge)) {
        return result;
    }
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const double deviation = std::clamp(balanced.deviations(i), -prior.reach(), prior.reach());
        const int edge = net.interior_edges()[i];
        result.edges.push_back({.edge = edge,
                                .nominal = net.unstressed_lengths()(edge),
                                .length_deviation = deviation});
    }
    predict_form(result, net, survey, survey.form);
    check_exact_form(result, net, prior);
    return result;
}

}  // namespace taut
