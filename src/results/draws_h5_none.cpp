// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/hdf5_none.hpp"
#include "taut/results/draws_h5.hpp"

namespace taut {

bool keeps_draws() {
    return false;
}

std::string draws_bytes(const CableNet& /*net*/, const Identification& /*identification*/) {
    hdf5::refuse_writing();
}

PosteriorDraws read_draws(const CableNet& /*net*/, const std::filesystem::path& path) {
    hdf5::refuse_reading(path);
}

}  // namespace taut
