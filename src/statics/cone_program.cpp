// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/cone_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "statics/arguments.hpp"
#include "statics/conic_solver.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/imbalance.hpp"

namespace taut {
namespace {

/// Units in which the numbers of the program are of order one.
struct Units {
    double length;  ///< [m]
    double force;   ///< [N]
};

Units units_for(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths) {
    double force = imbalance_of(net, unstressed_lengths, net.nodes()).mean_tension;
    if (force == 0.0) {
        force = net.loads().colwise().norm().mean();
    }
    if (force == 0.0) {
        force = net.axial_stiffness().mean();
    }
    return {.length = unstressed_lengths.mean(), .force = force};
}

/// A straight part of an edge's law in units of the program: over its width the tension grows from
/// T_0 with stiffness c. The extension of an edge is the sum over its parts. Since the tension
/// never falls, the least energy fills them in their order.
struct Part {
    int edge;
    double tension;  ///< T_0 at its start
    double axial;    ///< c; 0 if the law is flat
    double width;    ///< infinite for the last one
    /// Scale of the variable: sqrt(c), so that its square is twice the energy stored by c.
    [[nodiscard]] double scale() const { return axial > 0.0 ? std::sqrt(axial) : 1.0; }
};

std::vector<Part> parts_of(const CableNet& net,
                           const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                           const Units& units) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Part> parts;
    for (int e = 0; e < net.edge_count(); ++e) {
        const double unstressed = unstressed_lengths(e);
        const TensionLaw* law = net.tension_law(e);
        if (law == nullptr) {
            const double axial = net.axial_stiffness()(e) / unstressed;
            parts.push_back({e, 0.0, axial * units.length / units.force, infinity});
            continue;
        }
        const Eigen::Index last = law->strain.size() - 2;
        for (Eigen::Index k = 0; k <= last; ++k) {
            const double width = (law->strain(k + 1) - law->strain(k)) * unstressed / units.length;
            const double rise = (law->tension(k + 1) - law->tension(k)) / units.force;
            parts.push_back(
                {e, law->tension(k) / units.force, rise / width, k == last ? infinity : width});
        }
    }
    return parts;
}

/// The program of one net. Variables: displacements x of the free nodes from the net's nodes
/// (3 n_I), w (one a part of an edge's law), and in the paper's form v. Rows: w >= 0; w at most the
/// width of its part, if that is finite; for each edge the cone (l_0 + sum w / sqrt(c), r_s -
/// r_t) with c = EA/l_0 of each part (4 each); in the paper's form the cone (1 + v, 2w, 1 - v).
class Assembly {
public:
    Assembly(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
             Units units, ConeForm form)
        : m_net(net),
          m_unstressed_lengths(unstressed_lengths),
          m_units(units),
          m_parts(parts_of(net, unstressed_lengths, units)),
          m_coordinates(3 * net.free_node_count()),
          m_edges(net.edge_count()) {
        add_objective(form);
        add_bounds();
        m_first_cone = m_rows;
        add_edge_cones();
        if (form == ConeForm::paper) {
            add_large_cone();
        }
        m_program.b = Eigen::Map<const Eigen::VectorXd>(m_b.data(), m_rows);
        m_program.A.resize(m_program.b.size(), m_program.q.size());
        m_program.A.setFromTriplets(m_entries.begin(), m_entries.end());
    }

    [[nodiscard]] const ConicProgram& program() const { return m_program; }
    /// First entry in z of the multiplier of r_s - r_t of an edge.
    [[nodiscard]] int vector_row(int edge) const { return m_first_cone + 4 * edge + 1; }

private:
    [[nodiscard]] int part_count() const { return static_cast<int>(m_parts.size()); }

    void add_objective(ConeForm form) {
        const int variables = m_coordinates + part_count() + (form == ConeForm::paper ? 1 : 0);
        m_program.q.setZero(variables);
        for (int i = 0; i < m_net.free_node_count(); ++i) {
            const int node = m_net.free_nodes()[i];
            m_program.q.segment<3>(Eigen::Index{3} * i) = -m_net.loads().col(node) / m_units.force;
        }
        m_program.P.resize(variables, variables);
        for (int k = 0; k < part_count(); ++k) {
            const Part& part = m_parts[k];
            m_program.q(m_coordinates + k) = part.tension / part.scale();
            if (form == ConeForm::quadratic && part.axial > 0.0) {
                m_program.P.insert(m_coordinates + k, m_coordinates + k) = 1.0;
            }
        }
        if (form == ConeForm::paper) {
            m_program.q(variables - 1) = 0.5;
        }
        const double unit = m_units.length / m_units.force;
        const Points springs = elastic_forces(m_net, m_net.nodes());
        for (const auto& [node, stiffness, place] : m_net.elastic_supports()) {
            const int first = 3 * m_net.free_index(node);
            m_program.q.segment<3>(first) += springs.col(node) / m_units.force;
            for (int j = 0; j < 3; ++j) {
                for (int i = 0; i <= j; ++i) {
                    m_program.P.insert(first + i, first + j) = unit * stiffness(i, j);
                }
            }
        }
        for (const auto& [one, other, stiffness] : m_net.support_couplings()) {
            const int a = 3 * m_net.free_index(m_net.elastic_supports()[one].node);
            const int b = 3 * m_net.free_index(m_net.elastic_supports()[other].node);
            for (int j = 0; j < 3; ++j) {
                for (int i = 0; i < 3; ++i) {  // of the upper triangle
                    m_program.P.insert(std::min(a + i, b + j), std::max(a + i, b + j)) =
                        unit * stiffness(i, j);
                }
            }
        }
        m_program.P.makeCompressed();
    }

    void add_bounds() {
        const int row = add_cone(Cone::Kind::nonnegative, part_count());
        for (int k = 0; k < part_count(); ++k) {
            m_entries.emplace_back(row + k, m_coordinates + k, -1.0);
        }
        std::vector<int> bounded;
        for (int k = 0; k < part_count(); ++k) {
            if (std::isfinite(m_parts[k].width)) {
                bounded.push_back(k);
            }
        }
        if (bounded.empty()) {
            return;
        }
        int next = add_cone(Cone::Kind::nonnegative, static_cast<int>(bounded.size()));
        for (const int k : bounded) {
            m_b[next] = m_parts[k].width * m_parts[k].scale();
            m_entries.emplace_back(next++, m_coordinates + k, 1.0);
        }
    }

    void add_edge_cones() {
        for (int e = 0; e < m_edges; ++e) {
            const int row = add_cone(Cone::Kind::second_order, 4);
            m_b[row] = m_unstressed_lengths(e) / m_units.length;
            const auto [s, t] = m_net.edges()[e];
            for (int k = 0; k < 3; ++k) {
                m_b[row + 1 + k] = (m_net.nodes()(k, s) - m_net.nodes()(k, t)) / m_units.length;
                if (const int i = m_net.free_index(s); i >= 0) {
                    m_entries.emplace_back(row + 1 + k, 3 * i + k, -1.0);
                }
                if (const int j = m_net.free_index(t); j >= 0) {
                    m_entries.emplace_back(row + 1 + k, 3 * j + k, 1.0);
                }
            }
        }
        for (int k = 0; k < part_count(); ++k) {
            m_entries.emplace_back(m_first_cone + 4 * m_parts[k].edge, m_coordinates + k,
                                   -1.0 / m_parts[k].scale());
        }
    }

    /// v >= w'w, over the parts that store energy.
    void add_large_cone() {
        std::vector<int> storing;
        for (int k = 0; k < part_count(); ++k) {
            if (m_parts[k].axial > 0.0) {
                storing.push_back(k);
            }
        }
        const auto count = static_cast<int>(storing.size());
        const int row = add_cone(Cone::Kind::second_order, count + 2);
        const int v = m_coordinates + part_count();
        m_b[row] = 1.0;
        m_entries.emplace_back(row, v, -1.0);
        for (int i = 0; i < count; ++i) {
            m_entries.emplace_back(row + 1 + i, m_coordinates + storing[i], -2.0);
        }
        m_b[row + 1 + count] = 1.0;
        m_entries.emplace_back(row + 1 + count, v, 1.0);
    }

    /// Takes the next rows for a cone and returns the first.
    int add_cone(Cone::Kind kind, int dimension) {
        const int row = m_rows;
        m_rows += dimension;
        m_b.resize(m_rows, 0.0);
        m_program.cones.push_back({.kind = kind, .dimension = dimension});
        return row;
    }

    const CableNet& m_net;
    Eigen::Ref<const Eigen::VectorXd> m_unstressed_lengths;
    Units m_units;
    std::vector<Part> m_parts;
    int m_coordinates;
    int m_edges;
    int m_rows = 0;  ///< taken so far
    int m_first_cone = 0;
    std::vector<double> m_b;
    ConicProgram m_program;
    std::vector<Eigen::Triplet<double>> m_entries;
};

}  // namespace

std::string_view to_string(ConeForm form) {
    return form == ConeForm::paper ? "paper" : "quadratic";
}

std::string_view to_string(ConeStatus status) {
    switch (status) {
        case ConeStatus::solved:
            return "solved";
        case ConeStatus::almost_solved:
            return "almost solved";
        case ConeStatus::infeasible:
            return "infeasible";
        case ConeStatus::iteration_limit:
            return "iteration limit";
        case ConeStatus::numerical_error:
            return "numerical error";
    }
    return "unknown";
}

ConeSolution solve_cone_program(const CableNet& net,
                                const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                ConeProgramSettings settings) {
    check_unstressed_lengths(net.edge_count(), unstressed_lengths);
    if (net.has_struts()) {
        throw std::invalid_argument("net has struts: its energy is not convex, no cone program");
    }
    if (net.sags()) {
        throw std::invalid_argument("net has cables that sag: their energy fits no cone program");
    }
    if (!net.sliding_nodes().empty()) {
        throw std::invalid_argument("net has runs that slide: they fit no cone program");
    }
    const Units units = units_for(net, unstressed_lengths);
    const Assembly assembly(net, unstressed_lengths, units, settings.form);
    const ConicSolution found = solve_conic(assembly.program(), settings.max_iterations);

    ConeSolution result{.form = net.nodes(),
                        .edge_forces = Points(3, net.edge_count()),
                        .status = found.status,
                        .iterations = found.iterations,
                        .primal_residual = found.primal_residual,
                        .dual_residual = found.dual_residual};
    // Of loads and springs up to the net's nodes, where the program's coordinates start.
    double work = 0.0;
    for (int i = 0; i < net.free_node_count(); ++i) {
        const int node = net.free_nodes()[i];
        work += net.loads().col(node).dot(net.nodes().col(node));
        result.form.col(node) += units.length * found.x.segment<3>(Eigen::Index{3} * i);
    }
    const Points springs = elastic_forces(net, net.nodes());
    for (const auto& [node, stiffness, place] : net.elastic_supports()) {
        work -= 0.5 * springs.col(node).dot(net.nodes().col(node) - place);
    }
    const double joule = units.force * units.length;
    result.primal_objective = joule * found.primal_objective - work;
    result.dual_objective = joule * found.dual_objective - work;
    // Stationarity in x: the multipliers of r_s - r_t, summed at a node, are its load's negative.
    for (int e = 0; e < net.edge_count(); ++e) {
        result.edge_forces.col(e) = -units.force * found.z.segment<3>(assembly.vector_row(e));
    }
    return result;
}

}  // namespace taut
