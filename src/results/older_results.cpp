// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/older_results.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace taut {
namespace {

using nlohmann::json;

/// A renamed key or text of the objects at a path of new keys; "*" is each entry of an array.
struct Renamed {
    std::string_view path, before, now;
};

/// Outer keys come before the keys inside them.
constexpr Renamed renamed_keys[] = {
    // taut-identification
    {"", "doubt", "diagnostics"},
    {"", "unknowns", "uncertain"},
    {"uncertain/*", "told", "given"},
    {"prior/nodes/*", "law", "prior"},
    {"forces", "readings", "measurements"},
    {"forces/outliers/*", "read", "measured"},
    {"diagnostics", "law", "prior"},
    {"diagnostics", "lengths_beyond_law", "length_outliers"},
    {"diagnostics", "boundary_beyond", "boundary_not_released"},
    {"diagnostics/prior", "beyond", "outliers"},
    {"diagnostics/boundary/*", "rival", "confounded_with"},
    {"epochs/*/boundary/*", "rival", "confounded_with"},
    {"epochs/*", "untold_play", "excess_actuator_std"},
    {"draws", "doubt", "reason"},
    // taut-plan
    {"form", "unavoidable", "unconstrained"},
    {"form", "normal_unknown", "normal_std"},
    {"turns/*", "moment", "step"},
    {"turns/*", "sense", "action"},
    {"order/worst", "moment", "step"},
    {"", "further", "suggested_adjustable"},
    {"", "survey_first", "suggested_targets"},
    {"suggested_targets/targets/*", "normal_unknown", "normal_std"},
    {"", "no_draws_since", "no_draws_because"},
    // taut-comparison
    {"rows/*", "best_possible_mse", "cramer_rao_mse"},
    {"rows/*", "best_possible_mse_of_taut_edges", "cramer_rao_mse_of_taut_edges"},
    {"model_error_rows/*", "best_possible_mse", "cramer_rao_mse"},
    {"model_error_rows/*", "best_possible_mse_of_taut_edges", "cramer_rao_mse_of_taut_edges"},
    {"epoch_rows/*", "best_possible_mse", "cramer_rao_mse"},
    {"epoch_rows/*", "best_possible_mse_of_taut_edges", "cramer_rao_mse_of_taut_edges"},
    // taut-control
    {"settings", "law", "prior"},
};

constexpr Renamed renamed_texts[] = {
    {"edges/*/status", "weakly determined", "weakly_determined"},
    {"edges/*/status", "not determined", "not_determined"},
    {"model_error_rows/*/model_errors", "untold", "not given"},
    {"model_error_rows/*/model_errors", "told", "given"},
};

/// Calls change(value) for each value at a path.
template <typename Change>
void at_each(json& value, std::string_view path, const Change& change) {
    if (path.empty()) {
        change(value);
        return;
    }
    const std::string_view key = path.substr(0, path.find('/'));
    const std::string_view rest = key.size() < path.size() ? path.substr(key.size() + 1) : "";
    if (key == "*" && value.is_array()) {
        for (json& entry : value) {
            at_each(entry, rest, change);
        }
    } else if (value.is_object()) {
        if (const auto member = value.find(std::string(key)); member != value.end()) {
            at_each(*member, rest, change);
        }
    }
}

void rename(json& root, const Renamed& key) {
    at_each(root, key.path, [&](json& parent) {
        if (!parent.is_object() || parent.contains(std::string(key.now))) {
            return;
        }
        if (const auto found = parent.find(std::string(key.before)); found != parent.end()) {
            json value = std::move(*found);
            parent.erase(found);
            parent[std::string(key.now)] = std::move(value);
        }
    });
}

}  // namespace

json with_new_keys(json root) {
    rename(root, {"", "law", root["format"] == "taut-identification" ? "length_prior" : "prior"});
    for (const Renamed& key : renamed_keys) {
        rename(root, key);
    }
    for (const Renamed& renamed : renamed_texts) {
        at_each(root, renamed.path, [&renamed](json& text) {
            if (text == renamed.before) {
                text = renamed.now;
            }
        });
    }
    root["version"] = 2;
    return root;
}

}  // namespace taut
