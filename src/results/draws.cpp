// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/fnv1a.hpp"
#include "taut/results/draws_h5.hpp"

namespace taut {

std::string fingerprint_of(const PosteriorDraws& draws) {
    Fnv1a hash;
    for (const Eigen::MatrixXd* matrix :
         {&draws.length_deviations, &draws.adjustable_deviations, &draws.forms, &draws.tensions}) {
        hash.add_list(*matrix);
    }
    const ModelPerturbations& perturbations = draws.perturbations;
    for (const Eigen::MatrixXd* matrix : {&perturbations.stiffness, &perturbations.thermal,
                                          &perturbations.supports, &perturbations.loads}) {
        if (matrix->size() > 0) {  // else the hash is that of older files
            hash.add_list(*matrix);
        }
    }
    return hash.text();
}

std::filesystem::path draws_path(const std::filesystem::path& result) {
    return result.parent_path() / (result.stem().string() + "_draws.h5");
}

}  // namespace taut
