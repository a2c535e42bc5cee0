// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/target_deviations.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace taut {
namespace {

/// Rows of the form, before those of the target tensions.
Eigen::Index form_rows(const StrokeTask& task, Eigen::Index rows) {
    return rows - std::ssize(task.tensions);
}

}  // namespace

TargetDeviations deviations_from_targets(const StrokeTask& task, const CableNet& net,
                                         const StrokedNet& stroked, const StrokeRates& rates) {
    const FormTarget target = task.target->at(stroked.equilibrium.form);
    const Eigen::Index nodes = net.free_node_count();
    const Eigen::Index tensions = std::ssize(task.tensions);
    TargetDeviations result{.values = Eigen::VectorXd(3 * nodes + tensions),
                            .rates = Eigen::MatrixXd(3 * nodes + tensions, rates.form.cols())};
    const bool has_rates = rates.form.cols() > 0;
    for (Eigen::Index i = 0; i < nodes; ++i) {
        const int node = net.free_nodes()[static_cast<size_t>(i)];
        const Eigen::Matrix3d weight = target.weight(node);
        result.values.segment<3>(3 * i) =
            weight * (stroked.equilibrium.form.col(node) - target.places().col(node));
        if (has_rates) {
            result.rates.middleRows(3 * i, 3) = weight * rates.form.middleRows(3 * i, 3);
        }
    }
    // So that the sum of squares over the nodes is the mean square of the tensions.
    const double share = task.target->objective() == FormObjective::rms && tensions > 0
                             ? std::sqrt(static_cast<double>(nodes) / static_cast<double>(tensions))
                             : 1.0;
    for (Eigen::Index i = 0; i < tensions; ++i) {
        const TensionTarget& aim = task.tensions[static_cast<size_t>(i)];
        const double per_newton = share * task.form_tolerance / aim.tolerance;
        result.values(3 * nodes + i) = per_newton * (stroked.forces(aim.edge) - aim.tension);
        if (has_rates) {
            result.rates.row(3 * nodes + i) = per_newton * rates.forces.row(aim.edge);
        }
    }
    return result;
}

double cost_of(const StrokeTask& task, const Eigen::Ref<const Eigen::VectorXd>& values) {
    const Eigen::Index rows = form_rows(task, values.size());
    if (task.target->objective() == FormObjective::rms) {
        return 3.0 * values.squaredNorm() / static_cast<double>(rows);
    }
    const double of_tensions =
        values.size() > rows ? values.tail(values.size() - rows).cwiseAbs2().maxCoeff() : 0.0;
    return std::max(values.head(rows).reshaped(3, rows / 3).colwise().squaredNorm().maxCoeff(),
                    of_tensions);
}

double cost_of(const StrokeTask& task, const CableNet& net, const StrokedNet& stroked) {
    return cost_of(task, deviations_from_targets(task, net, stroked).values);
}

bool is_within_tolerances(const StrokeTask& task, const CableNet& net, const StrokedNet& stroked) {
    const double bound = task.form_tolerance * task.form_tolerance;
    const Eigen::VectorXd values = deviations_from_targets(task, net, stroked).values;
    const Eigen::Index rows = form_rows(task, values.size());
    if (task.target->objective() == FormObjective::largest) {
        return cost_of(task, values) <= bound;
    }
    return 3.0 * values.head(rows).squaredNorm() / static_cast<double>(rows) <= bound &&
           3.0 * values.tail(values.size() - rows).squaredNorm() / static_cast<double>(rows) <=
               bound;
}

FormTarget with_median_weight_one(FormTarget target, const CableNet& net,
                                  bool has_target_tensions) {
    std::vector<double> weights;
    for (const int node : net.free_nodes()) {
        const double normal = target.normal_weights()(node);
        weights.push_back(normal > 0.0 ? normal : target.tangential_weights()(node));
    }
    std::erase(weights, 0.0);
    if (weights.empty()) {
        if (!has_target_tensions) {
            throw std::invalid_argument("all weights are 0, expected at least one above 0");
        }
        return target;
    }
    const auto middle = weights.begin() + std::ssize(weights) / 2;
    std::ranges::nth_element(weights, middle);
    target.set_weights(target.normal_weights() / *middle, target.tangential_weights() / *middle);
    return target;
}

}  // namespace taut
