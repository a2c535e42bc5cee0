// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/net/cable_net.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

#include "net/fingerprint.hpp"
#include "net/sliding_nodes.hpp"
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

/// Checks the tension laws, and sets EA of the edges that have one.
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

/// Sorts the adjustable edges, each with its thread.
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

/// The tension law of each cable that sags; none if no cable does. One lighter than a part 1e-8 of
/// its stiffness is straight.
std::vector<TensionLaw> sag_laws(const CableNetData& data) {
    constexpr double least_strain = 1e-8;
    std::vector<TensionLaw> laws;
    for (Eigen::Index e = 0; e < data.sag_weight.size(); ++e) {
        const double sag = data.sag_weight(e) * data.unstressed_lengths(e) / std::sqrt(24.0);
        const double EA = data.axial_stiffness(e);
        if (sag > least_strain * EA) {
            laws.resize(data.edges.size());
            laws[static_cast<size_t>(e)] = {.name = "",
                                            .strain = Eigen::Vector2d(0.0, 1.0),
                                            .tension = Eigen::Vector2d(0.0, EA),
                                            .sag = sag};
        }
    }
    return laws;
}

/// Indices of the names, sorted by name.
std::vector<int> sorted_by_name(const std::vector<std::string>& ids) {
    std::vector<int> order(ids.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int i) -> std::string_view { return ids[i]; });
    return order;
}

/// The index of a name, or -1.
/// @param order as sorted_by_name(); without names an index is its own name
int find_name(std::string_view id, const std::vector<std::string>& ids,
              const std::vector<int>& order, int count) {
    if (ids.empty()) {
        int index = -1;
        std::from_chars(id.data(), id.data() + id.size(), index);
        return index >= 0 && index < count && std::to_string(index) == id ? index : -1;
    }
    const auto found =
        std::ranges::lower_bound(order, id, {}, [&](int i) -> std::string_view { return ids[i]; });
    return found != order.end() && ids[*found] == id ? *found : -1;
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

Eigen::VectorXd sag_weights_by_mass(const CableNetData& data) {
    if (data.mass.size() != std::ssize(data.edges)) {
        throw std::invalid_argument(
            "the net has no mass of every edge, which sags would follow from");
    }
    Eigen::VectorXd weights = equal_sag_weights(data, gravity).cwiseProduct(data.mass);
    for (size_t e = 0; e < data.edges.size(); ++e) {
        const auto [s, t] = data.edges[e];
        const Eigen::Vector3d chord = (data.nodes.col(s) - data.nodes.col(t)).normalized();
        weights(static_cast<Eigen::Index>(e)) *= chord.head<2>().norm();
    }
    return weights;
}

Eigen::VectorXd equal_sag_weights(const CableNetData& data, double weight) {
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(std::ssize(data.edges), weight);
    for (int e = 0; e < weights.size(); ++e) {
        if ((e < std::ssize(data.kind) && data.kind[e] == EdgeKind::strut) ||
            (e < std::ssize(data.tension_law) && data.tension_law[e] >= 0)) {
            weights(e) = 0.0;
        }
    }
    return weights;
}

CableNet::CableNet(CableNetData data) : m_data(std::move(data)) {
    if (m_data.loads.cols() == 0) {
        m_data.loads = Points::Zero(3, m_data.nodes.cols());
    }
    take_stiffness_of_laws(m_data);
    validate(m_data);
    sort_adjustable(m_data);
    if (std::ranges::find(m_data.kind, EdgeKind::strut) == m_data.kind.end()) {
        m_data.kind.clear();
        m_data.buckling_load.resize(0);
    }
    for (ElasticSupport& support : m_data.elastic_supports) {  // rounding errors of its maker
        support.stiffness = (0.5 * (support.stiffness + support.stiffness.transpose())).eval();
    }
    m_loads = with_self_weight(m_data);
    if (m_data.sag_weight.size() > 0 && m_data.sag_weight.isZero(0.0)) {
        m_data.sag_weight.resize(0);
    }
    m_sag_laws = sag_laws(m_data);
    for (const CableRun& run : m_data.runs) {
        const std::vector<SlidingNode> of_run = sliding_nodes_of(m_data.edges, run);
        m_sliding.insert(m_sliding.end(), of_run.begin(), of_run.end());
    }

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
    list_edges_at_nodes();
    m_nodes_by_name = sorted_by_name(m_data.node_ids);
    m_edges_by_name = sorted_by_name(m_data.edge_ids);
    m_fingerprint = compute_fingerprint(m_data);
}

void CableNet::list_edges_at_nodes() {
    m_starts.assign(node_count() + 1, 0);
    for (const auto& [s, t] : m_data.edges) {
        ++m_starts[s + 1];
        ++m_starts[t + 1];
    }
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    m_edges_at.resize(m_starts.back());
    m_neighbours.resize(m_starts.back());
    std::vector<int> next(m_starts.begin(), m_starts.end() - 1);
    for (int edge = 0; edge < edge_count(); ++edge) {
        const auto [s, t] = m_data.edges[edge];
        for (const auto [node, other] : {Edge{s, t}, Edge{t, s}}) {
            m_edges_at[next[node]] = edge;
            m_neighbours[next[node]++] = other;
        }
    }
}

void CableNet::refuse_index(const char* what, int index, std::size_t count) {
    throw std::out_of_range(fmt::format("{} {}, expected 0 to {}", what, index,
                                        static_cast<std::ptrdiff_t>(count) - 1));
}

std::vector<int> CableNet::all_supports() const {
    std::vector<int> result = m_data.supports;
    std::ranges::transform(m_data.elastic_supports, std::back_inserter(result),
                           &ElasticSupport::node);
    return result;
}

Points CableNet::support_places() const {
    const auto rigid = std::ssize(m_data.supports);
    Points result(3, rigid + std::ssize(m_data.elastic_supports));
    result.leftCols(rigid) = m_data.nodes(Eigen::all, m_data.supports);
    for (Eigen::Index i = rigid; i < result.cols(); ++i) {
        result.col(i) = m_data.elastic_supports[static_cast<size_t>(i - rigid)].place;
    }
    return result;
}

bool CableNet::is_support(int node) const {
    return free_index(node) < 0 ||
           std::ranges::find(m_data.elastic_supports, node, &ElasticSupport::node) !=
               m_data.elastic_supports.end();
}

int CableNet::interior_index(int edge) const {
    check_index("edge", edge, m_data.edges.size());
    const auto found = std::ranges::lower_bound(m_interior, edge);
    return found != m_interior.end() && *found == edge
               ? static_cast<int>(found - m_interior.begin())
               : -1;
}

std::span<const int> CableNet::edges_at(int node) const {
    check_index("node", node, m_free_index.size());
    return std::span(m_edges_at).subspan(m_starts[node], m_starts[node + 1] - m_starts[node]);
}

std::span<const int> CableNet::neighbours(int node) const {
    check_index("node", node, m_free_index.size());
    return std::span(m_neighbours).subspan(m_starts[node], m_starts[node + 1] - m_starts[node]);
}

std::string CableNet::node_id(int node) const {
    check_index("node", node, m_free_index.size());
    return m_data.node_ids.empty() ? std::to_string(node) : m_data.node_ids[node];
}

std::string CableNet::edge_id(int edge) const {
    check_index("edge", edge, m_data.edges.size());
    return m_data.edge_ids.empty() ? std::to_string(edge) : m_data.edge_ids[edge];
}

int CableNet::find_node(std::string_view id) const {
    return find_name(id, m_data.node_ids, m_nodes_by_name, node_count());
}

int CableNet::find_edge(std::string_view id) const {
    return find_name(id, m_data.edge_ids, m_edges_by_name, edge_count());
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
