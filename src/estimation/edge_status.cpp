// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/estimation/edge_status.hpp"

namespace taut {

std::string_view to_string(EdgeStatus status) {
    switch (status) {
        case EdgeStatus::determined:
            return "determined";
        case EdgeStatus::weakly_determined:
            return "weakly_determined";
        case EdgeStatus::not_determined:
            return "not_determined";
        case EdgeStatus::slack:
            return "slack";
    }
    return "unknown";
}

EdgeStatus status_of(double prior_std, double std_dev) {
    if (std_dev < determined_ratio * prior_std) {
        return EdgeStatus::determined;
    }
    return std_dev < not_determined_ratio * prior_std ? EdgeStatus::weakly_determined
                                                      : EdgeStatus::not_determined;
}

}  // namespace taut
