// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/settling_nets.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "taut/design/builtin_nets.hpp"
#include "taut/design/force_density.hpp"
#include "taut/design/unstressed_lengths.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

void check_positive(double value, const char* name) {
    if (!(value > 0.0) || !std::isfinite(value)) {
        throw std::invalid_argument(
            fmt::format("{} is {}, expected a positive number", name, value));
    }
}

CableNet named(const CableNet& net, std::string name) {
    CableNetData data = net.data();
    data.name = std::move(name);
    return CableNet(std::move(data));
}

}  // namespace

CableNet with_strains(const CableNet& net, double stiffness_factor, double tension_factor) {
    check_positive(stiffness_factor, "the factor of the stiffness");
    check_positive(tension_factor, "the factor of the tensions");
    CableNetData data = net.data();
    const Eigen::VectorXd lengths = edge_lengths(net, net.nodes());
    const Eigen::VectorXd before = tensions(net, net.unstressed_lengths(), net.nodes());
    data.axial_stiffness *= stiffness_factor;
    data.unstressed_lengths =
        unstressed_lengths_for(lengths, tension_factor * before, data.axial_stiffness);
    return CableNet(std::move(data));
}

CableNet hanging_net(int rows, int columns, double force_density, double weight) {
    check_positive(force_density, "the force density");
    check_positive(weight, "the weight of a node");
    const CableNet lattice = hypar(rows, columns);
    CableNetData data = lattice.data();
    data.name = fmt::format("hanging:{}x{}", rows, columns);
    data.nodes.row(2).setZero();
    data.loads = Points::Zero(3, data.nodes.cols());
    for (const int node : lattice.free_nodes()) {
        data.loads(2, node) = -weight;
    }
    const Eigen::VectorXd densities =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(data.edges.size()), force_density);
    data.nodes =
        form_from_force_densities(data.nodes, data.supports, data.edges, densities, data.loads);
    const Eigen::VectorXd lengths = edge_lengths(lattice, data.nodes);
    data.unstressed_lengths =
        unstressed_lengths_for(lengths, densities.cwiseProduct(lengths), data.axial_stiffness);
    return CableNet(std::move(data));
}

std::vector<CableNet> settling_nets() {
    constexpr double hanging_density = 600.0;  // N/m: sags by a sixth of its span
    constexpr double hanging_weight = 20.0;    // N
    const CableNet roof = hilo_quarter();
    const CableNet middle = hypar(9, 9);
    const CableNet wide = hypar(12, 20);
    const CableNet hanging = hanging_net(10, 10, hanging_density, hanging_weight);
    return {roof,
            named(with_strains(roof, 10.0, 1.0), "hilo-quarter, 10 x as stiff"),
            named(with_strains(roof, 100.0, 1.0), "hilo-quarter, 100 x as stiff"),
            hypar(5, 5),
            middle,
            named(with_strains(middle, 10.0, 1.0), "hypar:9x9, 10 x as stiff"),
            named(with_strains(middle, 1.0, 0.02), "hypar:9x9, tension 1/50"),
            wide,
            named(with_strains(wide, 10.0, 1.0), "hypar:12x20, 10 x as stiff"),
            named(with_strains(hypar(20, 20), 30.0, 1.0), "hypar:20x20, 30 x as stiff"),
            hanging,
            named(with_strains(hanging, 10.0, 1.0), "hanging:10x10, 10 x as stiff")};
}

}  // namespace taut
