// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/form_csv.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "files/csv_field.hpp"

namespace taut {
std::string form_to_csv(const CableNet& net, const Points& form) {
    if (form.cols() != net.node_count()) {
        throw std::invalid_argument(fmt::format("a form of {} nodes, expected {} as in the net",
                                                form.cols(), net.node_count()));
    }
    if (!form.allFinite()) {
        throw std::invalid_argument("the form holds a coordinate that is not finite");
    }
    std::string result = "id,x,y,z\n";
    for (int node = 0; node < net.node_count(); ++node) {
        result += fmt::format("{},{},{},{}\n", csv_field(net.node_id(node)), form(0, node),
                              form(1, node), form(2, node));
    }
    return result;
}

}  // namespace taut
