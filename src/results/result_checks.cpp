// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/result_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "files/message.hpp"
#include "results/result_values.hpp"

namespace taut {
namespace {

using nlohmann::json;

/// Walks a document without making a pointer to each part, which is slow for large results.
class Names {
public:
    Names(const JsonValue& root, const CableNet& net) : m_root(&root), m_net(&net) {}

    void check(const json& value, bool is_root) {
        if (value.is_object()) {
            check_object(value);
        }
        size_t index = 0;
        for (auto member = value.begin(); member != value.end(); ++member, ++index) {
            if (!member->is_structured() || (is_root && member.key() == "cable_net")) {
                continue;
            }
            m_place.push_back(value.is_object() ? member.key() : std::to_string(index));
            check(*member, false);
            m_place.pop_back();
        }
    }

private:
    void check_object(const json& object) {
        for (const bool is_edge : {true, false}) {
            const auto named = object.find(is_edge ? "edge" : "node");
            if (named == object.end() || !named->is_number_integer()) {
                continue;
            }
            const JsonValue value = place_of(object, is_edge ? "edge" : "node");
            const int index = is_edge ? read_edge_index(value, *m_net) : read_node(value, *m_net);
            for (const char* key : {"id", "edge_id"}) {
                const std::string id = is_edge ? m_net->edge_id(index) : m_net->node_id(index);
                const auto named_id = object.find(key);
                if (named_id != object.end() && *named_id != id) {
                    const JsonValue at = place_of(object, key);
                    at.fail(fmt::format("is {}, expected {}, the id of {} {}", quote(at.text()),
                                        quote(id), is_edge ? "edge" : "node", index));
                }
            }
            const auto ends = object.find("nodes");
            if (is_edge && ends != object.end() && *ends != json(m_net->edges()[index])) {
                place_of(object, "nodes")
                    .fail(fmt::format("is {}, expected {}, the ends of edge {}", ends->dump(),
                                      json(m_net->edges()[index]).dump(), index));
            }
        }
    }

    [[nodiscard]] JsonValue place_of(const json& object, const char* key) const {
        return {object.at(key), m_root->file_name(), (m_place / key).to_string()};
    }

    const JsonValue* m_root;
    const CableNet* m_net;
    json::json_pointer m_place;  ///< of the current object
};

}  // namespace

void check_names(const JsonValue& root, const CableNet& net) {
    Names(root, net).check(root.json(), true);
}

void check_supports(const JsonValue& form, const Points& points, const CableNet& net,
                    const Points& places, const std::string& where) {
    // Forms may be rounded to nine digits.
    constexpr double rounding = 1e-8;
    constexpr double smallest = 1e-6;  // m
    for (const int node : net.supports()) {
        const Eigen::Vector3d expected = places.col(node);
        const double distance = (points.col(node) - expected).norm();
        if (distance > smallest + rounding * expected.lpNorm<Eigen::Infinity>()) {
            form.at(static_cast<size_t>(node))
                .fail(fmt::format("is {:.4g} m from [{}, {}, {}], expected the support {} at its "
                                  "place in {}",
                                  distance, expected.x(), expected.y(), expected.z(),
                                  net.node_id(node), where));
        }
    }
}

void check_std(const JsonValue& value, const IdentifiedEdge& edge, double farthest) {
    // At least 95 % lie within the interval, as the mean does. The rest is at most as far away as
    // the prior allows.
    const double width = edge.upper - edge.lower;
    const double largest = std::sqrt(width * width + 0.05 * farthest * farthest);
    if (edge.std_dev > largest) {
        member(value, "std")
            .fail(fmt::format("is {}, expected at most {:.4g}: its interval is {} to {}",
                              edge.std_dev, largest, edge.lower, edge.upper));
    }
}

}  // namespace taut
