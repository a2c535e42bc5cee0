// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/planned_fit.hpp"

#include <stdexcept>
#include <utility>

#include "estimation/observations.hpp"
#include "identification/parameter_estimates.hpp"
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
                       const std::vector<UncertainParameter>& uncertain)
    : m_net(net) {
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
    m_fit_net = net_to_fit(net, uncertain);
    m_knowledge =
        knowledge_of(*m_fit_net, prior, uncertain, forces, adjustable_stds(net, uncertain));
    StaticsModel model = designed_model(*m_fit_net, form, *m_knowledge, prior.std());
    const int common = model.common.count();
    Iterate design = nominal_iterate(*m_fit_net, common);
    design.form = form;
    const std::vector<bool> none_rejected(net.node_count(), false);
    const Survey seen = with_supports(*m_fit_net, survey);
    m_fit = linearised_fit(model, std::move(design),
                           observe(*m_fit_net, seen, with_noise_floor(net, seen), none_rejected,
                                   *m_knowledge, common));
    m_tensions = m_fit->model().tensions(m_fit->iterate);
}

}  // namespace taut
