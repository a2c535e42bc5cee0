// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/compas_structure.hpp"

#include <fmt/core.h>

#include <vector>

#include "files/message.hpp"

namespace taut {
namespace {

bool is_structure(const nlohmann::json& value) {
    return value.is_object() && (value.contains("vertex") || value.contains("node")) &&
           (value.contains("face") || value.contains("edge"));
}

void collect(const JsonValue& value, const std::string& key, std::vector<CompasStructure>& found) {
    const nlohmann::json& content = value.json();
    if (is_structure(content)) {
        found.push_back({.data = value, .key = key, .dtype = ""});
        return;
    }
    const std::string prefix = key.empty() ? "" : key + "/";
    if (content.is_array()) {
        for (size_t i = 0; i < content.size(); ++i) {
            if (content[i].is_structured()) {
                collect(value.at(i), prefix + std::to_string(i), found);
            }
        }
        return;
    }
    const auto dtype = value.find("dtype");
    const auto data = value.find("data");
    if (dtype && data && is_structure(data->json())) {
        found.push_back({.data = *data, .key = key, .dtype = dtype->text()});
        return;
    }
    for (const auto& [name, member] : content.items()) {
        if (member.is_structured()) {
            collect(*value.find(name), prefix + name, found);
        }
    }
}

std::string list_keys(const std::vector<CompasStructure>& structures) {
    constexpr size_t most = 5;
    std::string keys;
    for (size_t i = 0; i < structures.size() && i < most; ++i) {
        keys += (i == 0 ? "" : ", ") + quote(structures[i].key);
    }
    return structures.size() > most ? keys + ", ..." : keys;
}

bool has_key(const CompasStructure& structure, const std::string& select) {
    return structure.key == select || structure.key.ends_with("/" + select);
}

}  // namespace

CompasStructure find_compas_structure(const JsonValue& root, const std::string& select) {
    if (!root.json().is_structured()) {
        root.require_object("an object that holds a mesh or a network");
    }
    std::vector<CompasStructure> all;
    collect(root, "", all);
    if (all.empty()) {
        root.fail(R"(holds no mesh or network: expected an object with "vertex" and "face", or )"
                  R"("node" and "edge")");
    }
    if (select.empty()) {
        if (all.size() > 1) {
            root.fail(fmt::format("holds {} meshes or networks ({}): select one of them",
                                  all.size(), list_keys(all)));
        }
        return all.front();
    }
    std::vector<CompasStructure> selected;
    for (const CompasStructure& structure : all) {
        if (has_key(structure, select)) {
            selected.push_back(structure);
        }
    }
    if (selected.size() != 1) {
        root.fail(fmt::format("holds {} meshes or networks named {}, expected one of {}",
                              selected.empty() ? "no" : "several", quote(select), list_keys(all)));
    }
    return selected.front();
}

}  // namespace taut
