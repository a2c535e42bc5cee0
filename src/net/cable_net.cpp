// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/net/cable_net.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "net/fingerprint.hpp"
#include "net/validation.hpp"

namespace taut {
namespace {

void check_size(const char* what_has, Eigen::Index size, int expected, const char* of_what) {
    if (size != expected) {
        throw std::invalid_argument(
            fmt::format("{} {} {}, expected {}", what_has, size, of_what, expected));
    }
}

std::string place_of(const std::string& field, const std::vector<int>& index) {
    std::string place = field;
    for (const int i : index) {
        place += fmt::format("[{}]", i);
    }
    return place;
}

/// Sets EA of the edges with a law, after what that needs is checked.
void take_stiffness_of_laws(CableNetData& data) {
    validate_tension_laws(data);
    if (std::ranges::all_of(data.tension_law, [](int law) { return law < 0; })) {
        data.tension_law.clear();
    }
    for (size_t e = 0; e < data.tension_law.size(); ++e) {
        if (const int law = data.tension_law[e]; law >= 0) {
            data.axial_stiffness(static_cast<Eigen::Index>(e)) = data.tension_laws[law].steepest();
        }
    }
}

/// Ascending, each with its thread.
void sort_adjustable(CableNetData& data) {
    if (!data.thread.empty()) {
        std::map<int, Thread> thread_of;
        for (size_t k = 0; k < data.thread.size(); ++k) {
            thread_of.emplace(data.adjustable[k], data.thread[k]);
        }
        data.thread.clear();
        for (const auto& [edge, thread] : thread_of) {
            data.thread.push_back(thread);
        }
    }
    std::ranges::sort(data.adjustable);
}

Points with_self_weight(const CableNetData& data) {
    Points loads = data.loads;
    for (Eigen::Index e = 0; e < data.mass.size(); ++e) {
        for (const int node : data.edges[e]) {
            loads(2, node) -= 0.5 * gravity * data.mass(e) * data.unstressed_lengths(e);
        }
    }
    return loads;
}

}  // namespace

NetError::NetError(std::string field, std::vector<int> index, std::string problem)
    : std::invalid_argument(place_of(field, index) + ": " + problem),
      m_field(std::move(field)),
      m_index(std::move(index)),
      m_problem(std::move(problem)) {}

std::vector<int> edges_at_supports(const std::vector<Edge>& edges,
                                   const std::vector<int>& supports) {
    const std::set<int> support_set(supports.begin(), supports.end());
    std::vector<int> result;
    for (size_t e = 0; e < edges.size(); ++e) {
        if (support_set.contains(edges[e][0]) || support_set.contains(edges[e][1])) {
            result.push_back(static_cast<int>(e));
        }
    }
    return result;
}

CableNet::CableNet(CableNetData data) : m_data(std::move(data)) {
    if (m_data.loads.cols() == 0) {
        m_data.loads = Points::Zero(3, m_data.nodes.cols());
    }
    take_stiffness_of_laws(m_data);
    validate(m_data);
    sort_adjustable(m_data);
    m_loads = with_self_weight(m_data);

    m_free_index.assign(node_count(), 0);
    for (const int support : m_data.supports) {
        m_free_index[support] = -1;
    }
    for (int node = 0; node < node_count(); ++node) {
        int& index = m_free_index[node];
        if (index == 0) {
            index = free_node_count();
            m_free_nodes.push_back(node);
        }
    }
    for (int edge = 0; edge < edge_count(); ++edge) {
        if (!std::ranges::binary_search(m_data.adjustable, edge)) {
            m_interior.push_back(edge);
        }
    }
    m_fingerprint = compute_fingerprint(m_data);
}

void CableNet::refuse_index(const char* what, int index, std::size_t count) {
    throw std::out_of_range(fmt::format("{} {}, expected 0 to {}", what, index,
                                        static_cast<std::ptrdiff_t>(count) - 1));
}

int CableNet::interior_index(int edge) const {
    check_index("edge", edge, m_data.edges.size());
    const auto found = std::ranges::lower_bound(m_interior, edge);
    return found != m_interior.end() && *found == edge
               ? static_cast<int>(found - m_interior.begin())
               : -1;
}

std::string CableNet::node_id(int node) const {
    check_index("node", node, m_free_index.size());
    return m_data.node_ids.empty() ? std::to_string(node) : m_data.node_ids[node];
}

std::string CableNet::edge_id(int edge) const {
    check_index("edge", edge, m_data.edges.size());
    return m_data.edge_ids.empty() ? std::to_string(edge) : m_data.edge_ids[edge];
}

Eigen::VectorXd free_coordinates(const CableNet& net, const Eigen::Ref<const Points>& form) {
    check_size("form has", form.cols(), net.node_count(), "points");
    Eigen::VectorXd coordinates(3 * net.free_node_count());
    for (int i = 0; i < net.free_node_count(); ++i) {
        coordinates.segment<3>(3 * i) = form.col(net.free_nodes()[i]);
    }
    return coordinates;
}

Points with_free_coordinates(const CableNet& net,
                             const Eigen::Ref<const Eigen::VectorXd>& coordinates) {
    check_size("coordinates has", coordinates.size(), 3 * net.free_node_count(), "entries");
    Points form = net.nodes();
    for (int i = 0; i < net.free_node_count(); ++i) {
        form.col(net.free_nodes()[i]) = coordinates.segment<3>(3 * i);
    }
    return form;
}

Eigen::VectorXd with_length_deviations(const CableNet& net,
                                       const Eigen::Ref<const Eigen::VectorXd>& deviations) {
    check_size("deviations has", deviations.size(), net.interior_edge_count(), "entries");
    Eigen::VectorXd lengths = net.unstressed_lengths();
    lengths(net.interior_edges()) += deviations;
    return lengths;
}

}  // namespace taut
