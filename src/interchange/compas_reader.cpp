// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <set>
#include <vector>

#include "files/json_matrix.hpp"
#include "files/json_parse.hpp"
#include "files/message.hpp"
#include "interchange/compas_attributes.hpp"
#include "interchange/compas_keys.hpp"
#include "interchange/compas_structure.hpp"
#include "interchange/edge_collection.hpp"
#include "taut/interchange/compas_json.hpp"

namespace taut {
namespace {

/// The first of several names that the object has, if it is an object.
std::optional<JsonValue> find_object(const JsonValue& value,
                                     std::initializer_list<const char*> names) {
    for (const char* name : names) {
        if (const auto found = value.find(name)) {
            found->require_object("an object");
            return found;
        }
    }
    return std::nullopt;
}

/// A node's key, which a face or an edge may give as a number or as text.
std::string key_of(const JsonValue& value) {
    return value.json().is_number_integer() ? std::to_string(value.integer())
                                            : std::string(without_quotes(value.text()));
}

class Reader {
public:
    Reader(const CompasStructure& source, const std::string& file_name) : m_data(source.data) {
        m_structure.file = file_name;
        const bool is_mesh = m_data.find("face").has_value();
        const bool is_jax_fdm = source.dtype.starts_with("jax_fdm");
        m_structure.format =
            fmt::format("{} {}{}", is_jax_fdm ? "JAX FDM" : "COMPAS", is_mesh ? "mesh" : "network",
                        source.key.empty() ? "" : " at the key " + quote(source.key));
    }

    ImportedStructure read() {
        read_attributes();
        read_nodes();
        if (const auto faces = find_object(m_data, {"face"})) {
            read_faces(*faces);
        } else {
            read_edge_list(*find_object(m_data, {"edge"}));
        }
        read_edge_data();
        m_edges.write_to(m_structure);
        finish_edges();
        return std::move(m_structure);
    }

private:
    void read_attributes() {
        const auto attributes = find_object(m_data, {"attributes"});
        const auto name = attributes ? attributes->find("name") : std::nullopt;
        if (name && name->json().is_string()) {
            static const std::set<std::string> of_types{"Mesh", "Network", "Graph"};
            m_structure.name = of_types.contains(name->text()) ? "" : name->text();
        }
        const auto unit = attributes ? attributes->find("force_unit") : std::nullopt;
        if (unit && unit->json() == "N") {
            m_structure.force_unit = 1.0;
        } else if (unit && unit->json() == "kN") {
            m_structure.force_unit = 1e3;
        } else if (unit) {
            unit->fail(R"(is no unit of force that taut knows, expected "N" or "kN")");
        }
        const auto length = attributes ? attributes->find("length_unit") : std::nullopt;
        if (length && length->json() != "m") {
            length->fail(R"(is another unit of length than taut knows, expected "m")");
        }
    }

    /// The weight of a surface over the net: COMPAS FoFin computes it from a density and the
    /// thickness at each vertex, and does not keep it among the loads.
    void note_self_weight(bool has_thickness) {
        const auto attributes = find_object(m_data, {"attributes"});
        const auto density = attributes ? attributes->find("density") : std::nullopt;
        if (has_thickness && density && density->json().is_number() && density->number() != 0.0) {
            m_structure.notes.push_back(fmt::format(
                "self-weight (density {}): not among the file's loads", density->json().dump()));
        }
    }

    void read_nodes() {
        const JsonValue nodes = *find_object(m_data, {"vertex", "node"});
        const auto defaults = find_object(
            m_data, {"dva", "dna", "default_vertex_attributes", "default_node_attributes"});
        std::map<std::string, std::string, KeyOrder> key_of_node;  // in the order of the nodes
        for (const auto& [key, value] : nodes.json().items()) {
            if (!key_of_node.emplace(without_quotes(key), key).second) {
                nodes.find(key)->fail(fmt::format("names the node {} a second time", quote(key)));
            }
        }
        bool has_thickness = false;
        for (const auto& [id, key] : key_of_node) {
            const JsonValue value = *nodes.find(key);
            CompasAttributes attributes(defaults);
            attributes.add(value);
            ImportedNode node{.id = id, .place = value.pointer()};
            for (int k = 0; k < 3; ++k) {
                const std::string axis(1, "xyz"[k]);
                const auto coordinate = attributes.find(axis);
                node.position(k) =
                    coordinate ? coordinate->number() : value.require(axis, "a number").number();
                node.load(k) = attributes.number("p" + axis, 0.0);
            }
            for (const char* flag : {"is_anchor", "is_fixed", "is_support"}) {
                node.is_support |= attributes.flag(flag, false);
            }
            read_support_and_slides(attributes, node);
            for (const char* thickness : {"t", "thickness"}) {
                const auto given = attributes.find(thickness);
                has_thickness |= given && given->json() != 0;
            }
            m_index.emplace(id, static_cast<int>(m_structure.nodes.size()));
            const auto name = attributes.find("name");
            m_names.push_back(name && name->json().is_string() ? name->text() : "");
            m_structure.nodes.push_back(std::move(node));
        }
        take_names();
        note_self_weight(has_thickness);
    }

    static void read_support_and_slides(const CompasAttributes& attributes, ImportedNode& node) {
        const auto place = attributes.find("support_place");
        if (const auto stiffness = attributes.find("support_stiffness")) {
            node.support_stiffness = read_stiffness(*stiffness);
        } else if (place) {
            place->fail("is given without \"support_stiffness\"");
        }
        if (place) {
            node.support_place = read_place(*place);
        }
        const auto slides = attributes.find("slides");
        if (!slides) {
            return;
        }
        if (!slides->json().is_array()) {
            node.all_slide = slides->flag();
            return;
        }
        for (size_t k = 0; k < slides->array_size("true, false or names of runs"); ++k) {
            node.slides.push_back(slides->at(k).text());
        }
    }

    /// Nodes go by their names where each has one of its own, else by their keys.
    void take_names() {
        const std::set<std::string> names(m_names.begin(), m_names.end());
        if (names.size() != m_structure.nodes.size() || names.contains("")) {
            return;
        }
        for (size_t i = 0; i < m_names.size(); ++i) {
            m_structure.nodes[i].id = m_names[i];
        }
    }

    int node_at(const JsonValue& place, const std::string& key) const {
        const auto found = m_index.find(key);
        if (found == m_index.end()) {
            place.fail(fmt::format("names the vertex {}, which is not in the file", quote(key)));
        }
        return found->second;
    }

    void read_faces(const JsonValue& faces) {
        for (const auto& [key, unused] : faces.json().items()) {
            const JsonValue face = *faces.find(key);
            const size_t size = face.array_size("an array of vertices");
            if (size < 3) {
                face.fail(fmt::format("has {} vertices, expected at least 3", size));
            }
            for (size_t i = 0; i < size; ++i) {
                const JsonValue next = face.at((i + 1) % size);
                const int s = node_at(face.at(i), key_of(face.at(i)));
                const int t = node_at(next, key_of(next));
                if (s == t) {
                    next.fail("names the same vertex as the one before it");
                }
                m_edges.add_side(s, t, face.pointer());
            }
        }
    }

    void read_edge_list(const JsonValue& edges) {
        for (const auto& [from, unused] : edges.json().items()) {
            const JsonValue neighbours = *edges.find(from);
            neighbours.require_object("an object of neighbours");
            const int s = node_at(neighbours, std::string(without_quotes(from)));
            for (const auto& [to, also_unused] : neighbours.json().items()) {
                const JsonValue attributes = *neighbours.find(to);
                const int t = node_at(attributes, std::string(without_quotes(to)));
                if (s == t) {
                    attributes.fail("joins a node to itself");
                }
                m_edges.add(s, t, attributes.pointer());
                add_attributes(s, t, attributes);
            }
        }
    }

    void add_attributes(int s, int t, const JsonValue& object) {
        auto [entry, unused] = m_attributes.try_emplace(
            std::minmax(s, t),
            CompasAttributes(find_object(m_data, {"dea", "default_edge_attributes"})));
        entry->second.add(object);
        m_places.try_emplace(std::minmax(s, t), object.pointer());
    }

    void read_edge_data() {
        const auto edge_data = find_object(m_data, {"edgedata"});
        if (!edge_data) {
            return;
        }
        int unused_entries = 0;
        for (const auto& [key, unused] : edge_data->json().items()) {
            const JsonValue entry = *edge_data->find(key);
            const auto keys = split_edge_key(key, m_index);
            if (!keys) {
                entry.fail("is no edge, expected a key such as '(1, 2)' or '1-2'");
            }
            const auto s = m_index.find(keys->first);
            const auto t = m_index.find(keys->second);
            if (s == m_index.end() || t == m_index.end() ||
                !m_edges.contains(s->second, t->second)) {
                ++unused_entries;
            } else {
                add_attributes(s->second, t->second, entry);
            }
        }
        if (unused_entries > 0) {
            m_structure.notes.push_back(
                fmt::format("{} entries of edgedata that are no edges", unused_entries));
        }
    }

    /// Gives the edges their attributes, and takes those out that are none.
    void finish_edges() {
        const auto defaults = find_object(m_data, {"dea", "default_edge_attributes"});
        std::vector<ImportedEdge> active;
        for (ImportedEdge& edge : m_structure.edges) {
            const auto found = m_attributes.find({edge.s, edge.t});
            const CompasAttributes attributes =
                found == m_attributes.end() ? CompasAttributes(defaults) : found->second;
            if (!attributes.flag("is_edge", true) || !attributes.flag("_is_edge", true)) {
                ++m_structure.inactive_edges;
                continue;
            }
            if (const auto place = m_places.find({edge.s, edge.t}); place != m_places.end()) {
                edge.place = place->second;
            }
            edge.numbers = attributes.numbers();
            const auto name = attributes.find("name");
            if (name && name->json().is_string() && !name->text().empty()) {
                edge.id = name->text();
            }
            const auto run = attributes.find("run");
            edge.run = run ? key_of(*run) : "";
            const auto type = attributes.find("type");
            edge.is_beam = type && (type->json() == "beam" || type->json() == "strut");
            active.push_back(std::move(edge));
        }
        m_structure.edges = std::move(active);
    }

    JsonValue m_data;
    ImportedStructure m_structure;
    NodeIndex m_index;
    std::vector<std::string> m_names;
    EdgeCollection m_edges;
    std::map<std::pair<int, int>, CompasAttributes> m_attributes;
    std::map<std::pair<int, int>, std::string> m_places;
};

}  // namespace

ImportedStructure parse_compas(std::string_view text, const std::string& file_name,
                               const std::string& select) {
    return read_json(text, file_name, [&](const JsonValue& root) {
        return Reader(find_compas_structure(root, select), file_name).read();
    });
}

}  // namespace taut
