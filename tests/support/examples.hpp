// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <bit>
#include <cstdint>
#include <string>

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/net_json.hpp"
#include "taut/sampling/sampler.hpp"

/// Small nets, data sets and models, with everything that a file has to store.
namespace taut::test {

/// 6 free nodes, 10 supports, 7 interior edges; with loads, names and unknown keys.
inline NetFile example_net() {
    CableNetData data = hypar(2, 3).data();
    data.loads = Points::Zero(3, data.nodes.cols());
    data.loads(2, 0) = -1.0 / 3.0;
    for (Eigen::Index i = 0; i < data.nodes.cols(); ++i) {
        data.node_ids.push_back(fmt::format("N{}", i));
    }
    for (size_t e = 0; e < data.edges.size(); ++e) {
        data.edge_ids.push_back(fmt::format("cable {}", e));
    }
    return {.net = CableNet(std::move(data)), .unknown_keys = R"({"author":"A. B."})"};
}

inline DataSet example_data(const CableNet& net, int count = 30) {
    const Sampler sampler(net, {.kind = LengthPrior::Kind::uniform, .scale = 0.003}, 7);
    DataSet data = sampler.no_samples();
    sampler.extend_to(data, count);
    return data;
}

inline LengthModel example_model(const CableNet& net, const DataSet& data,
                                 const TrainingSettings& settings = TrainingSettings::paper()) {
    return train_model(net, data, data.converged_in(0, data.size()), settings);
}

inline bool same_bits(const Eigen::Ref<const Eigen::MatrixXd>& a,
                      const Eigen::Ref<const Eigen::MatrixXd>& b) {
    if (a.rows() != b.rows() || a.cols() != b.cols()) {
        return false;
    }
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
        for (Eigen::Index i = 0; i < a.rows(); ++i) {
            if (std::bit_cast<std::uint64_t>(a(i, j)) != std::bit_cast<std::uint64_t>(b(i, j))) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace taut::test
