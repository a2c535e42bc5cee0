// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/tension_law.hpp"

namespace taut {

/// Coordinates of all nodes of a net, one column a node [m].
using Points = Eigen::Matrix3Xd;

/// The two nodes (s, t) that an edge connects.
using Edge = std::array<int, 2>;

/// A rule of a cable net that is broken, and where in CableNetData. what() tells both:
/// "edges[3]: connects node 7 to itself".
class TAUT_CORE_EXPORT NetError : public std::invalid_argument {
public:
    /// @param index entry, or entry and axis; empty: the field as a whole
    NetError(std::string field, std::vector<int> index, std::string problem);

    /// Of CableNetData: "edges", say.
    [[nodiscard]] const std::string& field() const { return m_field; }
    /// The entry: {3}; a coordinate by entry and axis: {4, 1}; empty where the field as a whole is
    /// wrong.
    [[nodiscard]] const std::vector<int>& index() const { return m_index; }
    /// What is wrong there, and what was expected.
    [[nodiscard]] const std::string& problem() const { return m_problem; }

private:
    std::string m_field;
    std::vector<int> m_index;
    std::string m_problem;
};

/// Thread of a turnbuckle. With a right-hand thread, turning it clockwise, seen from the support
/// along the cable, shortens the cable.
enum class Thread { right, left };

/// Edges that are cut from one cable, and may share what is wrong with their lengths.
struct CableRun {
    std::string name;        ///< may be empty
    std::vector<int> edges;  ///< none in another run
};

/// The plain content of a net, before it is checked. Sizes: n nodes, m edges.
struct CableNetData {
    std::string name;                    ///< for people and files; may be empty
    Points nodes;                        ///< 3 x n, the nominal form [m]
    std::vector<int> supports;           ///< nodes on the rigid frame
    std::vector<Edge> edges;             ///< m pairs of nodes
    Eigen::VectorXd axial_stiffness;     ///< m, EA > 0; see CableNet::axial_stiffness() [N]
    Eigen::VectorXd unstressed_lengths;  ///< m, l_0 > 0 [m]
    /// Edges with a turnbuckle: length known and set. None means that no edge has one, and every
    /// length is uncertain; a net.json that does not tell them has edges_at_supports().
    std::vector<int> adjustable;
    Points loads;                          ///< 3 x n external forces [N]; 3 x 0 means none
    std::vector<std::string> node_ids;     ///< n names, or none
    std::vector<std::string> edge_ids;     ///< m names, or none
    std::vector<TensionLaw> tension_laws;  ///< of all edges that are not linear; or none
    std::vector<int> tension_law;          ///< m indices of tension_laws, -1: linear by EA; or none
    std::map<std::string, std::vector<int>> groups;  ///< named lists of edges
    Eigen::VectorXd mass;                            ///< m, of a metre of edge; or none [kg/m]
    Eigen::VectorXd expansion;      ///< m, thermal strain by temperature; or none [1/K]
    Eigen::VectorXd breaking_load;  ///< m, > 0; or none [N]
    std::vector<Thread> thread;     ///< one an entry of `adjustable`; or none
    std::vector<CableRun> runs;     ///< or none: cable_runs() finds them
};

/// The edges with at least one support as an end: CableNetData::adjustable of most nets.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<int> edges_at_supports(const std::vector<Edge>& edges,
                                                                  const std::vector<int>& supports);

/// A tensioned cable net: the graph G = (V, E) of the paper (section 3.1) with its parameters EA,
/// l_0 and r_B. Immutable, and valid by construction.
///
/// All that it gives by reference or pointer lives as long as the net, until that is assigned to.
/// A copy costs memory as CableNetData does. Functions and objects of taut copy what
/// they need of a net; what refers to it (Method, PlanRecord) says so.
class TAUT_CORE_EXPORT CableNet {
public:
    /// Checks every rule of a net.
    /// @throws NetError naming the place, the value and the rule: sizes that differ, an index out
    ///   of range or listed twice, a self-loop, a duplicate edge, an edge between two supports, a
    ///   free node without edges or in a part of the net without support, a stiffness or unstressed
    ///   length that is not positive and finite, an edge of zero length, a coordinate or load that
    ///   is not finite, no free node, names that are empty or doubled; a tension law that does not
    ///   start at (0, 0), falls, is flat at its start or end, or whose strains do not ascend; a
    ///   group without name or edges; a mass that is negative, an expansion that is not finite, a
    ///   breaking load that is not positive and finite, other than one thread an adjustable edge, a
    ///   run without edges or with one that another run has.
    explicit CableNet(CableNetData data);
    /// Nets are copied, not moved: what is left behind is a net still.
    CableNet(const CableNet&) = default;
    /// Likewise.
    CableNet& operator=(const CableNet&) = default;
    ~CableNet() = default;

    /// What it is called; may be empty.
    [[nodiscard]] const std::string& name() const { return m_data.name; }
    /// Nominal form, all nodes in the order of the data (3 x n) [m].
    [[nodiscard]] const Points& nodes() const { return m_data.nodes; }
    /// Both nodes of each edge, in the order of the data (m).
    [[nodiscard]] const std::vector<Edge>& edges() const { return m_data.edges; }
    /// EA; of an edge with a tension law the greatest slope of that, whatever the data told [N].
    [[nodiscard]] const Eigen::VectorXd& axial_stiffness() const { return m_data.axial_stiffness; }
    /// The law of an edge; null where its tension is linear, EA (l/l_0 - 1).
    /// @param edge 0 to edge_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] const TensionLaw* tension_law(int edge) const {
        check_index("edge", edge, m_data.edges.size());
        return m_data.tension_law.empty() || m_data.tension_law[edge] < 0
                   ? nullptr
                   : &m_data.tension_laws[m_data.tension_law[edge]];
    }
    /// Whether no edge has a tension law.
    [[nodiscard]] bool is_linear() const { return m_data.tension_law.empty(); }
    /// l_0 of all edges (m) [m].
    [[nodiscard]] const Eigen::VectorXd& unstressed_lengths() const {
        return m_data.unstressed_lengths;
    }
    /// 3 x n; those of the data and, where masses are given, the self-weight of the edges by their
    /// unstressed lengths, half of it at either end in -z. Other lengths that are solved for leave
    /// it as it is [N].
    [[nodiscard]] const Points& loads() const { return m_loads; }
    /// Everything that the net was made from, defaults filled in.
    [[nodiscard]] const CableNetData& data() const { return m_data; }

    /// n, supports included.
    [[nodiscard]] int node_count() const { return static_cast<int>(m_data.nodes.cols()); }
    /// m.
    [[nodiscard]] int edge_count() const { return static_cast<int>(m_data.edges.size()); }
    /// n_I, at least 1.
    [[nodiscard]] int free_node_count() const { return static_cast<int>(m_free_nodes.size()); }
    /// m_I; may be 0.
    [[nodiscard]] int interior_edge_count() const { return static_cast<int>(m_interior.size()); }

    /// Free nodes in ascending order: the order of the coordinates in r_I.
    [[nodiscard]] const std::vector<int>& free_nodes() const { return m_free_nodes; }
    /// Nodes on the rigid frame, in the order of the data.
    [[nodiscard]] const std::vector<int>& supports() const { return m_data.supports; }
    /// Position of a node in free_nodes(), or -1 for a support.
    /// @param node 0 to node_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] int free_index(int node) const {
        check_index("node", node, m_free_index.size());
        return m_free_index[node];
    }

    /// Edges of uncertain unstressed length, ascending: the order of l_0,I (eq. l0I).
    [[nodiscard]] const std::vector<int>& interior_edges() const { return m_interior; }
    /// Position of an edge in interior_edges(), or -1 for an adjustable one: the order of lengths
    /// in results and draws.
    /// @param edge 0 to edge_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] int interior_index(int edge) const;
    /// Edges whose unstressed length is known and set, ascending: the order of l_0,B.
    [[nodiscard]] const std::vector<int>& adjustable_edges() const { return m_data.adjustable; }

    /// The node's name, or its index as text where the net names no nodes.
    /// @param node 0 to node_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] std::string node_id(int node) const;
    /// The edge's name, or its index as text where the net names no edges.
    /// @param edge 0 to edge_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] std::string edge_id(int edge) const;

    /// 16 hexadecimal digits (FNV-1a) over nodes, supports, edges, EA, l_0, adjustable edges,
    /// loads, tension laws and masses: two nets with the same fingerprint behave alike, whatever
    /// their names.
    [[nodiscard]] const std::string& fingerprint() const { return m_fingerprint; }

private:
    static void check_index(const char* what, int index, std::size_t count) {
        if (index < 0 || static_cast<std::size_t>(index) >= count) {
            refuse_index(what, index, count);
        }
    }
    [[noreturn]] static void refuse_index(const char* what, int index, std::size_t count);

    CableNetData m_data;
    Points m_loads;
    std::vector<int> m_free_nodes;
    std::vector<int> m_free_index;
    std::vector<int> m_interior;
    std::string m_fingerprint;
};

/// Acceleration by gravity, standard value [m/s2].
inline constexpr double gravity = 9.80665;

/// r_I, the 3 n_I coordinates x1, y1, z1, x2, ... of the free nodes, out of all nodes' (3 x n) [m].
/// @throws std::invalid_argument for a wrong number of points
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd free_coordinates(
    const CableNet& net, const Eigen::Ref<const Points>& form);

/// All nodes' coordinates (3 x n) from r_I (3 n_I); supports from the net [m].
/// @throws std::invalid_argument for a wrong size
[[nodiscard]] TAUT_CORE_EXPORT Points
with_free_coordinates(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& coordinates);

/// l_0 of all edges (m) from the length deviations (m_I) of the interior ones (eq. data) [m].
/// @throws std::invalid_argument for a wrong size
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd with_length_deviations(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& deviations);

}  // namespace taut
