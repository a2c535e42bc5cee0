// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "files/json_matrix.hpp"
#include "files/json_parse.hpp"
#include "files/json_value.hpp"
#include "files/message.hpp"
#include "io/net_json_value.hpp"
#include "io/net_keys.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/io/net_json.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/plausibility.hpp"

namespace taut {
namespace {

void check_format(const JsonValue& root) {
    root.require_object(fmt::format(R"(an object with "format": "{}")", net_format));
    const std::string expected = fmt::format(R"("{}")", net_format);
    const JsonValue format = root.require("format", expected);
    if (format.text() != net_format) {
        format.fail(fmt::format("is {}, expected {}", quote(format.text()), expected));
    }
    const JsonValue version = root.require("version", std::to_string(net_version));
    if (const int found = version.integer(); found != net_version) {
        version.fail(fmt::format("is {}, expected {}, the only one that this taut knows", found,
                                 net_version));
    }
}

Points read_points(const JsonValue& list) {
    Points points(3, static_cast<Eigen::Index>(list.array_size("an array of [x, y, z]")));
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const JsonValue point = list.at(i);
        point.require_array(3, "an array of three numbers [x, y, z]");
        for (Eigen::Index k = 0; k < 3; ++k) {
            points(k, i) = point.at(k).number();
        }
    }
    return points;
}

std::vector<Edge> read_edges(const JsonValue& list) {
    std::vector<Edge> edges(list.array_size("an array of [s, t]"));
    for (size_t e = 0; e < edges.size(); ++e) {
        const JsonValue edge = list.at(e);
        edge.require_array(2, "an array of two nodes [s, t]");
        edges[e] = {edge.at(0).integer(), edge.at(1).integer()};
    }
    return edges;
}

Eigen::VectorXd read_numbers(const JsonValue& list) {
    Eigen::VectorXd numbers(static_cast<Eigen::Index>(list.array_size("an array of numbers")));
    for (Eigen::Index i = 0; i < numbers.size(); ++i) {
        numbers(i) = list.at(i).number();
    }
    return numbers;
}

/// A number for each of so many edges, or one for all of them.
Eigen::VectorXd read_numbers_or_one(const JsonValue& value, size_t count) {
    if (value.json().is_number()) {
        return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(count), value.number());
    }
    return read_numbers(value);
}

std::vector<int> read_indices(const JsonValue& list) {
    std::vector<int> indices(list.array_size("an array of indices"));
    for (size_t i = 0; i < indices.size(); ++i) {
        indices[i] = list.at(i).integer();
    }
    return indices;
}

std::vector<std::string> read_texts(const std::optional<JsonValue>& list) {
    std::vector<std::string> texts(list ? list->array_size("an array of texts") : 0);
    for (size_t i = 0; i < texts.size(); ++i) {
        texts[i] = list->at(i).text();
    }
    return texts;
}

std::vector<TensionLaw> read_tension_laws(const std::optional<JsonValue>& list) {
    std::vector<TensionLaw> laws(list ? list->array_size("an array of tension laws") : 0);
    for (size_t i = 0; i < laws.size(); ++i) {
        const JsonValue law = list->at(i);
        law.require_object(R"(an object with "strain" and "tension")");
        const auto name = law.find("name");
        laws[i] = {.name = name ? name->text() : "",
                   .strain = read_numbers(law.require("strain", "an array of numbers")),
                   .tension = read_numbers(law.require("tension", "an array of numbers [N]"))};
    }
    return laws;
}

/// An index or null for each edge.
std::vector<int> read_law_indices(const std::optional<JsonValue>& list) {
    std::vector<int> indices(list ? list->array_size("an array of indices or null") : 0, -1);
    for (size_t e = 0; e < indices.size(); ++e) {
        if (const JsonValue value = list->at(e); !value.json().is_null()) {
            indices[e] = value.integer();
            if (indices[e] < 0) {
                value.fail(
                    fmt::format("is {}, expected the index of a tension law, or null", indices[e]));
            }
        }
    }
    return indices;
}

/// A list of either of two words.
template <class T>
std::vector<T> read_words(const std::optional<JsonValue>& list,
                          const std::pair<std::string, T>& one,
                          const std::pair<std::string, T>& other) {
    std::vector<T> values;
    const size_t count =
        list ? list->array_size(fmt::format("an array of {} and {}", one.first, other.first)) : 0;
    for (size_t i = 0; i < count; ++i) {
        const JsonValue value = list->at(i);
        const std::string& text = value.text();
        if (text != one.first && text != other.first) {
            value.fail(fmt::format(R"(is {}, expected "{}" or "{}")", quote(text), one.first,
                                   other.first));
        }
        values.push_back(text == one.first ? one.second : other.second);
    }
    return values;
}

/// A word for each edge, or one for all.
std::vector<CableEnds> read_cable_ends(const std::optional<JsonValue>& value, size_t edges) {
    const auto read = [](const JsonValue& word) {
        const std::optional<CableEnds> ends = cable_ends_named(word.text());
        if (!ends) {
            word.fail(fmt::format(R"(is {}, expected "hinged", "fixed" or "unknown")",
                                  quote(word.text())));
        }
        return *ends;
    };
    std::vector<CableEnds> result;
    if (value && value->json().is_string()) {
        result.assign(edges, read(*value));
    } else if (value) {
        const size_t count = value->array_size("a word, or an array of one for each edge");
        for (size_t i = 0; i < count; ++i) {
            result.push_back(read(value->at(i)));
        }
    }
    return result;
}

/// A number or null for each edge, or one number for all struts.
Eigen::VectorXd read_buckling_loads(const std::optional<JsonValue>& value,
                                    const CableNetData& data) {
    if (!value) {
        return {};
    }
    if (std::ranges::find(data.kind, EdgeKind::strut) == data.kind.end()) {
        value->fail("is given, but no edge is a strut by \"kind\"");
    }
    Eigen::VectorXd loads =
        Eigen::VectorXd::Constant(std::ssize(data.edges), std::numeric_limits<double>::infinity());
    if (value->json().is_number()) {
        for (size_t e = 0; e < data.kind.size() && e < data.edges.size(); ++e) {
            if (data.kind[e] == EdgeKind::strut) {
                loads(static_cast<Eigen::Index>(e)) = value->number();
            }
        }
        return loads;
    }
    value->require_array(data.edges.size(), "one number, or an array of numbers and null");
    for (size_t e = 0; e < data.edges.size(); ++e) {
        if (const JsonValue one = value->at(e); !one.json().is_null()) {
            loads(static_cast<Eigen::Index>(e)) = one.number();
        }
    }
    return loads;
}

/// A number for each edge, one for all cables without a tension law, or "mass".
Eigen::VectorXd read_sag_weights(const std::optional<JsonValue>& value, const CableNetData& data) {
    if (!value) {
        return {};
    }
    if (value->json().is_string()) {
        if (value->text() != "mass") {
            value->fail(fmt::format(R"(is {}, expected "mass", one number, or an array of numbers)",
                                    quote(value->text())));
        }
        if (data.mass.size() == 0) {
            value->fail(R"(is "mass", but the net has no "mass")");
        }
        const auto count = static_cast<int>(data.nodes.cols());
        const auto is_node = [count](int node) { return node >= 0 && node < count; };
        const bool has_sizes =  // else the net is refused for these
            data.mass.size() == std::ssize(data.edges) &&
            (data.kind.empty() || data.kind.size() == data.edges.size()) &&
            (data.tension_law.empty() || data.tension_law.size() == data.edges.size()) &&
            std::ranges::all_of(
                data.edges, [&](const Edge& edge) { return is_node(edge[0]) && is_node(edge[1]); });
        return has_sizes ? sag_weights_by_mass(data) : Eigen::VectorXd();
    }
    return value->json().is_number() ? equal_sag_weights(data, value->number())
                                     : read_numbers_or_one(*value, data.edges.size());
}

std::map<std::string, std::vector<int>> read_groups(const std::optional<JsonValue>& object) {
    std::map<std::string, std::vector<int>> groups;
    if (object) {
        object->require_object("an object of lists of edges");
        for (const auto& [name, edges] : object->json().items()) {
            groups[name] = read_indices(object->require(name, "an array of edges"));
        }
    }
    return groups;
}

std::vector<CableRun> read_runs(const std::optional<JsonValue>& list) {
    std::vector<CableRun> runs(list ? list->array_size("an array of runs") : 0);
    for (size_t k = 0; k < runs.size(); ++k) {
        const JsonValue run = list->at(k);
        run.require_object("a run of cable: {\"edges\": [...]}");
        const auto name = run.find("name");
        const auto slides_at = run.find("slides_at");
        const auto friction = run.find("friction");
        const auto given = run.find("ratios");
        const Eigen::VectorXd ratios = given ? read_numbers(*given) : Eigen::VectorXd();
        runs[k] = {.name = name ? name->text() : "",
                   .edges = read_indices(run.require("edges", "an array of edges")),
                   .slides_at = slides_at ? read_indices(*slides_at) : std::vector<int>(),
                   .friction = friction ? std::optional(friction->number()) : std::nullopt,
                   .ratios = {ratios.begin(), ratios.end()}};
    }
    return runs;
}

/// Whether places follow from the nominal form, with_supports_in_balance().
bool are_balanced(const JsonValue& places) {
    return places.json().is_string() && places.text() == "balanced";
}

/// Moves supports with a stiffness from the rigid to the elastic ones.
void read_elastic_supports(const JsonValue& root, CableNetData& data) {
    const auto stiffnesses = root.find("support_stiffness");
    const auto places = root.find("support_place");
    if (places && !stiffnesses) {
        places->fail("is given without \"support_stiffness\"");
    }
    if (!stiffnesses) {
        return;
    }
    const std::vector<int> all = std::exchange(data.supports, {});
    const bool is_one_for_all = stiffnesses->json().is_number();
    if (!is_one_for_all) {
        stiffnesses->require_array(all.size(),
                                   "one number or an array with an entry for each support");
    }
    const bool are_listed = places && !are_balanced(*places);
    if (are_listed) {
        places->require_array(all.size(),
                              "\"balanced\" or an array with an entry for each support");
    }
    for (size_t i = 0; i < all.size(); ++i) {
        const JsonValue stiffness = is_one_for_all ? *stiffnesses : stiffnesses->at(i);
        const bool has_place = are_listed && !places->at(i).json().is_null();
        if (stiffness.json().is_null()) {
            if (has_place) {
                places->at(i).fail("is given for a support without stiffness, expected null");
            }
            data.supports.push_back(all[i]);
            continue;
        }
        if (all[i] < 0 || all[i] >= data.nodes.cols()) {
            root.fail_below(
                fmt::format("/supports/{}", i),
                fmt::format("is {}, expected one of the {} nodes", all[i], data.nodes.cols()));
        }
        ElasticSupport support{.node = all[i],
                               .stiffness = read_stiffness(stiffness),
                               .place = data.nodes.col(all[i])};
        if (has_place) {
            support.place = read_place(places->at(i));
        }
        data.elastic_supports.push_back(support);
    }
}

/// Position in the elastic supports of a node that a coupling names.
int elastic_support_named(const JsonValue& node, const CableNetData& data) {
    const auto found =
        std::ranges::find(data.elastic_supports, node.integer(), &ElasticSupport::node);
    if (found == data.elastic_supports.end()) {
        node.fail("names no support with a stiffness");
    }
    return static_cast<int>(found - data.elastic_supports.begin());
}

void read_support_couplings(const std::optional<JsonValue>& list, CableNetData& data) {
    for (size_t i = 0; list && i < list->array_size("an array of couplings"); ++i) {
        const JsonValue entry = list->at(i);
        entry.require_array(3, "[support, support, matrix of 3 x 3 [N/m]]");
        SupportCoupling coupling{
            .first = elastic_support_named(entry.at(0), data),
            .second = elastic_support_named(entry.at(1), data),
            .stiffness = read_stiffness(entry.at(2), "a matrix of 3 x 3 [N/m]")};
        if (coupling.first > coupling.second) {
            std::swap(coupling.first, coupling.second);
            coupling.stiffness.transposeInPlace();
        }
        data.support_couplings.push_back(coupling);
    }
}

/// Entry of "supports" of the i-th rigid or elastic one.
int entry_of_support(const nlohmann::json& stiffnesses, bool is_elastic, int i) {
    if (stiffnesses.is_number()) {
        return i;
    }
    int entry = 0;
    for (; entry < static_cast<int>(stiffnesses.size()); ++entry) {
        const bool is_one = stiffnesses.at(static_cast<size_t>(entry)).is_null() != is_elastic;
        if (is_one && i == 0) {
            break;
        }
        i -= is_one ? 1 : 0;
    }
    return entry;
}

/// JSON pointer of a broken rule.
std::string pointer_to(const JsonValue& root, const NetError& error) {
    const std::string& field = error.field();
    if (root.json().contains(field) && root.json().at(field).is_number()) {
        return "/" + field;  // one for all
    }
    const bool is_elastic = field == "elastic_supports";
    if (root.json().contains("support_stiffness") && !error.index().empty() &&
        (is_elastic || field == "supports")) {
        return fmt::format("/supports/{}", entry_of_support(root.json().at("support_stiffness"),
                                                            is_elastic, error.index().front()));
    }
    std::string pointer = "/" + field;
    for (const int index : error.index()) {
        pointer += "/" + std::to_string(index);
    }
    return pointer;
}

/// A number for each edge, or one for all; none where the key is not there.
Eigen::VectorXd read_rates(const std::optional<JsonValue>& value, size_t edges) {
    return value ? read_numbers_or_one(*value, edges) : Eigen::VectorXd();
}

/// The file's name without its ending. Bytes that are not UTF-8, which a file's name may hold but a
/// JSON text may not, are replaced.
std::string default_name(const std::string& file_name) {
    const nlohmann::json stem = std::filesystem::path(file_name).stem().string();
    return nlohmann::json::parse(
        stem.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

CableNetData read_data(const JsonValue& root) {
    const auto list = [&root](const std::string& key) { return root.require(key, "an array"); };
    CableNetData data;
    const auto name = root.find("name");
    data.name = name ? name->text() : default_name(root.file_name());
    data.nodes = read_points(list("nodes"));
    data.supports = read_indices(list("supports"));
    data.edges = read_edges(list("edges"));
    data.axial_stiffness = read_numbers_or_one(
        root.require("axial_stiffness", "an array of numbers, or one number"), data.edges.size());
    data.unstressed_lengths = read_numbers(list("unstressed_lengths"));
    const auto adjustable = root.find("adjustable");
    data.adjustable =
        adjustable ? read_indices(*adjustable) : edges_at_supports(data.edges, data.supports);
    const auto loads = root.find("loads");
    data.loads = loads ? read_points(*loads) : Points(3, 0);
    data.node_ids = read_texts(root.find("node_ids"));
    data.edge_ids = read_texts(root.find("edge_ids"));
    data.tension_laws = read_tension_laws(root.find("tension_laws"));
    data.tension_law = read_law_indices(root.find("tension_law"));
    data.groups = read_groups(root.find("groups"));
    data.mass = read_rates(root.find("mass"), data.edges.size());
    data.expansion = read_rates(root.find("expansion"), data.edges.size());
    data.breaking_load = read_rates(root.find("breaking_load"), data.edges.size());
    data.bending_stiffness = read_rates(root.find("bending_stiffness"), data.edges.size());
    data.cable_ends = read_cable_ends(root.find("cable_ends"), data.edges.size());
    data.thread =
        read_words<Thread>(root.find("thread"), {"right", Thread::right}, {"left", Thread::left});
    data.runs = read_runs(root.find("runs"));
    data.kind = read_words<EdgeKind>(root.find("kind"), {"cable", EdgeKind::cable},
                                     {"strut", EdgeKind::strut});
    data.buckling_load = read_buckling_loads(root.find("buckling_load"), data);
    data.sag_weight = read_sag_weights(root.find("sag_weight"), data);
    read_elastic_supports(root, data);
    read_support_couplings(root.find("support_couplings"), data);
    return data;
}

}  // namespace

CableNet read_net_value(const JsonValue& root) {
    check_format(root);
    CableNetData data = read_data(root);
    try {
        CableNet net(std::move(data));
        const auto places = root.find("support_place");
        return places && are_balanced(*places) ? with_supports_in_balance(net) : net;
    } catch (const NetError& error) {
        root.fail_below(pointer_to(root, error), error.problem());
    }
}

NetFile parse_net(std::string_view text, const std::string& file_name) {
    return read_json(text, file_name, [](const JsonValue& root) -> NetFile {
        check_format(root);
        nlohmann::json unknown = nlohmann::json::object();
        for (const auto& [key, value] : root.json().items()) {
            if (!is_net_key(key)) {
                unknown[key] = value;
            }
        }
        return {.net = read_net_value(root), .unknown_keys = unknown.dump()};
    });
}

NetFile read_net(const std::filesystem::path& path) {
    NetFile file = parse_net(read_file(path), path.string());
    try {
        refuse_impossible_units(file.net);
    } catch (const NetError& error) {
        throw InputError(path.string(), "/" + error.field(), error.problem());
    }
    return file;
}

}  // namespace taut
