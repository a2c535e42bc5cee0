// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/draws_h5.hpp"

#include <stdexcept>

#include "files/hdf5_writer.hpp"

namespace taut {

std::string draws_bytes(const CableNet& net, const Identification& identification) {
    if (!identification.draws) {
        throw std::invalid_argument("the identification has no draws, expected some");
    }
    const PosteriorDraws& draws = *identification.draws;
    hdf5::Writer writer;
    writer.attribute("format", "taut-draws");
    writer.attribute("version", 1);
    writer.attribute("net_fingerprint", net.fingerprint());
    writer.attribute("law", identification.law.to_string());
    writer.attribute("seed", draws.seed);
    writer.attribute("how", draws.how);
    writer.attribute("doubt", draws.doubt);
    writer.integers("edge", net.interior_edges());
    writer.integers("node", net.free_nodes());
    writer.matrix("length_deviation", draws.length_deviations, "m");
    writer.matrix("form", draws.forms, "m");
    writer.matrix("tension", draws.tensions, "N");
    return writer.finish();
}

}  // namespace taut
