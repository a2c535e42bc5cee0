// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/result_values.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "files/message.hpp"
#include "io/net_json_value.hpp"

namespace taut {

JsonValue member(const JsonValue& parent, const std::string& key) {
    return parent.require(key, "what the schema says");
}

std::optional<JsonValue> find_unless_null(const JsonValue& parent, const char* key) {
    auto value = parent.find(key);
    return value && !value->json().is_null() ? value : std::nullopt;
}

std::optional<double> optional_number(const JsonValue& parent, const char* key) {
    const auto value = find_unless_null(parent, key);
    return value ? std::optional(value->number()) : std::nullopt;
}

std::vector<JsonValue> entries(const JsonValue& parent, const char* key) {
    std::vector<JsonValue> all;
    if (const auto list = parent.find(key)) {
        for (size_t i = 0; i < list->json().size(); ++i) {
            all.push_back(list->at(i));
        }
    }
    return all;
}

Eigen::VectorXd require_list(const JsonValue& parent, const std::string& key, Eigen::Index size,
                             const std::string& what) {
    const JsonValue list = member(parent, key);
    list.require_array(size, fmt::format("{}: {}", what, size));
    Eigen::VectorXd numbers(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        numbers(i) = list.at(i).number();
    }
    return numbers;
}

Points require_form(const JsonValue& parent, const std::string& key, const CableNet& net) {
    const JsonValue list = member(parent, key);
    const auto count = static_cast<size_t>(net.node_count());
    list.require_array(count, fmt::format("a point [x, y, z] for each node: {}", count));
    Points points(3, net.node_count());
    for (size_t i = 0; i < count; ++i) {
        const JsonValue point = list.at(i);
        for (size_t k = 0; k < 3; ++k) {
            points(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) =
                point.at(k).number();
        }
    }
    return points;
}

void check_covariances(const JsonValue& parent, const char* key, const CableNet& net) {
    const auto list = find_unless_null(parent, key);
    if (!list) {
        return;
    }
    constexpr double rounding = 1e-6;
    constexpr std::array<size_t, 3> diagonal{0, 3, 5};
    const auto count = static_cast<size_t>(net.node_count());
    list->require_array(count, fmt::format("a covariance for each node: {}", count));
    for (size_t i = 0; i < count; ++i) {
        std::array<double, 3> stds{};
        for (size_t k = 0; k < 3; ++k) {
            const JsonValue variance = list->at(i).at(diagonal[k]);
            if (variance.number() < 0.0) {
                variance.fail(
                    fmt::format("is {}, expected a variance of at least 0", variance.number()));
            }
            stds[k] = std::sqrt(variance.number());
        }
        for (const auto& [at, j, k] :
             {std::tuple<size_t, size_t, size_t>{1, 0, 1}, {2, 0, 2}, {4, 1, 2}}) {
            const JsonValue covariance = list->at(i).at(at);
            const double most = stds[j] * stds[k] * (1.0 + rounding);
            if (std::abs(covariance.number()) > most) {
                covariance.fail(fmt::format(
                    "is {}, expected at most {:.3g} beside variances of {:.3g} and {:.3g}",
                    covariance.number(), most, stds[j] * stds[j], stds[k] * stds[k]));
            }
        }
    }
}

int read_node(const JsonValue& value, const CableNet& net) {
    const int node = value.integer();
    if (node < 0 || node >= net.node_count()) {
        value.fail(fmt::format("is {}, expected a node from 0 to {}", node, net.node_count() - 1));
    }
    return node;
}

int read_edge_index(const JsonValue& value, const CableNet& net) {
    const int edge = value.integer();
    if (edge < 0 || edge >= net.edge_count()) {
        value.fail(fmt::format("is {}, expected an edge of the net", edge));
    }
    return edge;
}

CableNet require_net(const JsonValue& root) {
    CableNet net = read_net_value(member(root, "cable_net"));
    const JsonValue counts = member(root, "net");
    for (const auto& fingerprint : {counts.find("fingerprint"), root.find("net_fingerprint")}) {
        if (fingerprint && fingerprint->text() != net.fingerprint()) {
            fingerprint->fail(fmt::format("is {}, expected {}, that of /cable_net",
                                          quote(fingerprint->text()), net.fingerprint()));
        }
    }
    for (const auto& [key, count] :
         {std::pair("free_nodes", net.free_node_count()),
          std::pair("supports", static_cast<int>(net.supports().size())),
          std::pair("interior_edges", net.interior_edge_count()),
          std::pair("adjustable_edges", static_cast<int>(net.adjustable_edges().size()))}) {
        require_equal(counts, key, count, "as /cable_net has");
    }
    return net;
}

void require_equal(const JsonValue& parent, const char* key, int expected, std::string_view why) {
    if (const auto value = parent.find(key); value && value->integer() != expected) {
        value->fail(fmt::format("is {}, expected {}, {}", value->integer(), expected, why));
    }
}

void require_at_most(const JsonValue& parent, const char* key, const char* whole) {
    const auto part = optional_number(parent, key);
    const auto all = optional_number(parent, whole);
    if (part && all && *part > *all) {
        member(parent, key)
            .fail(fmt::format("is {}, expected at most {}, which is {}", *part, whole, *all));
    }
}

void require_tension_list(const JsonValue& parent, const char* key, const CableNet& net) {
    const Eigen::VectorXd tensions =
        require_list(parent, key, net.edge_count(), "a number for each edge");
    for (int e = 0; e < tensions.size(); ++e) {
        if (!net.is_strut(e) && tensions(e) < 0.0) {
            member(parent, key)
                .at(static_cast<size_t>(e))
                .fail(fmt::format("is {}, expected a number of at least 0", tensions(e)));
        }
    }
}

void require_tensions(const JsonValue& parent, std::initializer_list<const char*> keys,
                      const CableNet& net, int edge) {
    if (edge < 0 ? net.has_struts() : net.is_strut(edge)) {
        return;
    }
    for (const char* const key : keys) {
        if (const auto tension = optional_number(parent, key); tension && *tension < 0.0) {
            member(parent, key)
                .fail(fmt::format("is {}, expected a number of at least 0, or null", *tension));
        }
    }
}

}  // namespace taut
