// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/import_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// What two numbers for one force may differ by, of the mean force: files keep three digits or
/// more.
constexpr double agreement = 1e-2;

const ImportedEdge& edge_at(const ImportedStructure& structure, Eigen::Index e) {
    return structure.edges[e];
}

}  // namespace

void fail_at(const ImportedStructure& structure, const ImportedEdge& edge,
             const std::string& what) {
    throw InputError(structure.file, edge.place, fmt::format("edge {} {}", edge.id, what));
}

Eigen::VectorXd lengths_of(const ImportedStructure& structure) {
    Eigen::VectorXd lengths(static_cast<Eigen::Index>(structure.edges.size()));
    for (Eigen::Index e = 0; e < lengths.size(); ++e) {
        const ImportedEdge& edge = edge_at(structure, e);
        const ImportedNode& s = structure.nodes[edge.s];
        const ImportedNode& t = structure.nodes[edge.t];
        lengths(e) = (s.position - t.position).norm();
        if (!(std::isfinite(lengths(e)) && lengths(e) > 0.0)) {
            fail_at(
                structure, edge,
                fmt::format("has the length {} m, expected a positive and finite one", lengths(e)));
        }
    }
    return lengths;
}

std::optional<Eigen::VectorXd> numbers_of(const ImportedStructure& structure,
                                          std::initializer_list<const char*> names) {
    for (const char* name : names) {
        const auto has = [name](const ImportedEdge& edge) { return edge.numbers.contains(name); };
        if (std::ranges::none_of(structure.edges, has)) {
            continue;
        }
        Eigen::VectorXd values(static_cast<Eigen::Index>(structure.edges.size()));
        for (Eigen::Index e = 0; e < values.size(); ++e) {
            const ImportedEdge& edge = edge_at(structure, e);
            if (!has(edge)) {
                fail_at(structure, edge, fmt::format("has no {}, which other edges have", name));
            }
            values(e) = edge.numbers.at(name);
        }
        if ((values.array() != 0.0).any()) {
            return values;
        }
    }
    return std::nullopt;
}

ImportedForces forces_of(const ImportedStructure& structure, const Eigen::VectorXd& lengths,
                         std::vector<std::string>& warnings) {
    const auto q = numbers_of(structure, {"q"});
    const auto f = numbers_of(structure, {"f", "force"});
    if (!q && !f) {
        return {.force_densities = Eigen::VectorXd::Zero(lengths.size()), .source = ""};
    }
    if (!q) {
        const auto l = numbers_of(structure, {"l", "length"});
        const bool has_lengths = l && (l->array() > 0.0).all();
        return {.force_densities = f->cwiseQuotient(has_lengths ? *l : lengths), .source = "f"};
    }
    if (f) {
        Eigen::Index worst = 0;
        const double gap =
            (q->cwiseProduct(lengths) - *f).cwiseAbs().maxCoeff(&worst) / f->cwiseAbs().mean();
        if (gap > agreement) {
            warnings.push_back(fmt::format(
                "q and f contradict each other, most at edge {} (q l = {:.6g}, f = {:.6g}): q is "
                "taken",
                edge_at(structure, worst).id, (*q)(worst)*lengths(worst), (*f)(worst)));
        }
    }
    return {.force_densities = *q, .source = "q"};
}

}  // namespace taut
