// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/sampling/model_perturbation.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "net/weight_as_load.hpp"
#include "numerics/random_numbers.hpp"
#include "sampling/uncertain_widths.hpp"

namespace taut {
namespace {

/// Gives each edge a tension law of its own, scaled by its stiffness.
void scale_laws(const CableNet& net, const Eigen::VectorXd& stiffness, CableNetData& data) {
    std::vector<TensionLaw> laws;
    laws.reserve(data.tension_law.size());
    for (int e = 0; e < net.edge_count(); ++e) {
        if (data.tension_law[e] >= 0) {
            laws.push_back(
                data.tension_laws[data.tension_law[e]].stiffened(std::exp(stiffness(e))));
            data.tension_law[e] = static_cast<int>(laws.size()) - 1;
        }
    }
    data.tension_laws = std::move(laws);
}

}  // namespace

ModelPerturbation unperturbed(const CableNet& net) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(net.edge_count());
    return {.stiffness = zero,
            .thermal = zero,
            .supports = Points::Zero(3, net.node_count()),
            .adjustable = zero,
            .loads = 0.0,
            .own_loads = Points::Zero(3, net.node_count())};
}

ModelPerturbation draw_perturbation(const CableNet& net,
                                    const std::vector<UncertainParameter>& uncertain,
                                    std::uint64_t seed, std::uint64_t sample) {
    // A random stream of their own, so that the lengths of a data set are the same with and without
    // uncertain parameters.
    constexpr std::uint64_t other_than_lengths = 0x7461757400000000U;
    RandomNumbers random(seed ^ other_than_lengths, static_cast<std::uint32_t>(sample));
    ModelPerturbation result = unperturbed(net);
    for (const UncertainParameter& parameter : uncertain) {
        switch (parameter.kind) {
            case UncertainParameter::Kind::stiffness:
                result.stiffness(edges_of(net, parameter)).array() +=
                    parameter.std_dev * random.normal();
                break;
            case UncertainParameter::Kind::stiffness_each:
                for (const int edge : edges_of(net, parameter)) {
                    result.stiffness(edge) += parameter.std_dev * random.normal();
                }
                break;
            case UncertainParameter::Kind::temperature: {
                const std::vector<int> edges = edges_of(net, parameter);
                result.thermal(edges) +=
                    parameter.std_dev * random.normal() * net.data().expansion(edges);
                break;
            }
            case UncertainParameter::Kind::creep:
                result.thermal(edges_of(net, parameter)).array() +=
                    parameter.std_dev * random.normal();
                break;
            case UncertainParameter::Kind::supports:
                for (const int node : net.all_supports()) {
                    for (double& coordinate : result.supports.col(node)) {
                        coordinate = parameter.std_dev * random.normal();
                    }
                }
                break;
            case UncertainParameter::Kind::support_stiffness:
                result.support_stiffness = parameter.std_dev * random.normal();
                break;
            case UncertainParameter::Kind::adjustable:
                for (const int edge : net.adjustable_edges()) {
                    result.adjustable(edge) = parameter.std_dev * random.normal();
                }
                break;
            case UncertainParameter::Kind::loads:
                result.loads = parameter.std_dev * random.normal();
                if (std_of(uncertain, UncertainParameter::Kind::mass) > 0.0) {
                    result.own_loads -= result.loads * self_weight(net);  // has that of the mass
                }
                break;
            case UncertainParameter::Kind::loads_each:
                for (const int node : net.free_nodes()) {
                    for (double& load : result.own_loads.col(node)) {
                        load += parameter.std_dev * random.normal();
                    }
                }
                break;
            case UncertainParameter::Kind::mass:
                result.sag = parameter.std_dev * random.normal();
                result.own_loads += result.sag * self_weight(net);
                break;
            case UncertainParameter::Kind::slip:  // follows from the balance of the net
            case UncertainParameter::Kind::forces:
            case UncertainParameter::Kind::test_loads:
                break;  // errors of measurements, not of the net
        }
    }
    return result;
}

CableNet net_under(const CableNet& net, const ModelPerturbation& perturbation,
                   const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths) {
    if (unstressed_lengths.size() != net.edge_count()) {
        throw std::invalid_argument(fmt::format("{} unstressed lengths, expected {}",
                                                unstressed_lengths.size(), net.edge_count()));
    }
    CableNetData data = with_weight_as_load(net);
    data.nodes(Eigen::all, net.supports()) += perturbation.supports(Eigen::all, net.supports());
    for (ElasticSupport& support : data.elastic_supports) {
        support.place += perturbation.supports.col(support.node);
        support.stiffness *= std::exp(perturbation.support_stiffness);
    }
    for (SupportCoupling& coupling : data.support_couplings) {
        coupling.stiffness *= std::exp(perturbation.support_stiffness);
    }
    data.axial_stiffness.array() *= perturbation.stiffness.array().exp();
    if (!net.is_linear()) {
        scale_laws(net, perturbation.stiffness, data);
    }
    if (!perturbation.runs.empty()) {
        data.runs = perturbation.runs;
    }
    data.sag_weight *= 1.0 + perturbation.sag;
    data.loads = (1.0 + perturbation.loads) * net.loads() + perturbation.own_loads;
    data.unstressed_lengths = (unstressed_lengths + perturbation.adjustable)
                                  .cwiseProduct((1.0 + perturbation.thermal.array()).matrix());
    return CableNet(std::move(data));
}

}  // namespace taut
