// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "estimation/linearisation.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/forces.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// The fit of a survey that is yet to be made, linearised at the design, with all that is given.
class PlannedFit {
public:
    /// Keeps a reference to the net.
    /// @param form equilibrium of the nominal lengths (3 x n) [m]
    /// @param survey which nodes, and their noise; its form is not used
    /// @param forces edges whose tensions are measured, and their noise
    /// @param given what is uncertain, to which with_slips() adds
    /// @throws std::invalid_argument for arguments of other nets, a bad prior, and where the net
    ///   has no interior edge
    /// @throws SurveyError as check_survey(), and where the survey is exact and not whole
    /// @throws NumericalError where the statics are singular at this form
    PlannedFit(const CableNet& net, const Points& form, const Survey& survey,
               const LengthPrior& prior, const Forces& forces,
               const std::vector<UncertainParameter>& given);
    PlannedFit(const PlannedFit&) = delete;
    PlannedFit& operator=(const PlannedFit&) = delete;

    [[nodiscard]] const CableNet& net() const { return m_net; }
    /// As of net_to_fit().
    [[nodiscard]] const CableNet& fit_net() const { return *m_fit_net; }
    [[nodiscard]] const PriorKnowledge& knowledge() const { return *m_knowledge; }
    [[nodiscard]] const Linearisation& linearisation() const { return m_fit->linearisation; }
    [[nodiscard]] const StaticsModel& model() const { return m_fit->model(); }
    [[nodiscard]] const Covariance& covariance() const { return m_fit->covariance; }
    /// Of the lengths between their nodes of the edges of a stretch that slides [m2].
    [[nodiscard]] Eigen::VectorXd variances_between_nodes(const std::vector<int>& stretch) const;
    /// Of all unknowns, as Linearisation::joint_covariance().
    /// @param with_trend with what lengths have in common, (length-trend), as identify() has it
    ///   unless its prior is exact
    [[nodiscard]] Eigen::MatrixXd joint_covariance(bool with_trend) const;
    /// The design.
    [[nodiscard]] const Iterate& iterate() const { return m_fit->iterate; }
    /// As designed, of all edges (m) [N].
    [[nodiscard]] const Eigen::VectorXd& tensions() const { return m_tensions; }
    [[nodiscard]] bool is_measured(int edge) const {
        return std::ranges::any_of(m_knowledge->forces.measurements,
                                   [edge](const auto& one) { return one.edge == edge; });
    }

private:
    const CableNet& m_net;
    std::optional<CableNet> m_fit_net;
    std::optional<PriorKnowledge> m_knowledge;
    Observations m_observations;
    Eigen::VectorXd m_adjustable_stds;  ///< m_I of the net to fit [m]
    LengthPrior m_prior;
    std::optional<LinearisedFit> m_fit;
    Eigen::VectorXd m_tensions;
};

/// The statics of a net linearised at its design: slack edges as in a form (3 x n), stiffnesses of
/// their own as a blur.
/// @param fit_net net_to_fit() of it; referred to
[[nodiscard]] StaticsModel designed_model(const CableNet& fit_net, const Points& form,
                                          const PriorKnowledge& knowledge, double prior_std);

}  // namespace taut
