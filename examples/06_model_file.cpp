// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// Train once, keep the model, and identify from it later, in another program say.
#include <filesystem>
#include <iostream>

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/model_h5.hpp"
#include "taut/sampling/sampler.hpp"

int main() {
    const std::filesystem::path file = "06_model_file.h5";
    const taut::CableNet net = taut::hypar(5, 5);
    const taut::LengthPrior prior{.kind = taut::LengthPrior::Kind::uniform, .scale = 0.003};  // m
    const taut::Sampler sampler(net, prior, 1);
    taut::DataSet data = sampler.no_samples();
    sampler.extend_to(data, 201);
    // The fingerprint of the net is stored: a model is refused for another net.
    taut::write_model(file, taut::train_model(net, data, data.converged_in(0, 200)), {.net = net});

    const taut::StoredModel stored = taut::read_model(file);
    taut::Survey survey;
    survey.form =
        taut::with_free_coordinates(net, data.nominal_form + data.form_deviations.col(200));
    survey.surveyed = net.free_nodes();
    taut::IdentifyOptions options;
    options.model = &stored.model;  // not copied: it must outlive the call
    const taut::Identification found = taut::identify(net, survey, options);
    std::cout << stored.model.training_count() << " samples; " << found.edges.size()
              << " lengths: " << to_string(found.status) << '\n';
    std::filesystem::remove(file);
    return found.status == taut::IdentificationStatus::converged ? 0 : 1;
}
