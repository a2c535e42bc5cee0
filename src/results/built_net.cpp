// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/built_net.hpp"

#include <fmt/core.h>

#include "adjustment/built_net_parts.hpp"
#include "files/message.hpp"
#include "taut/files/input_error.hpp"
#include "taut/results/draws_h5.hpp"
#include "taut/results/result_file.hpp"

namespace taut {
IdentifiedNet read_identified_net(const CableNet& net, const std::filesystem::path& result_path) {
    const ResultFile file = read_result(result_path);
    const auto* result = std::get_if<IdentificationResult>(&file.content);
    if (result == nullptr) {
        throw InputError(result_path.string(), "/format",
                         "is another kind of result, expected \"taut-identification\"");
    }
    if (result->net.fingerprint() != net.fingerprint()) {
        throw InputError(result_path.string(), "/net/fingerprint",
                         fmt::format("is {}, expected {}: it is of another net",
                                     result->net.fingerprint(), net.fingerprint()));
    }
    try {
        const CableNet turned = turned_net(net, result->turned);
        IdentifiedNet identified{
            .built = net_as_identified(turned, result->edges, result->uncertain,
                                       result->boundary_outliers),
            .trust = result->trust};
        identified.built.failed_because = failure_of(result->trust);
        const std::filesystem::path draws = draws_path(result_path);
        if (result->draws == 0) {
            identified.built.no_draws_because = "the result was made without posterior samples";
        } else if (std::filesystem::exists(draws)) {
            const PosteriorDraws drawn = read_draws(net, draws);
            if (drawn.count() != result->draws ||
                (!result->draws_fingerprint.empty() &&
                 fingerprint_of(drawn) != result->draws_fingerprint)) {
                throw InputError(
                    draws.string(), "",
                    fmt::format("holds posterior samples of another result than {}: identify again",
                                quote(result_path.string())));
            }
            add_draws(identified.built, turned, drawn, result->uncertain);
        } else {
            identified.built.no_draws_because =
                fmt::format("there is no file {} beside the result", draws.string());
        }
        return identified;
    } catch (const InputError&) {
        throw;
    } catch (const std::invalid_argument& error) {
        throw InputError(result_path.string(), "",
                         fmt::format("describes no valid net: {}", error.what()));
    }
}

}  // namespace taut
