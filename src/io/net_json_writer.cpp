// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "files/json_parse.hpp"
#include "files/message.hpp"
#include "io/net_keys.hpp"
#include "taut/files/input_error.hpp"
#include "taut/io/net_json.hpp"

namespace taut {
namespace {

using nlohmann::json;

/// The shortest text that reads back to the same double.
std::string number_text(double value) {
    // "-0" would read back as the integer 0.
    return value == 0.0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}

/// Text as JSON, in quotes. @throws std::invalid_argument where it is not UTF-8
std::string text_text(const std::string& text) {
    try {
        return json(text).dump();
    } catch (const json::exception&) {
        throw std::invalid_argument(
            fmt::format("the name {} is not UTF-8 and cannot be written as JSON", quote(text)));
    }
}

/// [a, b, ...] on lines of some 100 characters, "[]" where there is none.
template <typename List, typename ToText>
std::string wrapped(const List& list, const ToText& to_text) {
    constexpr size_t width = 100;
    std::string result = "[";
    std::string line;
    for (const auto& value : list) {
        std::string entry = to_text(value);
        if (!line.empty() && line.size() + entry.size() > width) {
            result += "\n   " + line + ",";
            line.clear();
        }
        line += (line.empty() ? " " : ", ") + entry;
    }
    return result + (line.empty() ? "]" : "\n   " + line + "\n  ]");
}

/// An array with an entry a line.
template <typename ToText>
std::string one_a_line(Eigen::Index count, const ToText& to_text) {
    std::string result = "[";
    for (Eigen::Index i = 0; i < count; ++i) {
        result += (i == 0 ? "\n    " : ",\n    ") + to_text(i);
    }
    return result + (count == 0 ? "]" : "\n  ]");
}

std::string points_text(const Points& points) {
    return one_a_line(points.cols(), [&points](Eigen::Index i) {
        return fmt::format("[{}, {}, {}]", number_text(points(0, i)), number_text(points(1, i)),
                           number_text(points(2, i)));
    });
}

std::string edges_text(const std::vector<Edge>& edges) {
    return one_a_line(static_cast<Eigen::Index>(edges.size()), [&edges](Eigen::Index e) {
        const auto [s, t] = edges[e];
        return fmt::format("[{}, {}]", s, t);
    });
}

std::string indices_text(const std::vector<int>& indices) {
    return wrapped(indices, [](int index) { return std::to_string(index); });
}

/// Whether loads() differs from what a net without loads has, to the last bit.
bool has_loads(const Points& loads) {
    return (loads.array() != 0.0 ||
            loads.array().unaryExpr([](double x) { return std::signbit(x); }))
        .any();
}

/// One number where all are alike.
std::string one_or_all(const Eigen::VectorXd& numbers) {
    return (numbers.array() == numbers(0)).all() ? number_text(numbers(0))
                                                 : wrapped(numbers, number_text);
}

std::string groups_text(const std::map<std::string, std::vector<int>>& groups) {
    std::string result = "{";
    for (const auto& [name, edges] : groups) {
        result += fmt::format("{}\n    {}: {}", result.size() == 1 ? "" : ",", text_text(name),
                              indices_text(edges));
    }
    return result + "\n  }";
}

std::string runs_text(const std::vector<CableRun>& runs) {
    return one_a_line(static_cast<Eigen::Index>(runs.size()), [&runs](Eigen::Index k) {
        const auto& [name, edges, slides_at, friction, ratios] = runs[static_cast<size_t>(k)];
        std::string sliding =
            slides_at.empty() ? "" : fmt::format(", \"slides_at\": {}", indices_text(slides_at));
        if (friction) {
            sliding += fmt::format(", \"friction\": {}", number_text(*friction));
        }
        if (!ratios.empty()) {
            std::vector<std::string> numbers(ratios.size());
            std::ranges::transform(ratios, numbers.begin(), number_text);
            sliding += fmt::format(", \"ratios\": [{}]", fmt::join(numbers, ", "));
        }
        return fmt::format("{{{}\"edges\": {}{}}}",
                           name.empty() ? "" : fmt::format("\"name\": {}, ", text_text(name)),
                           indices_text(edges), sliding);
    });
}

std::string numbers_text(const Eigen::VectorXd& numbers) {
    std::string result;
    for (const double number : numbers) {
        result += (result.empty() ? "" : ", ") + number_text(number);
    }
    return "[" + result + "]";
}

std::string tension_laws_text(const std::vector<TensionLaw>& laws) {
    return one_a_line(static_cast<Eigen::Index>(laws.size()), [&laws](Eigen::Index i) {
        return fmt::format(R"({{"name": {}, "strain": {}, "tension": {}}})",
                           text_text(laws[i].name), numbers_text(laws[i].strain),
                           numbers_text(laws[i].tension));
    });
}

/// One a support; null for those of the rigid frame, which come first.
template <typename ToText>
std::string of_supports_text(const CableNetData& data, const ToText& to_text) {
    const auto rigid = std::ssize(data.supports);
    return one_a_line(rigid + std::ssize(data.elastic_supports), [&](Eigen::Index i) {
        return i < rigid ? std::string("null")
                         : to_text(data.elastic_supports[static_cast<size_t>(i - rigid)]);
    });
}

std::string matrix_text(const Eigen::Matrix3d& matrix) {
    return fmt::format("[{}, {}, {}]", numbers_text(matrix.row(0).transpose()),
                       numbers_text(matrix.row(1).transpose()),
                       numbers_text(matrix.row(2).transpose()));
}

std::string stiffness_text(const Eigen::Matrix3d& stiffness) {
    return stiffness.isDiagonal(0.0) ? numbers_text(stiffness.diagonal()) : matrix_text(stiffness);
}

json parse_unknown_keys(const std::string& text) {
    const json keys = [&text] {
        try {
            return parse_json(text, "unknown_keys");
        } catch (const InputError& error) {
            throw std::invalid_argument(error.what());
        }
    }();
    if (!keys.is_object()) {
        throw std::invalid_argument("unknown_keys: is no JSON object");
    }
    for (const auto& [key, value] : keys.items()) {
        if (is_net_key(key)) {
            throw std::invalid_argument(
                fmt::format("unknown_keys: holds {}, which is a key of the format", quote(key)));
        }
    }
    return keys;
}

}  // namespace

std::string net_to_json(const CableNet& net, const std::string& unknown_keys) {
    const CableNetData& data = net.data();
    const json unknown = parse_unknown_keys(unknown_keys);
    std::string result = "{";
    const auto add = [&result](const std::string& key, const std::string& value) {
        result += fmt::format("{}\n  {}: {}", result.size() == 1 ? "" : ",", text_text(key), value);
    };
    add("format", text_text(std::string(net_format)));
    add("version", std::to_string(net_version));
    add("name", text_text(data.name));
    add("nodes", points_text(data.nodes));
    add("supports", indices_text(net.all_supports()));
    add("edges", edges_text(data.edges));
    add("axial_stiffness", one_or_all(data.axial_stiffness));
    add("unstressed_lengths", wrapped(data.unstressed_lengths, number_text));
    add("adjustable", indices_text(data.adjustable));
    if (has_loads(data.loads)) {
        add("loads", points_text(data.loads));
    }
    for (const auto& [key, ids] :
         {std::pair{"node_ids", &data.node_ids}, std::pair{"edge_ids", &data.edge_ids}}) {
        if (!ids->empty()) {
            add(key, wrapped(*ids, text_text));
        }
    }
    if (!data.tension_laws.empty()) {
        add("tension_laws", tension_laws_text(data.tension_laws));
    }
    if (!net.is_linear()) {
        add("tension_law", wrapped(data.tension_law, [](int law) {
                return law < 0 ? std::string("null") : std::to_string(law);
            }));
    }
    if (!data.groups.empty()) {
        add("groups", groups_text(data.groups));
    }
    for (const auto& [key, rates] :
         {std::pair{"mass", &data.mass}, std::pair{"expansion", &data.expansion},
          std::pair{"breaking_load", &data.breaking_load},
          std::pair{"bending_stiffness", &data.bending_stiffness},
          std::pair{"sag_weight", &data.sag_weight}}) {
        if (rates->size() > 0) {
            add(key, one_or_all(*rates));
        }
    }
    if (const auto& ends = data.cable_ends; !ends.empty()) {
        const auto word = [](CableEnds one) { return text_text(to_string(one)); };
        const bool are_alike = std::ranges::count(ends, ends[0]) == std::ssize(ends);
        add("cable_ends", are_alike ? word(ends[0]) : wrapped(ends, word));
    }
    if (net.has_struts()) {
        add("kind", wrapped(data.kind, [](EdgeKind kind) {
                return std::string(kind == EdgeKind::strut ? R"("strut")" : R"("cable")");
            }));
    }
    if (data.buckling_load.size() > 0) {
        add("buckling_load", wrapped(data.buckling_load, [](double load) {
                return std::isfinite(load) ? number_text(load) : std::string("null");
            }));
    }
    if (!data.runs.empty()) {
        add("runs", runs_text(data.runs));
    }
    if (!data.thread.empty()) {
        add("thread", wrapped(data.thread, [](Thread thread) {
                return std::string(thread == Thread::right ? R"("right")" : R"("left")");
            }));
    }
    if (!data.elastic_supports.empty()) {
        add("support_stiffness", of_supports_text(data, [](const ElasticSupport& support) {
                return stiffness_text(support.stiffness);
            }));
        add("support_place", of_supports_text(data, [](const ElasticSupport& support) {
                return numbers_text(support.place);
            }));
    }
    if (!data.support_couplings.empty()) {
        const auto count = static_cast<Eigen::Index>(data.support_couplings.size());
        add("support_couplings", one_a_line(count, [&data](Eigen::Index i) {
                const auto& [first, second, stiffness] =
                    data.support_couplings[static_cast<size_t>(i)];
                return fmt::format("[{}, {}, {}]", data.elastic_supports[first].node,
                                   data.elastic_supports[second].node, matrix_text(stiffness));
            }));
    }
    for (const auto& [key, value] : unknown.items()) {
        add(key, value.dump());
    }
    return result + "\n}\n";
}

}  // namespace taut
