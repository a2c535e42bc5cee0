// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/identification_parts.hpp"

#include <algorithm>
#include <cmath>

#include "results/result_parts.hpp"

namespace taut {
namespace {

std::vector<IdentificationResult::Residual> residuals_of(const Survey& survey,
                                                         const Points& predicted) {
    std::vector<IdentificationResult::Residual> residuals;
    for (const int node : survey.surveyed) {
        const Eigen::Vector3d d = survey.form.col(node) - predicted.col(node);
        residuals.push_back({.node = node, .surveyed_less_predicted = d, .standardised = {}});
        if (survey.noise_std.cols() > 0 && survey.noise_std.col(node).minCoeff() > 0.0) {
            residuals.back().standardised = d.cwiseQuotient(survey.noise_std.col(node));
        }
    }
    return residuals;
}

/// Root mean square of the stated standard deviations [m].
double noise_of(const Survey& survey) {
    if (survey.noise_std.cols() == 0) {
        return 0.0;
    }
    const Points stds = survey.noise_std(Eigen::all, survey.surveyed);
    return std::sqrt(stds.squaredNorm() / static_cast<double>(stds.size()));
}

double rms_residual(const Identification& found, const Context& c) {
    const Eigen::VectorXd residuals = residuals_in_use(found, *c.survey);
    const double in_use = std::max(1.0, static_cast<double>(residuals.size()));
    return std::sqrt(residuals.squaredNorm() / in_use);
}

std::vector<DrawnTension> adjustable_tensions(const Identification& found, const Context& c) {
    std::vector<DrawnTension> tensions;
    if (!found.drawn.tensions.empty()) {
        for (const int edge : c.net->adjustable_edges()) {
            tensions.push_back(found.drawn.tensions[edge]);
        }
    }
    return tensions;
}

// Objects of an identification that have no struct of their own.

Description<Identification> prior_check_object() {
    return Description<Identification>()
        .key(
            "likeliest",
            [](const Identification& found) {
                const PriorCheck& check = found.prior_check;
                return check.lengths > 0 ? to_string(check.likeliest) : "";
            },
            "Among uniform, normal and bimodal ones; empty with too few lengths.")
        .key("gain", TAUT_VALUE(it.prior_check.gain), "In log likelihood over the prior used.")
        .key("lengths", TAUT_VALUE(it.prior_check.lengths), whole,
             "Number of lengths that it is based on.")
        .key("mean", TAUT_VALUE(it.prior_check.mean), "Common mean of the deviations [m].")
        .key("mean_std", TAUT_VALUE(it.prior_check.mean_std), size)
        .key("outliers", TAUT_VALUE(it.prior_check.outliers), whole,
             "Number of length outliers, where they are too many for cutting errors.")
        .key("found", TAUT_VALUE(it.contradicted_prior.has_value()),
             "Whether the prior used was estimated from the survey.")
        .key(
            "contradicted",
            [](const Identification& found) {
                const auto& prior = found.contradicted_prior;
                return prior ? std::optional(prior->checked) : std::nullopt;
            },
            "The prior that it replaced: the given one, or the default.");
}

Description<Identification> diagnostics_object() {
    return Description<Identification>("diagnostics")
        .key("noise", TAUT_VALUE(it.scales.noise))
        .key("lengths", TAUT_VALUE(it.scales.lengths))
        .object("prior", prior_check_object())
        .key("frame", &Identification::frame_check)
        .newer("noise_by_axis", TAUT_VALUE(it.scales.noise_by_axis),
               "Of the noise along x, y and z.")
        .newer("missing_load", &Identification::load_check)
        .key("length_outliers", &Identification::length_outliers)
        .key("boundary", &Identification::boundary_outliers,
             "Adjustable edges and supports that are not as designed; the worst first.")
        .key("boundary_not_released", &Identification::boundary_not_released, whole,
             "Number of further boundary outliers that were not corrected.");
}

Description<Identification> forces_object() {
    return Description<Identification>("forces", "Force measurements besides the survey.")
        .key("measurements", &Identification::force_measurements)
        .key("outliers", &Identification::force_outliers,
             "Measurements that contradict all others, and were left out.")
        .newer("bias", &Identification::force_bias,
               "Relative excess of all measurements over the other data, where they were left out "
               "for it; else null.")
        .newer("contradicted_taut", &Identification::contradicted_taut,
               "Edges marked as taut that the survey contradicts; then no marks are used.")
        .newer("contradicted_slack", &Identification::contradicted_slack,
               "Edges marked as slack that the survey contradicts; likewise.");
}

Description<Identification> survey_object() {
    return Description<Identification>("survey")
        .key("used", TAUT_VALUE(c.survey->surveyed.size()), Rule::count())
        .key("missing", TAUT_VALUE(c.survey->missing.size()), Rule::count())
        .newer("noise", TAUT_VALUE(noise_of(*c.survey)), size)
        .newer("noise_ratio", &Identification::noise_ratio, size,
               "Root of the variance factor: residuals over their expectation by the noise; 0: not "
               "computed.")
        .key("outliers", &Identification::outliers)
        .newer("outlier_threshold", &Identification::outlier_threshold, size)
        .key("rms_residual", rms_residual, size, "Of the targets that were not left out [m].")
        .key("max_residual",
             TAUT_VALUE(residuals_in_use(it, *c.survey).template lpNorm<Eigen::Infinity>()), size)
        .newer("residuals", TAUT_VALUE(residuals_of(*c.survey, it.predicted.form)))
        .newer("missing_nodes", TAUT_VALUE(c.survey->missing))
        .newer("unmatched", TAUT_VALUE(c.survey->unmatched))
        .newer("control",
               TAUT_VALUE(c.survey->frame ? c.survey->frame->residuals
                                          : std::vector<ControlResidual>()),
               "As in frame, for readers that do not know it.")
        .newer("warnings", TAUT_VALUE(c.survey->warnings), "Warnings on reading it.");
}

}  // namespace

Description<Identification> describe(const Identification* /*type*/) {
    auto result = document<Identification>("identification", "Result of taut identify.");
    result.key("method", &Identification::method)
        .newer("method_reason", &Identification::method_reason)
        .newer("status", &Identification::status, Rule::text())
        .newer("trust", &Identification::trust, "Verdict of the checks.")
        .newer("findings", TAUT_VALUE(it.trust.findings), "The worst first.")
        .newer("length_prior", &Identification::length_prior,
               R"(The most probable prior of the length deviations: "uniform:5mm".)")
        .newer("prior", &Identification::prior, "As given, and as estimated.")
        .newer("assumptions", &Identification::assumptions,
               "Uncertainties assumed besides lengths.")
        .newer("detectable", &Identification::detectable,
               "The smallest error of each kind, at a random place, that the checks find with a "
               "probability of 80 %; null: none.")
        .newer("noise", TAUT_VALUE(noise_of(*c.survey)), size,
               "Root mean square of the stated standard deviations [m].")
        .newer("net_fingerprint", TAUT_VALUE(c.net->fingerprint()))
        .key("edges", &Identification::edges)
        .key("form", TAUT_VALUE(columns_of(it.predicted.form)))
        .newer("frame", TAUT_VALUE(c.survey->frame),
               "Motion of the survey into the net's frame; null where it was given in that frame.")
        .object("survey", survey_object());
    return add_run(result)
        .key("net",
             [](const Identification&, const Context& c) -> const CableNet& { return *c.net; })
        .newer("frame_offset", &Identification::frame_offset,
               "Motion of the net's supports in the survey's frame; null where the frame was given "
               "as the net's.")
        .newer("turned", &Identification::turned, "Until the last of several surveys.")
        .newer("epochs", &Identification::epochs, "Of several surveys; else empty.")
        .newer_object("diagnostics", diagnostics_object(), "Numbers of the checks.")
        .key("cable_net", TAUT_VALUE(net_json(*c.net)), net_rule())
        .optional("tension",
                  TAUT_VALUE(it.tensions.size() > 0 ? numbers_json(it.tensions, 6) : ResultJson()),
                  Rule::list_of(Rule::number()),
                  "Of all edges, in the predicted form; negative in a compressed strut [N].")
        .newer("uncertain", &Identification::uncertain,
               "Estimates of the uncertain parameters; of an edge or a node where one is named.")
        .newer("stretches", &Identification::stretches,
               "Cables that slide, one length from clamp to clamp; empty where none does.")
        .newer_object("forces", forces_object())
        .newer("length_covariance", &Identification::length_covariance,
               "Posterior covariances between the lengths of the edges asked for; null: none.")
        .newer(
            "form_covariance", TAUT_VALUE(covariances_json(it.form_covariance)), covariances_rule(),
            "Posterior covariance of each node's place in form, as xx, xy, xz, yy, yz, zz; null: "
            "none [m2].")
        .newer("mean_tension", TAUT_VALUE(when(!it.drawn.tensions.empty(), it.drawn.mean_tension)),
               "Over all edges, of the posterior; null without samples [N].")
        .newer("draws", &Identification::draws,
               "Posterior samples, kept in the HDF5 file beside the result; null: none.")
        .newer("adjustable_edges", adjustable_tensions,
               "Tensions of the adjustable edges by posterior samples; empty without.")
        .newer("missing_places", TAUT_VALUE(it.drawn.missing),
               "Places of the nodes without survey by posterior samples; empty without.");
}

std::string identification_to_json(const CableNet& net, const Survey& survey,
                                   const Identification& identification, const RunRecord& run) {
    const Context context{.net = &net, .run = &run, .survey = &survey, .found = &identification};
    return to_text(json_of(identification, context));
}

}  // namespace taut
