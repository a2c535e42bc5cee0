// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/predicted_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"
#include "identification/parameter_estimates.hpp"
#include "taut/estimation/length_posterior.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// The most probable status of a taut edge, over deviations from the prior and errors of the survey
/// at evenly spaced quantiles of both.
/// @param std of the length deviation after the survey, to first order [m]
EdgeStatus probable_status(const LengthPrior& prior, double std) {
    LengthLikelihood likelihood = without_prior(0.0, prior.std(), 0.0, std);
    if (!std::isfinite(likelihood.std)) {
        return EdgeStatus::not_determined;
    }
    constexpr int count = 10;
    const LengthPrior errors{LengthPrior::Kind::normal, likelihood.std};
    std::array<int, 4> found{};
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < count; ++k) {
            likelihood.mean = prior.draw((i + 0.5) / count) + errors.draw((k + 0.5) / count);
            const EdgeStatus status = status_of(prior.std(), posterior_of(prior, likelihood));
            ++found.at(static_cast<size_t>(status));
        }
    }
    return static_cast<EdgeStatus>(std::ranges::max_element(found) - found.begin());
}

/// A fit linearised at the design, with all that is given.
class Prediction {
public:
    Prediction(const CableNet& net, const Points& form, const Survey& survey,
               const LengthPrior& prior, const Forces& forces,
               const std::vector<UncertainParameter>& uncertain)
        : m_net(net),
          m_fit_net(net_to_fit(net, uncertain)),
          m_knowledge(
              knowledge_of(m_fit_net, prior, uncertain, forces, adjustable_stds(net, uncertain))),
          m_fit(fit(form, survey, prior)),
          m_tensions(m_fit.model().tensions(m_fit.iterate)) {}
    Prediction(const Prediction&) = delete;
    Prediction& operator=(const Prediction&) = delete;

    /// Of the length deviations (m_I) [m2].
    [[nodiscard]] Eigen::VectorXd length_variances(const LengthPrior& prior) const {
        const double of_prior = prior.std() * prior.std();
        const Eigen::VectorXd blur =
            m_fit.model().blur.length_variances(m_fit_net.interior_edge_count());
        const Eigen::VectorXd& found = m_fit.covariance.lengths;
        const bool has_all = m_fit_net.interior_edge_count() > m_net.interior_edge_count();
        Eigen::VectorXd result(m_net.interior_edge_count());
        for (int k = 0; k < result.size(); ++k) {
            const int i = has_all ? m_net.interior_edges()[k] : k;
            // At loose nodes rounding errors can exceed a variance: then the prior applies. With a
            // stiffness of its own per edge the fit finds the sum of both.
            const double own = of_prior / (of_prior + blur(i));
            result(k) = found(i) > 0.0 ? own * blur(i) + own * own * found(i) : of_prior;
        }
        return result;
    }

    void add_tensions(PredictedPrecision& result, double relative_force_std) const {
        const Eigen::VectorXd& variances = m_fit.covariance.tensions;
        const Eigen::VectorXd with_mean = m_fit.linearisation.covariances_with(
            Eigen::VectorXd::Constant(m_net.edge_count(), 1.0 / m_net.edge_count()));
        const double of_mean = with_mean.mean();
        result.mean_tension = m_tensions.mean();
        result.mean_tension_std = std::sqrt(std::max(0.0, of_mean));
        std::vector<bool> is_measured(m_net.edge_count(), false);
        for (const ForceMeasurement& force : m_knowledge.forces.measurements) {
            is_measured[force.edge] = true;
        }
        for (int e = 0; e < m_net.edge_count(); ++e) {
            if (is_measured[e] || !(m_tensions(e) > 0.0) || !(variances(e) > 0.0)) {
                continue;
            }
            const double noise = relative_force_std * m_tensions(e);
            const double left =
                of_mean - with_mean(e) * with_mean(e) / (variances(e) + noise * noise);
            result.force_candidates.push_back(
                {.edge = e,
                 .tension = m_tensions(e),
                 .std = std::sqrt(variances(e)),
                 .mean_std_if_measured = std::sqrt(std::max(0.0, left))});
        }
        std::ranges::sort(result.force_candidates, {}, [](const TensionPrecision& t) {
            return std::pair(t.mean_std_if_measured, t.edge);
        });
    }

private:
    [[nodiscard]] LinearisedFit fit(const Points& form, const Survey& survey,
                                    const LengthPrior& prior) const {
        StaticsModel model(m_fit_net, m_knowledge.uncertain);
        for (const int edge : slack_edges(m_net, m_net.unstressed_lengths(), form)) {
            model.slack[edge] = true;
        }
        model.blur = blur_by(m_fit_net, prior.std(), m_knowledge.uncertain);
        model.blur.strain_stds.resize(0);  // tension laws as they are at the design
        model.blur.missed.resize(0);
        const int common = model.common.count();
        Iterate design = nominal_iterate(m_fit_net, common);
        design.form = form;
        const std::vector<bool> none_rejected(m_net.node_count(), false);
        const Survey seen = with_supports(m_fit_net, survey);
        return linearised_fit(model, std::move(design),
                              observe(m_fit_net, seen, with_noise_floor(m_net, seen), none_rejected,
                                      m_knowledge, common));
    }

    const CableNet& m_net;
    CableNet m_fit_net;
    PriorKnowledge m_knowledge;
    LinearisedFit m_fit;
    Eigen::VectorXd m_tensions;
};

}  // namespace

int PredictedPrecision::count(EdgeStatus status) const {
    return static_cast<int>(std::ranges::count(edges, status, &EdgePrecision::status));
}

double PredictedPrecision::rms_std() const {
    double sum = 0.0;
    for (const EdgePrecision& e : edges) {
        sum += e.std * e.std;
    }
    return edges.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(edges.size()));
}

PredictedPrecision predicted_precision(const CableNet& net, const Eigen::Ref<const Points>& form,
                                       const Survey& survey, const LengthPrior& prior,
                                       const Forces& forces,
                                       const std::vector<UncertainParameter>& uncertain,
                                       double relative_force_std) {
    if (net.interior_edge_count() == 0) {
        throw std::invalid_argument(
            "the net has no interior edge: all unstressed lengths are known");
    }
    prior.check();
    check_survey(net, survey);
    check_forces(net, forces);
    check_uncertain_parameters(net, uncertain);
    if (survey.is_exact()) {
        require_whole(net, survey, "all, or their noise (standard deviations)");
    }
    const Prediction prediction(net, form, survey, prior, forces, uncertain);
    const Eigen::VectorXd variances = prediction.length_variances(prior);
    const std::vector<int> slack = slack_edges(net, net.unstressed_lengths(), form);
    PredictedPrecision result{.prior_std = prior.std(), .edges = {}};
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const double std = std::sqrt(variances(i));
        const bool is_slack = std::ranges::binary_search(slack, edge);
        result.edges.push_back(
            {.edge = edge,
             .std = std,
             .status = is_slack ? EdgeStatus::slack : probable_status(prior, std)});
    }
    prediction.add_tensions(result, relative_force_std);
    return result;
}

}  // namespace taut
