// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/common_unknowns.hpp"

#include <cmath>

namespace taut {
namespace {

bool is_common(const Unknown& unknown) {
    return unknown.kind == Unknown::Kind::stiffness || unknown.kind == Unknown::Kind::temperature ||
           unknown.kind == Unknown::Kind::loads;
}

}  // namespace

CommonUnknowns::CommonUnknowns(const CableNet& net, const std::vector<Unknown>& unknowns) {
    for (const Unknown& unknown : unknowns) {
        if (is_common(unknown)) {
            m_unknowns.push_back(unknown);
        }
    }
    m_stiffness.setZero(net.edge_count(), count());
    m_thermal.setZero(net.edge_count(), count());
    for (int k = 0; k < count(); ++k) {
        const Unknown& unknown = m_unknowns[k];
        for (const int edge : edges_of(net, unknown)) {
            if (unknown.kind == Unknown::Kind::stiffness) {
                m_stiffness(edge, k) = unknown.std;
            } else if (unknown.kind == Unknown::Kind::temperature) {
                m_thermal(edge, k) = unknown.std * net.data().expansion(edge);
            }
        }
    }
}

double CommonUnknowns::stiffness_factor(int edge, const Eigen::VectorXd& values) const {
    return count() > 0 ? std::exp(m_stiffness.row(edge).dot(values)) : 1.0;
}

double CommonUnknowns::thermal_strain(int edge, const Eigen::VectorXd& values) const {
    return count() > 0 ? m_thermal.row(edge).dot(values) : 0.0;
}

Eigen::VectorXd CommonUnknowns::cold(const Eigen::VectorXd& lengths,
                                     const Eigen::VectorXd& values) const {
    Eigen::VectorXd result = lengths;
    for (int e = 0; count() > 0 && e < lengths.size(); ++e) {
        result(e) = cold(e, lengths(e), values);
    }
    return result;
}

double CommonUnknowns::load_factor(const Eigen::VectorXd& values) const {
    double factor = 1.0;
    for (int k = 0; k < count(); ++k) {
        factor += load_rate(k) * values(k);
    }
    return factor;
}

}  // namespace taut
