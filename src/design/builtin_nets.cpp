// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/design/builtin_nets.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace taut {
namespace {

/// The whole of the text as a number, or -1.
int whole_number(std::string_view text) {
    int value = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : -1;
}

}  // namespace

CableNet builtin_net(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, CableNet (*)()>, 6> named{
        {{"hilo-quarter", hilo_quarter},
         {"steel-roof", steel_roof},
         {"cable-dome", cable_dome},
         {"spoke-wheel", spoke_wheel},
         {"tensegrity-simplex", tensegrity_simplex},
         {"sliding-ridge", sliding_ridge}}};
    for (const auto& [of_net, make] : named) {
        if (name == of_net) {
            return make();
        }
    }
    constexpr std::string_view prefix = "hypar:";
    if (name.starts_with(prefix)) {
        const std::string_view size = name.substr(prefix.size());
        if (const size_t cross = size.find('x'); cross != std::string_view::npos) {
            const int rows = whole_number(size.substr(0, cross));
            const int columns = whole_number(size.substr(cross + 1));
            if (rows >= 0 && columns >= 0) {
                return hypar(rows, columns);
            }
        }
    }
    throw std::invalid_argument(
        fmt::format("there is no built-in net '{}': expected hilo-quarter, steel-roof, cable-dome, "
                    "spoke-wheel, tensegrity-simplex, sliding-ridge, or hypar:RxC with rows and "
                    "columns of free nodes, as in hypar:20x30",
                    name));
}

}  // namespace taut
