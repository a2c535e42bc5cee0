// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/mean_function.hpp"

#include <utility>

#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

Eigen::VectorXd interior_lengths(const CableNet& net, const Eigen::VectorXd& free_form) {
    return edge_lengths(net, with_free_coordinates(net, free_form))(net.interior_edges());
}

/// Unstressed per stressed length at nominal strain (m_I).
Eigen::VectorXd nominal_ratios(const CableNet& net,
                               const Eigen::Ref<const Eigen::VectorXd>& nominal_form) {
    return net.unstressed_lengths()(net.interior_edges())
        .cwiseQuotient(interior_lengths(net, nominal_form));
}

}  // namespace

Eigen::MatrixXd mean_values(const CableNet& net, MeanFunction mean,
                            const Eigen::Ref<const Eigen::VectorXd>& nominal_form,
                            const Eigen::Ref<const Eigen::MatrixXd>& form_deviations) {
    Eigen::MatrixXd values =
        Eigen::MatrixXd::Zero(net.interior_edge_count(), form_deviations.cols());
    if (mean == MeanFunction::zero) {
        return values;
    }
    const Eigen::VectorXd nominal = interior_lengths(net, nominal_form);
    const Eigen::VectorXd ratios = nominal_ratios(net, nominal_form);
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
        values.col(k) = ratios.cwiseProduct(
            interior_lengths(net, nominal_form + form_deviations.col(k)) - nominal);
    }
    return values;
}

EdgeGradient length_gradient(const CableNet& net, const Eigen::Ref<const Points>& form) {
    constexpr int ends_coordinates = 6;
    EdgeGradient gradient(net.interior_edge_count(), 3 * net.free_node_count());
    gradient.reserve(Eigen::VectorXi::Constant(gradient.rows(), ends_coordinates));
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const auto [s, t] = net.edges()[net.interior_edges()[i]];
        const Eigen::Vector3d direction = (form.col(s) - form.col(t)).normalized();
        for (const auto& [node, sign] : {std::pair{s, 1.0}, std::pair{t, -1.0}}) {
            const int k = net.free_index(node);
            for (int axis = 0; k >= 0 && axis < 3; ++axis) {
                gradient.insert(i, 3 * k + axis) = sign * direction(axis);
            }
        }
    }
    return gradient;
}

Eigen::VectorXd mean_rates(const CableNet& net, MeanFunction mean,
                           const Eigen::Ref<const Eigen::VectorXd>& nominal_form) {
    return mean == MeanFunction::zero ? Eigen::VectorXd::Zero(net.interior_edge_count())
                                      : nominal_ratios(net, nominal_form);
}

}  // namespace taut
