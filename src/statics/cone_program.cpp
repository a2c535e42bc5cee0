// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/cone_program.hpp"

#include <cmath>

#include "statics/arguments.hpp"
#include "statics/conic_solver.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Units in which the numbers of the program are of order one.
struct Units {
    double length;  ///< [m]
    double force;   ///< [N]
};

Units units_for(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths) {
    const Eigen::VectorXd tension = tensions(net, unstressed_lengths, net.nodes());
    const auto taut_count = (tension.array() > 0.0).count();
    double force = taut_count > 0 ? tension.sum() / static_cast<double>(taut_count)
                                  : net.loads().colwise().norm().mean();
    if (force == 0.0) {
        force = net.axial_stiffness().mean();
    }
    return {.length = unstressed_lengths.mean(), .force = force};
}

/// The program of one net. Variables: displacements x of the free nodes from the net's nodes
/// (3 n_I), w (m), and in the paper's form v. Rows: w >= 0 (m); for each edge the cone
/// (l_0 + w / sqrt(c), r_s - r_t) with c = EA/l_0 (4 each); in the paper's form the cone
/// (1 + v, 2w, 1 - v).
class Assembly {
public:
    Assembly(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
             Units units, ConeForm form)
        : m_net(net),
          m_unstressed_lengths(unstressed_lengths),
          m_units(units),
          m_coordinates(3 * net.free_node_count()),
          m_edges(net.edge_count()) {
        m_program.b.setZero(5 * m_edges + (form == ConeForm::paper ? m_edges + 2 : 0));
        add_objective(form);
        add_nonnegative();
        for (int e = 0; e < m_edges; ++e) {
            add_edge_cone(e);
        }
        if (form == ConeForm::paper) {
            add_large_cone();
        }
        m_program.A.resize(m_program.b.size(), m_program.q.size());
        m_program.A.setFromTriplets(m_entries.begin(), m_entries.end());
    }

    [[nodiscard]] const ConicProgram& program() const { return m_program; }
    /// Where the multiplier of r_s - r_t of an edge stands in z.
    [[nodiscard]] int vector_row(int edge) const { return m_edges + 4 * edge + 1; }

private:
    void add_objective(ConeForm form) {
        const int variables = m_coordinates + m_edges + (form == ConeForm::paper ? 1 : 0);
        m_program.q.setZero(variables);
        for (int i = 0; i < m_net.free_node_count(); ++i) {
            const int node = m_net.free_nodes()[i];
            m_program.q.segment<3>(Eigen::Index{3} * i) = -m_net.loads().col(node) / m_units.force;
        }
        m_program.P.resize(variables, variables);
        if (form == ConeForm::paper) {
            m_program.q(variables - 1) = 0.5;
            return;
        }
        for (int e = 0; e < m_edges; ++e) {
            m_program.P.insert(m_coordinates + e, m_coordinates + e) = 1.0;
        }
        m_program.P.makeCompressed();
    }

    void add_nonnegative() {
        add_cone(Cone::Kind::nonnegative, m_edges);
        for (int e = 0; e < m_edges; ++e) {
            m_entries.emplace_back(e, m_coordinates + e, -1.0);
        }
    }

    void add_edge_cone(int e) {
        const int row = add_cone(Cone::Kind::second_order, 4);
        const double unstressed = m_unstressed_lengths(e);
        const double axial =
            m_net.axial_stiffness()(e) / unstressed * m_units.length / m_units.force;
        m_program.b(row) = unstressed / m_units.length;
        m_entries.emplace_back(row, m_coordinates + e, -1.0 / std::sqrt(axial));
        const auto [s, t] = m_net.edges()[e];
        m_program.b.segment<3>(row + 1) =
            (m_net.nodes().col(s) - m_net.nodes().col(t)) / m_units.length;
        for (int k = 0; k < 3; ++k) {
            if (const int i = m_net.free_index(s); i >= 0) {
                m_entries.emplace_back(row + 1 + k, 3 * i + k, -1.0);
            }
            if (const int j = m_net.free_index(t); j >= 0) {
                m_entries.emplace_back(row + 1 + k, 3 * j + k, 1.0);
            }
        }
    }

    void add_large_cone() {
        const int row = add_cone(Cone::Kind::second_order, m_edges + 2);
        const int v = m_coordinates + m_edges;
        m_program.b(row) = 1.0;
        m_entries.emplace_back(row, v, -1.0);
        for (int e = 0; e < m_edges; ++e) {
            m_entries.emplace_back(row + 1 + e, m_coordinates + e, -2.0);
        }
        m_program.b(row + 1 + m_edges) = 1.0;
        m_entries.emplace_back(row + 1 + m_edges, v, 1.0);
    }

    /// Takes the next rows for a cone and returns the first.
    int add_cone(Cone::Kind kind, int dimension) {
        const int row = m_rows;
        m_rows += dimension;
        m_program.cones.push_back({.kind = kind, .dimension = dimension});
        return row;
    }

    const CableNet& m_net;
    Eigen::Ref<const Eigen::VectorXd> m_unstressed_lengths;
    Units m_units;
    int m_coordinates;
    int m_edges;
    int m_rows = 0;  ///< taken so far
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
    const Units units = units_for(net, unstressed_lengths);
    const Assembly assembly(net, unstressed_lengths, units, settings.form);
    const ConicSolution found = solve_conic(assembly.program(), settings.max_iterations);

    ConeSolution result{.form = net.nodes(),
                        .edge_forces = Points(3, net.edge_count()),
                        .status = found.status,
                        .iterations = found.iterations,
                        .primal_residual = found.primal_residual,
                        .dual_residual = found.dual_residual};
    double work = 0.0;  // of the loads, up to the net's nodes: the program counts from there
    for (int i = 0; i < net.free_node_count(); ++i) {
        const int node = net.free_nodes()[i];
        work += net.loads().col(node).dot(net.nodes().col(node));
        result.form.col(node) += units.length * found.x.segment<3>(Eigen::Index{3} * i);
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
