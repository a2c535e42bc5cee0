// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "net/fingerprint.hpp"

#include <array>

#include "numerics/fnv1a.hpp"

namespace taut {

std::string compute_fingerprint(const CableNetData& data) {
    Fnv1a hash;
    hash.add_list(data.nodes);
    hash.add_list(data.supports);
    hash.add_list(data.edges);
    hash.add_list(data.axial_stiffness);
    hash.add_list(data.unstressed_lengths);
    hash.add_list(data.adjustable);
    hash.add_list(data.loads);
    if (!data.tension_law.empty()) {
        hash.add_list(data.tension_law);
        for (const TensionLaw& law : data.tension_laws) {
            hash.add_list(law.strain);
            hash.add_list(law.tension);
        }
    }
    if (data.mass.size() > 0) {
        hash.add_list(data.mass);
    }
    for (const ElasticSupport& support : data.elastic_supports) {
        hash.add_list(std::array{support.node});
        hash.add_list(support.stiffness);
        hash.add_list(support.place);
    }
    for (const SupportCoupling& coupling : data.support_couplings) {
        hash.add_list(std::array{coupling.first, coupling.second});
        hash.add_list(coupling.stiffness);
    }
    if (!data.kind.empty()) {
        hash.add_list(data.kind);
    }
    if (data.sag_weight.size() > 0) {
        hash.add_list(data.sag_weight);
    }
    for (const CableRun& run : data.runs) {
        if (!run.slides_at.empty()) {
            hash.add_list(run.edges);
            hash.add_list(run.slides_at);
            hash.add_list(std::array{run.friction.value_or(-1.0)});
            if (!run.ratios.empty()) {
                hash.add_list(run.ratios);
            }
        }
    }
    return hash.text();
}

}  // namespace taut
