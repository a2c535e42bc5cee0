// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/estimation/edge_status.hpp"

namespace taut {

std::string_view to_string(EdgeStatus status) {
    switch (status) {
        case EdgeStatus::identified:
            return "identified";
        case EdgeStatus::slack:
            return "slack";
        case EdgeStatus::unobserved:
            return "unobserved";
    }
    return "unknown";
}

}  // namespace taut
