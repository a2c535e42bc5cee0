// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/planned_fit.hpp"

#include <stdexcept>
#include <utility>

#include "estimation/length_trend.hpp"
#include "estimation/observations.hpp"
#include "identification/identify_options.hpp"
#include "identification/parameter_estimates.hpp"
#include "identification/stretch_lengths.hpp"
#include "numerics/dense.hpp"
#include "sampling/uncertain_widths.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

StaticsModel designed_model(const CableNet& fit_net, const Points& form,
                            const PriorKnowledge& knowledge, double prior_std) {
    StaticsModel model(fit_net, knowledge.uncertain);
    for (const int edge : slack_edges(fit_net, fit_net.unstressed_lengths(), form)) {
        model.slack[edge] = true;
    }
    model.blur = blur_by(fit_net, prior_std, knowledge.uncertain);
    model.blur.strain_stds.resize(0);  // tension laws as they are at the design
    model.blur.missed.resize(0);
    return model;
}

PlannedFit::PlannedFit(const CableNet& net, const Points& form, const Survey& survey,
                       const LengthPrior& prior, const Forces& forces,
                       const std::vector<UncertainParameter>& given)
    : m_net(net), m_prior(prior) {
    if (net.interior_edge_count() == 0) {
        throw std::invalid_argument(
            "the net has no interior edge: all unstressed lengths are known");
    }
    prior.check();
    check_survey(net, survey);
    check_forces(net, forces);
    check_forces_on_runs(net, forces);
    check_for_one_survey(net, given);
    const std::vector<UncertainParameter> uncertain = with_slips(net, given);
    if (survey.is_exact()) {
        require_whole(net, survey, "all, or their noise (standard deviations)");
    }
    m_fit_net = net_to_fit(net, uncertain);
    const Eigen::VectorXd stds = adjustable_stds(net, uncertain);
    m_knowledge = knowledge_of(*m_fit_net, prior, uncertain, forces, stds);
    StaticsModel model = designed_model(*m_fit_net, form, *m_knowledge, prior.std_dev());
    const int common = model.common.count();
    Iterate design = nominal_iterate(*m_fit_net, common);
    design.form = form;
    const std::vector<bool> none_rejected(net.node_count(), false);
    const Survey seen = with_supports(*m_fit_net, survey);
    m_observations =
        observe(*m_fit_net, seen, with_noise_floor(net, seen), none_rejected, *m_knowledge, common);
    m_observations.mean.setZero();
    m_adjustable_stds = stds(m_fit_net->interior_edges());
    if (std_of(uncertain, UncertainParameter::Kind::adjustable) == 0.0) {
        m_adjustable_stds.setZero();  // as good as known
    }
    m_fit = linearised_fit(model, std::move(design), m_observations);
    m_tensions = m_fit->model().tensions(m_fit->iterate);
}

Eigen::VectorXd PlannedFit::variances_between_nodes(const std::vector<int>& stretch) const {
    return covariance_between_nodes(*m_fit, m_observations, stretch).diagonal();
}

Eigen::MatrixXd PlannedFit::joint_covariance(bool with_trend) const {
    Eigen::MatrixXd result = linearisation().joint_covariance();
    if (!with_trend) {
        return result;
    }
    std::vector<bool> left_out;
    left_out.reserve(m_knowledge->priors.size());
    for (size_t i = 0; i < m_knowledge->priors.size(); ++i) {
        left_out.push_back(m_knowledge->priors[i] != m_prior ||
                           model().slack[m_fit_net->interior_edges()[i]]);
    }
    const LengthTrend trend =
        trend_of(*m_fit, m_observations, left_out, m_adjustable_stds, m_prior);
    if (trend.empty()) {
        return result;
    }
    const Eigen::Index lengths = m_fit_net->interior_edge_count();
    const Eigen::MatrixXd pulls =
        model().prior_variances(m_observations).cwiseInverse().asDiagonal() *
        (trend.columns * trend.root);
    const Eigen::MatrixXd gains =
        product(result.middleCols(Eigen::Index{3} * m_net.node_count(), lengths), pulls);
    return result + product(gains, gains.transpose());
}

}  // namespace taut
