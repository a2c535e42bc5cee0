// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/load_response.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <utility>

#include "taut/numerical_error.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Where the unknowns of joint_covariance() stand.
struct Columns {
    explicit Columns(const StaticsModel& model)
        : lengths(3 * model.net().node_count()),
          common(lengths + model.net().interior_edge_count()),
          count(common + model.common.count()) {}

    int lengths;
    int common;
    int count;
};

/// dh/dz but for the loads (3 n rows), which are the same at all iterates.
Rates force_rates(const StaticsModel& model, const Iterate& iterate) {
    const CableNet& net = model.net();
    const Columns columns(model);
    Triplets entries;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (model.slack[e]) {
            continue;
        }
        const EdgeRates rates = model.rates(e, iterate);
        const auto [s, t] = net.edges()[e];
        const Eigen::Matrix3d stiffness = rates.stiffness();
        for (const auto& [node, other, sign] : {std::tuple(s, t, 1.0), std::tuple(t, s, -1.0)}) {
            const auto add = [&entries, row = 3 * node, by = sign](int column,
                                                                   const Eigen::Vector3d& v) {
                for (int i = 0; i < 3; ++i) {
                    entries.emplace_back(row + i, column, by * v(i));
                }
            };
            for (int axis = 0; axis < 3; ++axis) {
                add(3 * node + axis, sign * stiffness.col(axis));
                add(3 * other + axis, -sign * stiffness.col(axis));
            }
            if (const int i = model.numbering().interior_of[e]; i >= 0) {
                add(columns.lengths + i, rates.length_rate());
            }
            for (int k = 0; k < model.common.count(); ++k) {
                add(columns.common + k, rates.force_by(model.common_variation(e, k, iterate)));
            }
        }
    }
    const Points springs = model.designed_elastic_forces(iterate) - iterate.loads;
    const double factor = model.common.support_factor(iterate.common);
    for (const ElasticSupport& support : net.elastic_supports()) {
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                entries.emplace_back(3 * support.node + i, 3 * support.node + k,
                                     factor * support.stiffness(i, k));
            }
            for (int k = 0; k < model.common.count(); ++k) {
                entries.emplace_back(
                    3 * support.node + i, columns.common + k,
                    factor * (model.common.support_stiffness_rate(k) * springs(i, support.node) -
                              model.common.place_load_rate(k, support.node)(i)));
            }
        }
    }
    for (const auto& [first, second, stiffness] : net.support_couplings()) {
        const int a = 3 * net.elastic_supports()[first].node;
        const int b = 3 * net.elastic_supports()[second].node;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                entries.emplace_back(a + i, b + k, factor * stiffness(i, k));
                entries.emplace_back(b + k, a + i, factor * stiffness(i, k));
            }
        }
    }
    Rates result(3 * net.node_count(), columns.count);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// H of a net at a form, factorised; loose nodes are held by a part of it.
class FreeStiffness {
public:
    FreeStiffness(const CableNet& net, const Points& form) : m_net(net) {
        constexpr double part_that_holds_loose_nodes = 1e-10;
        Eigen::SparseMatrix<double> matrix = tangent_stiffness(net, net.unstressed_lengths(), form);
        Eigen::SparseMatrix<double> held(matrix.rows(), matrix.cols());
        held.setIdentity();
        matrix += part_that_holds_loose_nodes * matrix.diagonal().mean() * held;
        m_factor.compute(matrix);
        if (m_factor.info() != Eigen::Success) {
            throw NumericalError("the stiffness of the net is singular at this form");
        }
    }

    /// H^-1 of forces at all nodes (3 n rows): places of the free nodes (3 n_I rows).
    [[nodiscard]] Eigen::MatrixXd places_by(const Eigen::MatrixXd& forces) const {
        Eigen::MatrixXd of_free(Eigen::Index{3} * m_net.free_node_count(), forces.cols());
        for (int i = 0; i < m_net.free_node_count(); ++i) {
            of_free.middleRows(Eigen::Index{3} * i, 3) =
                forces.middleRows(Eigen::Index{3} * m_net.free_nodes()[i], 3);
        }
        return m_factor.solve(of_free);
    }

private:
    const CableNet& m_net;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;
};

/// At the free nodes out of all (rows of three), those that a survey has targets on.
Eigen::MatrixXd at_targets(const CableNet& net, const Survey& survey,
                           const Eigen::MatrixXd& of_free) {
    const auto count = std::ssize(survey.surveyed);
    Eigen::MatrixXd result(3 * count, of_free.cols());
    for (Eigen::Index k = 0; k < count; ++k) {
        const int node = survey.surveyed[static_cast<size_t>(k)];
        result.middleRows(3 * k, 3) = of_free.middleRows(Eigen::Index{3} * net.free_index(node), 3);
    }
    return result;
}

/// Of single edges, in their standard deviations: a fit has them as lengths, which act by T; under
/// the load they act by T_1.
Eigen::MatrixXd own_stiffness_forces(const StaticsModel& model, const StaticsModel& loaded,
                                     const Iterate& iterate, const Iterate& under_load) {
    const CableNet& net = model.net();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * net.node_count(), net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        if (loaded.slack[e]) {
            continue;
        }
        const EdgeRates rates = loaded.rates(e, under_load);
        const double without = model.slack[e] ? 0.0 : model.rates(e, iterate).by_stiffness;
        const Eigen::Vector3d force =
            model.own_stiffness_stds()(e) * (rates.by_stiffness - without) * rates.direction;
        const auto [s, t] = net.edges()[e];
        result.col(e).segment<3>(Eigen::Index{3} * s) = force;
        result.col(e).segment<3>(Eigen::Index{3} * t) = -force;
    }
    return result;
}

}  // namespace

Rates tension_rates(const StaticsModel& model, const Iterate& iterate) {
    const CableNet& net = model.net();
    const Columns columns(model);
    Triplets entries;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (model.slack[e]) {
            continue;
        }
        const EdgeRates rates = model.rates(e, iterate);
        const auto [s, t] = net.edges()[e];
        for (int axis = 0; axis < 3; ++axis) {
            entries.emplace_back(e, 3 * s + axis, rates.axial * rates.direction(axis));
            entries.emplace_back(e, 3 * t + axis, -rates.axial * rates.direction(axis));
        }
        if (const int i = model.numbering().interior_of[e]; i >= 0) {
            entries.emplace_back(e, columns.lengths + i, rates.by_length);
        }
        for (int k = 0; k < model.common.count(); ++k) {
            entries.emplace_back(e, columns.common + k,
                                 rates.tension_by(model.common_variation(e, k, iterate)));
        }
    }
    Rates result(net.edge_count(), columns.count);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

std::optional<LoadResponse> response_to_load(const PlannedFit& planned, int node, double load,
                                             const Survey& survey) {
    const auto loaded_net = [&](const CableNet& net) {
        CableNetData data = net.data();
        if (data.loads.cols() == 0) {
            data.loads = Points::Zero(3, net.node_count());
        }
        data.loads(2, node) -= load;
        return CableNet(std::move(data));
    };
    const CableNet& net = planned.net();
    const Equilibrium equilibrium = solve_equilibrium(loaded_net(net));
    if (!equilibrium.balanced()) {
        return std::nullopt;
    }
    const Eigen::VectorXd under =
        tensions_of(net, equilibrium.unstressed_lengths, equilibrium.form);
    const Eigen::VectorXd& designed = planned.tensions();
    const double highest = 2.0 * designed.cwiseAbs().maxCoeff();
    const Eigen::VectorXd& breaking = net.data().breaking_load;
    const Eigen::VectorXd& buckling = net.data().buckling_load;
    for (int e = 0; e < net.edge_count(); ++e) {
        if ((buckling.size() > 0 && under(e) < -buckling(e)) ||
            under(e) > (breaking.size() > 0 ? breaking(e) : highest) ||
            (!net.is_strut(e) && designed(e) > 0.0 && !(under(e) > 0.0))) {
            return std::nullopt;
        }
    }
    const CableNet fit_net = loaded_net(planned.fit_net());
    const StaticsModel loaded = designed_model(fit_net, equilibrium.form, planned.knowledge(),
                                               planned.knowledge().length_std());
    Iterate under_load = planned.iterate();
    under_load.form = equilibrium.form;
    const Rates rates = force_rates(loaded, under_load);
    const FreeStiffness free_stiffness(net, equilibrium.form);

    LoadResponse result;
    const Rates difference = force_rates(planned.model(), planned.iterate()) - rates;
    Eigen::MatrixXd of_free = free_stiffness.places_by(Eigen::MatrixXd(difference));
    for (int i = 0; i < net.free_node_count(); ++i) {
        of_free.block<3, 3>(Eigen::Index{3} * i, Eigen::Index{3} * net.free_nodes()[i]) +=
            Eigen::Matrix3d::Identity();
    }
    const int first_common = Columns(loaded).common;
    int k = first_common;
    Eigen::MatrixXd of_another_day = Eigen::MatrixXd::Zero(of_free.rows(), loaded.common.count());
    for (const UncertainParameter& one : planned.knowledge().uncertain) {
        if (one.kind == UncertainParameter::Kind::test_loads) {
            Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * net.node_count());
            force(3 * node + 2) = -load * one.std_dev;
            of_free.col(k) += free_stiffness.places_by(force);
        }
        if (one.kind == UncertainParameter::Kind::temperature) {
            const Eigen::VectorXd heated = free_stiffness.places_by(Eigen::MatrixXd(rates.col(k)));
            of_another_day.col(k - first_common) = heated;
            of_free.col(k) += heated;
        }
        k += is_common(one) ? 1 : 0;
    }
    result.rates = at_targets(net, survey, of_free);

    const Eigen::MatrixXd own =
        at_targets(net, survey,
                   free_stiffness.places_by(own_stiffness_forces(planned.model(), loaded,
                                                                 planned.iterate(), under_load)));
    const Eigen::MatrixXd heated = at_targets(net, survey, of_another_day);
    result.noise = own * own.transpose() + heated * heated.transpose();
    const Points noise = with_noise_floor(net, survey);
    for (size_t i = 0; i < survey.surveyed.size(); ++i) {
        const Eigen::Vector3d variances = noise.col(survey.surveyed[i]).cwiseAbs2();
        result.noise.diagonal().segment<3>(static_cast<Eigen::Index>(3 * i)) += variances;
    }
    return result;
}

std::vector<int> nodes_to_load(const PlannedFit& planned) {
    const CableNet& net = planned.net();
    const FreeStiffness free_stiffness(net, planned.iterate().form);
    std::vector<std::pair<double, int>> by_softness;
    by_softness.reserve(net.free_nodes().size());
    Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * net.node_count());
    for (const int node : net.free_nodes()) {
        if (net.is_support(node)) {
            continue;
        }
        force(3 * node + 2) = 1.0;
        const Eigen::VectorXd places = free_stiffness.places_by(force);
        by_softness.emplace_back(-places(3 * net.free_index(node) + 2), node);
        force(3 * node + 2) = 0.0;
    }
    std::ranges::sort(by_softness);
    constexpr size_t most = 8;
    const size_t count = std::min(most, by_softness.size());
    std::vector<int> result;
    result.reserve(count);
    for (size_t k = 0; k < count; ++k) {
        const size_t rank = count > 1 ? k * (by_softness.size() - 1) / (count - 1) : 0;
        result.push_back(by_softness[rank].second);
    }
    std::ranges::sort(result);
    return result;
}

}  // namespace taut
