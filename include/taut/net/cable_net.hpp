// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "taut/error.hpp"
#include "taut/export/core.hpp"
#include "taut/net/cable_ends.hpp"
#include "taut/net/tension_law.hpp"

namespace taut {

/// Coordinates of all nodes of a net, one column a node [m].
using Points = Eigen::Matrix3Xd;

/// The two nodes (s, t) that an edge connects.
using Edge = std::array<int, 2>;

/// A broken rule of a cable net, and its place in CableNetData. what() holds both:
/// "edges[3]: connects node 7 to itself".
class TAUT_CORE_EXPORT NetError : public std::invalid_argument, public Error {
public:
    [[nodiscard]] ErrorCode code() const noexcept override { return ErrorCode::net; }  ///< Error
    /// @param index entry, or entry and axis; empty: the field as a whole
    NetError(std::string field, std::vector<int> index, std::string problem);

    /// Field of CableNetData, for example "edges".
    [[nodiscard]] const std::string& field() const { return m_field; }
    /// The entry {3}, or entry and axis of a coordinate {4, 1}; empty if the field as a whole is
    /// wrong.
    [[nodiscard]] const std::vector<int>& index() const { return m_index; }
    /// What is wrong, and what was expected.
    [[nodiscard]] const std::string& problem() const { return m_problem; }

private:
    std::string m_field;
    std::vector<int> m_index;
    std::string m_problem;
};

/// Thread of a turnbuckle. With a right-hand thread, turning it clockwise, seen from the support
/// along the cable, shortens the cable.
enum class Thread { right, left };

/// What an edge carries: a cable tension alone, a strut tension and compression, EA (l/l_0 - 1).
enum class EdgeKind { cable, strut };

/// Edges cut from one cable: their length deviations may have a common part. The cable may run on
/// through clamps or saddles: then length passes from one edge to the next until the tensions on
/// both sides of a node are equal, or with friction differ by no more than (capstan),
/// docs/theory.md.
struct CableRun {
    std::string name;            ///< may be empty
    std::vector<int> edges;      ///< none in another run
    std::vector<int> slides_at;  ///< nodes between two edges of the run that follow each other
    /// Coefficient of friction there; empty: not known. Forms are then those without friction.
    std::optional<double> friction = {};
    /// Tension behind each of these nodes, along the cable, over that before it, in the middle of
    /// what friction leaves; empty: 1.
    std::vector<double> ratios = {};

    /// What identification and plans take for a friction that is not known: that of steel on a
    /// saddle with grease or PTFE.
    static constexpr double likely_friction = 0.05;
    /// By how much friction may be larger or smaller than that, or than given.
    static constexpr double uncertain_friction = 0.05;
};

/// A node that a run slides through.
struct SlidingNode {
    int node;              ///< index in the net
    int before;            ///< edge of the run that ends there
    int after;             ///< the next edge of the run
    double friction;       ///< coefficient of friction there
    double ratio;          ///< of the tensions behind and before it, in the middle
    double most_friction;  ///< largest that identification allows for
};

/// A support that gives way: a free node on a spring, which pulls it back with K (r_0 - r).
struct ElasticSupport {
    int node = -1;  ///< a free node
    /// K, symmetric and positive definite [N/m].
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< r_0, where it stands without load [m]
};

/// What two elastic supports on one frame pass on to each other: an off-diagonal block of the
/// frame's stiffness, condensed to its supports.
struct SupportCoupling {
    int first = 0;   ///< index in CableNetData::elastic_supports
    int second = 0;  ///< a later one
    /// Force on the first by a shift of the second [N/m].
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
};

/// The plain content of a net, before it is checked. Sizes: n nodes, m edges.
struct CableNetData {
    std::string name;                    ///< for people and files; may be empty
    Points nodes;                        ///< 3 x n, the nominal form [m]
    std::vector<int> supports;           ///< nodes on the rigid part of the frame
    std::vector<Edge> edges;             ///< m pairs of nodes
    Eigen::VectorXd axial_stiffness;     ///< m, EA > 0; see CableNet::axial_stiffness() [N]
    Eigen::VectorXd unstressed_lengths;  ///< m, l_0 > 0 [m]
    /// Edges with a turnbuckle, whose length is known and set. If empty, no edge has one and every
    /// length is uncertain. A net.json without this list gets edges_at_supports().
    std::vector<int> adjustable;
    Points loads;                          ///< 3 x n external forces [N]; 3 x 0 means none
    std::vector<std::string> node_ids;     ///< n names, or none
    std::vector<std::string> edge_ids;     ///< m names, or none
    std::vector<TensionLaw> tension_laws;  ///< of all edges that are not linear; or none
    std::vector<int> tension_law;          ///< m indices of tension_laws, -1: linear by EA; or none
    std::map<std::string, std::vector<int>> groups;  ///< named lists of edges
    Eigen::VectorXd mass;                            ///< m, per length; or none [kg/m]
    Eigen::VectorXd expansion;          ///< m, thermal expansion coefficient; or none [1/K]
    Eigen::VectorXd breaking_load;      ///< m, > 0; or none [N]
    Eigen::VectorXd bending_stiffness;  ///< m, EI, for frequencies only; or none [N m2]
    std::vector<CableEnds> cable_ends;  ///< m, for frequencies only; or none: all unknown
    std::vector<Thread> thread;         ///< one for each entry of `adjustable`; or none
    std::vector<CableRun> runs;         ///< or none: cable_runs() finds them
    std::vector<ElasticSupport> elastic_supports;  ///< none of them in `supports`; or none
    /// Each pair once; or none. The stiffness of all elastic supports is positive definite.
    std::vector<SupportCoupling> support_couplings;
    std::vector<EdgeKind> kind;  ///< m; or none: all are cables
    /// m, the compression at which a strut buckles, > 0; infinite: not known, as of all cables; or
    /// none [N].
    Eigen::VectorXd buckling_load;
    /// m, weight per length across the chord that makes a cable sag between its nodes; 0: the cable
    /// is straight; or none. sag_weights_by_mass() gives that of the masses [N/m].
    Eigen::VectorXd sag_weight;
};

/// CableNetData::sag_weight of the own weight of each edge: its part across the chord in the form
/// of the data, 0 for struts and edges with a tension law (m) [N/m].
/// @param data with all sizes right
/// @throws std::invalid_argument if it has no masses
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd sag_weights_by_mass(const CableNetData& data);
/// The same weight for all edges but struts and those with a tension law (m) [N/m].
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd equal_sag_weights(const CableNetData& data,
                                                                 double weight);

/// The edges with a support at one end at least: CableNetData::adjustable of most nets.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<int> edges_at_supports(const std::vector<Edge>& edges,
                                                                  const std::vector<int>& supports);

/// A tensioned cable net: the graph G = (V, E) of the paper (section 3.1) with its parameters EA,
/// l_0 and r_B. Immutable, and valid by construction.
///
/// References, spans and pointers that it returns are valid until the net is destroyed or assigned
/// to. Functions and objects of taut copy what they need of a net; those that refer to it
/// (PlanRecord) say so.
class TAUT_CORE_EXPORT CableNet {
public:
    /// Checks every rule of a net.
    /// @throws NetError with the place, the value and the rule: sizes that differ, an index out
    ///   of range or listed twice, a self-loop, a duplicate edge, an edge between two supports, a
    ///   free node without edges or in a part of the net without support, a stiffness or unstressed
    ///   length that is not positive and finite, an edge of zero length, a coordinate or load that
    ///   is not finite, no free node, names that are empty or doubled; a tension law that does not
    ///   start at (0, 0), falls, is flat at its start or end, or whose strains do not ascend; a
    ///   group without name or edges; a mass or bending stiffness that is negative, an expansion
    ///   that is not finite, a breaking load that is not positive and finite, a number of threads
    ///   other than that of the adjustable edges, a run without edges or with one that another run
    ///   has, a run that slides at a node where no two of its edges follow each other, with a
    ///   strut, or with a friction that is not 0 to 10, an elastic support that is no free node or
    ///   whose stiffness is not symmetric and positive definite, a coupling of other than two of
    ///   them, one given twice, or couplings with which the whole is not, a strut with a tension
    ///   law, a buckling load that is not positive or is that of a cable, a sag weight that is
    ///   negative or that of a strut or of an edge with a tension law.
    explicit CableNet(CableNetData data);
    /// Nets are copied, not moved, so that the source stays a valid net.
    CableNet(const CableNet&) = default;
    /// Likewise.
    CableNet& operator=(const CableNet&) = default;
    ~CableNet() = default;

    /// May be empty.
    [[nodiscard]] const std::string& name() const { return m_data.name; }
    /// Nominal form, all nodes in the order of the data (3 x n) [m].
    [[nodiscard]] const Points& nodes() const { return m_data.nodes; }
    /// Both nodes of each edge, in the order of the data (m).
    [[nodiscard]] const std::vector<Edge>& edges() const { return m_data.edges; }
    /// EA; for an edge with a tension law the greatest slope of the law, whatever the data holds
    /// [N].
    [[nodiscard]] const Eigen::VectorXd& axial_stiffness() const { return m_data.axial_stiffness; }
    /// The tension law of an edge, that of a cable that sags among them; null if its tension is
    /// linear, EA (l/l_0 - 1).
    /// @param edge 0 to edge_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] const TensionLaw* tension_law(int edge) const {
        check_index("edge", edge, m_data.edges.size());
        if (sags() && m_sag_laws[edge].sags()) {
            return &m_sag_laws[edge];
        }
        return m_data.tension_law.empty() || m_data.tension_law[edge] < 0
                   ? nullptr
                   : &m_data.tension_laws[m_data.tension_law[edge]];
    }
    /// Whether an edge carries compression, too.
    /// @param edge 0 to edge_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] bool is_strut(int edge) const {
        check_index("edge", edge, m_data.edges.size());
        return has_struts() && m_data.kind[edge] == EdgeKind::strut;
    }
    /// Whether any edge is a strut. The energy is not convex then: there may be several forms, or
    /// none that is stable.
    [[nodiscard]] bool has_struts() const { return !m_data.kind.empty(); }
    /// The piecewise linear law of an edge; null if it has none.
    /// @param edge 0 to edge_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] const TensionLaw* bent_law(int edge) const {
        const TensionLaw* law = tension_law(edge);
        return law == nullptr || law->sags() ? nullptr : law;
    }
    /// Whether any cable sags between its nodes: then it is never slack.
    [[nodiscard]] bool sags() const { return !m_sag_laws.empty(); }
    /// Whether an edge carries nothing where it is longer than the distance of its nodes: a cable
    /// that does not sag.
    /// @param edge 0 to edge_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] bool can_be_slack(int edge) const {
        check_index("edge", edge, m_data.edges.size());
        return !is_strut(edge) && !(sags() && m_sag_laws[edge].sags());
    }
    /// Whether no edge has a tension law, apart from cables that sag.
    [[nodiscard]] bool is_linear() const { return m_data.tension_law.empty(); }
    /// Where runs slide, run by run in the order of their edges. The unstressed lengths of the net
    /// are those before anything slides, as marked on the cable.
    [[nodiscard]] const std::vector<SlidingNode>& sliding_nodes() const { return m_sliding; }
    /// l_0 of all edges (m) [m].
    [[nodiscard]] const Eigen::VectorXd& unstressed_lengths() const {
        return m_data.unstressed_lengths;
    }
    /// 3 x n; the loads of the data plus the self-weight of edges with a mass. The weight follows
    /// from the net's unstressed lengths and acts in -z, half of it at either end. It does not
    /// change if an equilibrium is solved with other lengths [N].
    [[nodiscard]] const Points& loads() const { return m_loads; }
    /// The data that the net was made from, defaults filled in.
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
    /// Free nodes on springs, in the order of the data.
    [[nodiscard]] const std::vector<ElasticSupport>& elastic_supports() const {
        return m_data.elastic_supports;
    }
    /// Pairs of elastic supports on one frame.
    [[nodiscard]] const std::vector<SupportCoupling>& support_couplings() const {
        return m_data.support_couplings;
    }
    /// Those on the rigid frame, then the elastic ones.
    [[nodiscard]] std::vector<int> all_supports() const;
    /// Places of all_supports(), of the elastic ones without load (3 x count) [m].
    [[nodiscard]] Points support_places() const;
    /// Whether a node is one of all_supports().
    /// @param node 0 to node_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] bool is_support(int node) const;
    /// Position of a node in free_nodes(), or -1 for a support on the rigid frame.
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

    /// Edges at a node, ascending.
    /// @param node 0 to node_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] std::span<const int> edges_at(int node) const;
    /// Nodes that share an edge with a node, in the order of edges_at().
    /// @param node 0 to node_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] std::span<const int> neighbours(int node) const;

    /// The node's name, or its index as text if the net names no nodes.
    /// @param node 0 to node_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] std::string node_id(int node) const;
    /// The node with node_id(node) == id, or -1.
    [[nodiscard]] int find_node(std::string_view id) const;
    /// The edge's name, or its index as text if the net names no edges.
    /// @param edge 0 to edge_count() - 1
    /// @throws std::out_of_range for another
    [[nodiscard]] std::string edge_id(int edge) const;
    /// The edge with edge_id(edge) == id, or -1.
    [[nodiscard]] int find_edge(std::string_view id) const;

    /// 16 hexadecimal digits (FNV-1a) over nodes, supports, edges, EA, l_0, adjustable edges,
    /// loads, tension laws, masses, elastic supports, struts, sags and sliding nodes. Nets with the
    /// same fingerprint have the same statics, whatever their names.
    [[nodiscard]] const std::string& fingerprint() const { return m_fingerprint; }

private:
    static void check_index(const char* what, int index, std::size_t count) {
        if (index < 0 || static_cast<std::size_t>(index) >= count) {
            refuse_index(what, index, count);
        }
    }
    [[noreturn]] static void refuse_index(const char* what, int index, std::size_t count);
    void list_edges_at_nodes();

    CableNetData m_data;
    Points m_loads;
    std::vector<int> m_free_nodes;
    std::vector<int> m_free_index;
    std::vector<int> m_interior;
    std::vector<TensionLaw> m_sag_laws;  ///< m; empty if no cable sags
    std::vector<SlidingNode> m_sliding;
    std::vector<int> m_starts;         ///< of each node in the next two; one more at the end
    std::vector<int> m_edges_at;       ///< node by node
    std::vector<int> m_neighbours;     ///< the other end of each of these edges
    std::vector<int> m_nodes_by_name;  ///< sorted by node_ids; empty if these are
    std::vector<int> m_edges_by_name;
    std::string m_fingerprint;
};

/// Standard acceleration of gravity [m/s2].
inline constexpr double gravity = 9.80665;

/// r_I, the 3 n_I coordinates x1, y1, z1, x2, ... of the free nodes, out of all nodes' (3 x n) [m].
/// @throws std::invalid_argument for a wrong number of points
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd free_coordinates(
    const CableNet& net, const Eigen::Ref<const Points>& form);

/// Coordinates of all nodes (3 x n) from r_I (3 n_I); supports from the net [m].
/// @throws std::invalid_argument for a wrong size
[[nodiscard]] TAUT_CORE_EXPORT Points
with_free_coordinates(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& coordinates);

/// l_0 of all edges (m) from the length deviations (m_I) of the interior ones (eq. data) [m].
/// @throws std::invalid_argument for a wrong size
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd with_length_deviations(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& deviations);

}  // namespace taut
