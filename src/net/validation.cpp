// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "net/validation.hpp"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "net/sliding_nodes.hpp"
#include "net/support_stiffness.hpp"
#include "net/union_find.hpp"

namespace taut {
namespace {

/// More than anything built has, in every SI unit, and small enough that no product in the energy,
/// EA l^2 / l_0, overflows.
constexpr double largest_magnitude = 1e15;

void check_entry_count(const std::string& field, Eigen::Index size, Eigen::Index expected,
                       const std::string& of_what) {
    if (size != expected) {
        throw NetError(
            field, {},
            fmt::format("has {} entries, expected {}, one for each {}", size, expected, of_what));
    }
}

void check_sizes(const CableNetData& data) {
    const Eigen::Index n = data.nodes.cols();
    const auto m = static_cast<Eigen::Index>(data.edges.size());
    if (n == 0) {
        throw NetError("nodes", {}, "is empty, expected at least two nodes");
    }
    if (m == 0) {
        throw NetError("edges", {}, "is empty, expected at least one edge");
    }
    check_entry_count("axial_stiffness", data.axial_stiffness.size(), m, "edge");
    check_entry_count("unstressed_lengths", data.unstressed_lengths.size(), m, "edge");
    check_entry_count("loads", data.loads.cols(), n, "node");
    if (!data.node_ids.empty()) {
        check_entry_count("node_ids", static_cast<Eigen::Index>(data.node_ids.size()), n, "node");
    }
    if (!data.edge_ids.empty()) {
        check_entry_count("edge_ids", static_cast<Eigen::Index>(data.edge_ids.size()), m, "edge");
    }
}

void check_finite(const std::string& field, const Points& points, double largest) {
    for (int i = 0; i < points.cols(); ++i) {
        for (int k = 0; k < 3; ++k) {
            if (!std::isfinite(points(k, i))) {
                throw NetError(field, {i, k},
                               fmt::format("is {}, expected a finite number", points(k, i)));
            }
            if (std::abs(points(k, i)) > largest) {
                throw NetError(
                    field, {i, k},
                    fmt::format("is {}, expected no more than {:g}", points(k, i), largest));
            }
        }
    }
}

void check_positive(const std::string& field, const Eigen::VectorXd& values) {
    for (int i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values(i)) || values(i) <= 0.0) {
            throw NetError(field, {i},
                           fmt::format("is {}, expected a positive and finite number", values(i)));
        }
        if (values(i) > largest_magnitude || values(i) < 1.0 / largest_magnitude) {
            throw NetError(field, {i},
                           fmt::format("is {}, expected a number from {:g} to {:g}", values(i),
                                       1.0 / largest_magnitude, largest_magnitude));
        }
    }
}

/// Checks that every index lies in [0, count) and is listed once.
/// @return whether each of 0 .. count - 1 is listed
std::vector<bool> check_indices(const std::string& field, const std::vector<int>& indices,
                                int count, const std::string& of_what) {
    std::vector<bool> listed(count, false);
    for (int i = 0; i < std::ssize(indices); ++i) {
        if (indices[i] < 0 || indices[i] >= count) {
            throw NetError(field, {i},
                           fmt::format("is {}, expected the index of one of the {} {}s", indices[i],
                                       count, of_what));
        }
        if (listed[indices[i]]) {
            throw NetError(field, {i},
                           fmt::format("lists {} {} a second time", of_what, indices[i]));
        }
        listed[indices[i]] = true;
    }
    return listed;
}

void check_edges(const CableNetData& data, const std::vector<bool>& is_support) {
    const auto n = static_cast<int>(data.nodes.cols());
    std::map<Edge, int> seen;
    for (int e = 0; e < std::ssize(data.edges); ++e) {
        const auto [s, t] = data.edges[e];
        for (const int node : {s, t}) {
            if (node < 0 || node >= n) {
                throw NetError("edges", {e},
                               fmt::format("names node {}, expected one of the {} nodes", node, n));
            }
        }
        if (s == t) {
            throw NetError("edges", {e}, fmt::format("connects node {} to itself", s));
        }
        if (is_support[s] && is_support[t]) {
            throw NetError("edges", {e},
                           fmt::format("connects the supports {} and {}; an edge needs at "
                                       "least one free node",
                                       s, t));
        }
        const auto [first, inserted] = seen.emplace(Edge{std::min(s, t), std::max(s, t)}, e);
        if (!inserted) {
            throw NetError("edges", {e},
                           fmt::format("connects nodes {} and {} as edge {} already does", s, t,
                                       first->second));
        }
        if (data.nodes.col(s) == data.nodes.col(t)) {
            throw NetError("edges", {e},
                           fmt::format("has zero length: nodes {} and {} are at the same "
                                       "place",
                                       s, t));
        }
    }
}

void check_elastic_supports(const CableNetData& data, std::vector<bool> is_support) {
    // A weaker direction would be lost in rounding errors of the strongest.
    constexpr double weakest_share = 1e-12;
    constexpr double largest_asymmetry = 1e-9;
    for (int i = 0; i < std::ssize(data.elastic_supports); ++i) {
        const auto& [node, stiffness, place] = data.elastic_supports[i];
        if (node < 0 || node >= std::ssize(is_support)) {
            throw NetError("elastic_supports", {i},
                           fmt::format("names node {}, expected one of the {} nodes", node,
                                       is_support.size()));
        }
        if (is_support[node]) {
            throw NetError("elastic_supports", {i},
                           fmt::format("names node {}, which is a support already", node));
        }
        is_support[node] = true;
        const double largest = stiffness.cwiseAbs().maxCoeff();
        if (!stiffness.allFinite() || largest > largest_magnitude) {
            throw NetError("elastic_supports", {i},
                           fmt::format("has a stiffness at node {} that is not finite or exceeds "
                                       "{:g}",
                                       node, largest_magnitude));
        }
        const Eigen::Matrix3d difference = stiffness - stiffness.transpose();
        const Eigen::Vector3d strengths =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(stiffness, Eigen::EigenvaluesOnly)
                .eigenvalues();
        if (difference.cwiseAbs().maxCoeff() > largest_asymmetry * largest ||
            !(strengths.minCoeff() > weakest_share * strengths.maxCoeff())) {
            throw NetError("elastic_supports", {i},
                           fmt::format("has a stiffness at node {} that is not symmetric and "
                                       "positive definite, expected one in every direction",
                                       node));
        }
        for (int k = 0; k < 3; ++k) {
            if (!std::isfinite(place(k)) || std::abs(place(k)) > largest_magnitude) {
                throw NetError("elastic_supports", {i},
                               fmt::format("has the place {} in {} at node {}, expected a finite "
                                           "number of no more than {:g}",
                                           place(k), "xyz"[k], node, largest_magnitude));
            }
        }
    }
}

/// Each a pair of its own, and the stiffness of all positive definite.
void check_support_couplings(const CableNetData& data) {
    const auto count = static_cast<int>(data.elastic_supports.size());
    std::set<std::pair<int, int>> seen;
    for (int i = 0; i < std::ssize(data.support_couplings); ++i) {
        const auto& [first, second, stiffness] = data.support_couplings[static_cast<size_t>(i)];
        if (first < 0 || second <= first || second >= count) {
            throw NetError("support_couplings", {i},
                           fmt::format("joins the elastic supports number {} and {}, expected two "
                                       "different ones of the {}, the first one first",
                                       first, second, count));
        }
        if (!seen.emplace(first, second).second) {
            throw NetError("support_couplings", {i},
                           fmt::format("joins the nodes {} and {} a second time",
                                       data.elastic_supports[static_cast<size_t>(first)].node,
                                       data.elastic_supports[static_cast<size_t>(second)].node));
        }
        if (!stiffness.allFinite() || stiffness.cwiseAbs().maxCoeff() > largest_magnitude) {
            throw NetError("support_couplings", {i},
                           fmt::format("has a stiffness that is not finite or exceeds {:g}",
                                       largest_magnitude));
        }
    }
    if (seen.empty()) {
        return;
    }
    const Eigen::SparseMatrix<double> matrix =
        support_stiffness_matrix(data.elastic_supports, data.support_couplings);
    // A weaker direction would be lost in rounding errors, here those of a frame program, too.
    constexpr double weakest_share = 1e-10;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    const Eigen::VectorXd diagonal = factor.permutationP() * Eigen::VectorXd(matrix.diagonal());
    if (factor.info() != Eigen::Success ||
        !(factor.vectorD().array() > weakest_share * diagonal.array()).all()) {
        throw NetError("support_couplings", {},
                       "make a stiffness of all elastic supports that is not positive definite: a "
                       "frame that is not founded, or couplings with another sign?");
    }
}

void check_connected(const CableNetData& data, const std::vector<bool>& is_support) {
    const auto n = static_cast<int>(is_support.size());
    UnionFind parts(n);
    std::vector<bool> has_edge(n, false);
    for (const auto& [s, t] : data.edges) {
        has_edge[s] = has_edge[t] = true;
        parts.join(s, t);
    }
    std::vector<bool> supported(n, false);
    for (const int support : data.supports) {
        supported[parts.root(support)] = true;
    }
    for (const ElasticSupport& support : data.elastic_supports) {
        supported[parts.root(support.node)] = true;
    }
    for (int i = 0; i < n; ++i) {
        if (is_support[i]) {
            continue;
        }
        if (!has_edge[i]) {
            throw NetError("nodes", {i}, "is a free node without edges");
        }
        if (!supported[parts.root(i)]) {
            throw NetError("nodes", {i},
                           "is a free node in a part of the net that reaches no support");
        }
    }
}

/// Names are written in lists with one name a line, and in lines of output: a line break would make
/// two of one. Readers stop at a zero byte.
bool has_line_break(const std::string& name) {
    return name.find_first_of(std::string_view("\r\n\0", 3)) != std::string::npos;
}

void check_ids(const std::string& field, const std::vector<std::string>& ids) {
    std::set<std::string_view> seen;
    for (int i = 0; i < std::ssize(ids); ++i) {
        if (has_line_break(ids[i])) {
            throw NetError(field, {i},
                           "holds a line break or a zero byte, expected a name of one line");
        }
        if (ids[i].empty()) {
            throw NetError(field, {i}, "is empty, expected a name");
        }
        if (!seen.insert(ids[i]).second) {
            throw NetError(field, {i}, fmt::format("gives the name '{}' a second time", ids[i]));
        }
    }
}

void check_groups(const CableNetData& data) {
    for (const auto& [name, edges] : data.groups) {
        if (has_line_break(name)) {
            throw NetError("groups", {},
                           "holds a name with a line break or a zero byte, expected one line");
        }
        if (name.empty()) {
            throw NetError("groups", {}, "holds a group without a name");
        }
        if (edges.empty()) {
            throw NetError("groups", {}, fmt::format("holds no edges in the group '{}'", name));
        }
        try {
            check_indices("groups", edges, static_cast<int>(data.edges.size()), "edge");
        } catch (const NetError& error) {
            throw NetError("groups", {},
                           fmt::format("'{}'[{}]: {}", name, error.index()[0], error.problem()));
        }
    }
}

void check_runs(const CableNetData& data) {
    constexpr double least_ratio = 0.01;
    std::vector<bool> taken(data.edges.size(), false);
    for (int k = 0; k < std::ssize(data.runs); ++k) {
        const auto& [name, edges, slides_at, friction, ratios] = data.runs[k];
        if (has_line_break(name)) {
            throw NetError("runs", {k},
                           "holds a name with a line break or a zero byte, expected one line");
        }
        if (edges.empty()) {
            throw NetError("runs", {k}, "holds no edges");
        }
        try {
            check_indices("runs", edges, static_cast<int>(data.edges.size()), "edge");
        } catch (const NetError& error) {
            throw NetError("runs", {k},
                           fmt::format("edges[{}]: {}", error.index()[0], error.problem()));
        }
        for (const int edge : edges) {
            if (taken[edge]) {
                throw NetError("runs", {k},
                               fmt::format("holds edge {}, which is in another run", edge));
            }
            taken[edge] = true;
        }
        if (const double given = friction.value_or(0.0); !(given >= 0.0 && given <= 10.0)) {
            throw NetError("runs", {k},
                           fmt::format("friction is {}, expected a number of 0 to 10", given));
        }
        if (slides_at.empty() && !ratios.empty()) {
            throw NetError("runs", {k}, "has ratios, but no slides_at that they are of");
        }
        if (slides_at.empty()) {
            continue;
        }
        for (const int edge : edges) {
            if (!data.kind.empty() && data.kind[edge] == EdgeKind::strut) {
                throw NetError("runs", {k},
                               fmt::format("slides, and holds edge {}, which is a strut", edge));
            }
        }
        try {
            check_indices("runs", slides_at, static_cast<int>(data.nodes.cols()), "node");
        } catch (const NetError& error) {
            throw NetError("runs", {k},
                           fmt::format("slides_at[{}]: {}", error.index()[0], error.problem()));
        }
        const std::vector<SlidingNode> sliding = sliding_nodes_of(data.edges, data.runs[k]);
        if (!ratios.empty() && ratios.size() != sliding.size()) {
            throw NetError("runs", {k},
                           fmt::format("has {} ratios, expected {}, one a node where it slides",
                                       ratios.size(), sliding.size()));
        }
        for (const double ratio : ratios) {
            if (!(ratio >= least_ratio && ratio <= 1.0 / least_ratio)) {
                throw NetError("runs", {k},
                               fmt::format("holds the ratio {}, expected one of {} to {}", ratio,
                                           least_ratio, 1.0 / least_ratio));
            }
        }
        for (size_t i = 0; i + 1 < sliding.size(); ++i) {
            if (sliding[i].after == sliding[i + 1].before &&
                sliding[i].node == sliding[i + 1].node) {
                throw NetError("runs", {k},
                               fmt::format("comes to node {} by edge {} and leaves it by the same, "
                                           "expected a path",
                                           sliding[i].node, sliding[i].after));
            }
        }
        for (size_t i = 0; i < slides_at.size(); ++i) {
            if (std::ranges::find(sliding, slides_at[i], &SlidingNode::node) == sliding.end()) {
                throw NetError(
                    "runs", {k},
                    fmt::format("slides_at[{}]: is {}, expected a node between two edges "
                                "of the run that follow each other in its list",
                                i, slides_at[i]));
            }
        }
    }
}

/// Checks a field with one number an edge, or none.
void check_rates(const std::string& field, const Eigen::VectorXd& values, size_t edges,
                 double least) {
    if (values.size() == 0) {
        return;
    }
    check_entry_count(field, values.size(), static_cast<Eigen::Index>(edges), "edge");
    for (int e = 0; e < values.size(); ++e) {
        if (!std::isfinite(values(e)) || values(e) < least ||
            std::abs(values(e)) > largest_magnitude) {
            throw NetError(field, {e},
                           fmt::format("is {}, expected a finite number{}", values(e),
                                       least == 0.0 ? " of at least 0" : ""));
        }
    }
}

void check_struts(const CableNetData& data) {
    if (!data.kind.empty()) {
        check_entry_count("kind", static_cast<Eigen::Index>(data.kind.size()),
                          static_cast<Eigen::Index>(data.edges.size()), "edge");
    }
    const auto is_strut = [&](int edge) {
        return !data.kind.empty() && data.kind[edge] == EdgeKind::strut;
    };
    for (int e = 0; e < std::ssize(data.tension_law); ++e) {
        if (is_strut(e) && data.tension_law[e] >= 0) {
            throw NetError("tension_law", {e},
                           "is that of a strut, expected none: struts are linear");
        }
    }
    if (data.buckling_load.size() == 0) {
        return;
    }
    check_entry_count("buckling_load", data.buckling_load.size(),
                      static_cast<Eigen::Index>(data.edges.size()), "edge");
    for (int e = 0; e < data.buckling_load.size(); ++e) {
        const double load = data.buckling_load(e);
        if (!(load >= 1.0 / largest_magnitude)) {
            throw NetError("buckling_load", {e},
                           fmt::format("is {}, expected a positive number", load));
        }
        if (std::isfinite(load) && (load > largest_magnitude || !is_strut(e))) {
            throw NetError("buckling_load", {e},
                           is_strut(e) ? fmt::format("is {}, expected no more than {:g}", load,
                                                     largest_magnitude)
                                       : "is that of a cable, which carries no compression");
        }
    }
}

void check_sags(const CableNetData& data) {
    check_rates("sag_weight", data.sag_weight, data.edges.size(), 0.0);
    for (int e = 0; e < data.sag_weight.size(); ++e) {
        const double weight = data.sag_weight(e) * data.unstressed_lengths(e);
        if (weight == 0.0) {
            continue;
        }
        if (!data.kind.empty() && data.kind[e] == EdgeKind::strut) {
            throw NetError("sag_weight", {e},
                           "is that of a strut, expected 0: struts are straight");
        }
        if (!data.tension_law.empty() && data.tension_law[e] >= 0) {
            throw NetError("sag_weight", {e},
                           "is that of an edge with a tension law, expected 0: cables that sag "
                           "are linear");
        }
        constexpr double most_strain = 0.1;
        if (weight > most_strain * data.axial_stiffness(e)) {
            throw NetError("sag_weight", {e},
                           fmt::format("is {}: the cable weighs {:.4g} N, expected no more than a "
                                       "tenth of its axial stiffness of {:.4g} N",
                                       data.sag_weight(e), weight, data.axial_stiffness(e)));
        }
    }
}

}  // namespace

void validate_tension_laws(const CableNetData& data) {
    for (int i = 0; i < std::ssize(data.tension_laws); ++i) {
        if (const std::string problem = problem_of(data.tension_laws[i]); !problem.empty()) {
            throw NetError("tension_laws", {i}, problem);
        }
        if (data.tension_laws[i].sags()) {
            throw NetError("tension_laws", {i},
                           "is that of a cable that sags, expected none: sag_weight makes it");
        }
    }
    if (data.tension_law.empty()) {
        return;
    }
    const auto count = static_cast<int>(data.tension_laws.size());
    check_entry_count("tension_law", static_cast<Eigen::Index>(data.tension_law.size()),
                      static_cast<Eigen::Index>(data.edges.size()), "edge");
    check_entry_count("axial_stiffness", data.axial_stiffness.size(),
                      static_cast<Eigen::Index>(data.edges.size()), "edge");
    for (int e = 0; e < std::ssize(data.tension_law); ++e) {
        if (const int law = data.tension_law[e]; law < -1 || law >= count) {
            throw NetError(
                "tension_law", {e},
                fmt::format("is {}, expected the index of one of the {} tension laws", law, count));
        }
    }
}

void validate(const CableNetData& data) {
    check_sizes(data);
    check_finite("nodes", data.nodes, largest_magnitude);
    check_finite("loads", data.loads, largest_magnitude);
    check_positive("axial_stiffness", data.axial_stiffness);
    check_positive("unstressed_lengths", data.unstressed_lengths);
    const auto is_support =
        check_indices("supports", data.supports, static_cast<int>(data.nodes.cols()), "node");
    if (std::ranges::all_of(is_support, std::identity())) {
        throw NetError("supports", {}, "holds every node, expected at least one free node");
    }
    check_edges(data, is_support);
    check_indices("adjustable", data.adjustable, static_cast<int>(data.edges.size()), "edge");
    check_elastic_supports(data, is_support);
    check_support_couplings(data);
    check_connected(data, is_support);
    if (has_line_break(data.name)) {
        throw NetError("name", {},
                       "holds a line break or a zero byte, expected a name of one line");
    }
    check_ids("node_ids", data.node_ids);
    check_ids("edge_ids", data.edge_ids);
    check_groups(data);
    check_runs(data);
    check_rates("mass", data.mass, data.edges.size(), 0.0);
    check_rates("bending_stiffness", data.bending_stiffness, data.edges.size(), 0.0);
    if (!data.cable_ends.empty()) {
        check_entry_count("cable_ends", static_cast<Eigen::Index>(data.cable_ends.size()),
                          static_cast<Eigen::Index>(data.edges.size()), "edge");
    }
    check_rates("expansion", data.expansion, data.edges.size(),
                std::numeric_limits<double>::lowest());
    if (data.breaking_load.size() > 0) {
        check_entry_count("breaking_load", data.breaking_load.size(),
                          static_cast<Eigen::Index>(data.edges.size()), "edge");
        check_positive("breaking_load", data.breaking_load);
    }
    check_struts(data);
    check_sags(data);
    if (!data.thread.empty()) {
        check_entry_count("thread", static_cast<Eigen::Index>(data.thread.size()),
                          static_cast<Eigen::Index>(data.adjustable.size()), "adjustable edge");
    }
}

}  // namespace taut
