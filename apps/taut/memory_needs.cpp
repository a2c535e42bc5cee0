// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "memory_needs.hpp"

#include "taut/gp/fit.hpp"

namespace taut::app {
namespace {

constexpr double number = sizeof(double);

double data_set_size(const CableNet& net, double samples) {
    constexpr double status_and_slack_edges = 5.0;
    return samples * (number * (3.0 * net.free_node_count() + net.interior_edge_count()) +
                      status_and_slack_edges);
}

}  // namespace

double sampling_memory(const CableNet& net, double samples) {
    return 2.0 * data_set_size(net, samples);
}

double training_memory(const CableNet& net, double samples) {
    const gp::FitSettings settings;
    // The forms of the samples, once more as scaled inputs.
    const double inputs = 2.0 * samples * 3.0 * net.free_node_count();
    double at_work = 0.0;
    if (samples <= settings.most_decomposed) {
        // The decompositions, nearly all of which are kept as the best for some edge, and as much
        // again for the bytes of the model's file, or as work space of the next ones.
        at_work = 2.0 * settings.max_spectra * samples * samples;
    } else {
        // The directions of up to three lambdas, and as much again as work space.
        at_work = 6.0 * samples * settings.rank;
    }
    // Measured, for 300 to 1500 samples on one and two threads: 25 to 43 MiB.
    constexpr double heaps_and_buffers = 48.0 * 1024.0 * 1024.0;
    return data_set_size(net, samples) + number * (inputs + at_work) + heaps_and_buffers;
}

}  // namespace taut::app
