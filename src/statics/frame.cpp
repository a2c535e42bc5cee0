// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/frame.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "taut/statics/energy.hpp"

namespace taut {
namespace {

void check_stiffness(const FrameStiffness& frame) {
    constexpr double rounded = 1e-6;  // to the digits that a frame program writes
    const auto size = 3 * std::ssize(frame.supports);
    const Eigen::MatrixXd& K = frame.stiffness;
    if (K.rows() != size || K.cols() != size) {
        throw std::invalid_argument(fmt::format(
            "frame: a stiffness of {} x {}, expected {} x {}, three rows for each of {} supports",
            K.rows(), K.cols(), size, size, frame.supports.size()));
    }
    if (!K.allFinite()) {
        throw std::invalid_argument("frame: a stiffness that is not finite");
    }
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    if ((K - K.transpose()).cwiseAbs().maxCoeff(&row, &column) >
        rounded * K.cwiseAbs().maxCoeff()) {
        throw std::invalid_argument(
            fmt::format("frame: a stiffness that is not symmetric: {} in row {} and column {}, but "
                        "{} the other way round",
                        K(row, column), row, column, K(column, row)));
    }
}

/// Makes an elastic support of each one of the frame, at the place of its node.
/// @return their indices in elastic_supports
std::vector<int> place_on_frame(const CableNet& net, const FrameStiffness& frame,
                                CableNetData& data) {
    std::set<int> taken;
    for (const auto& [first, second, stiffness] : data.support_couplings) {
        taken.insert(data.elastic_supports[first].node);
        taken.insert(data.elastic_supports[second].node);
    }
    std::vector<int> indices;
    for (const int node : frame.supports) {
        if (node < 0 || node >= net.node_count() || !net.is_support(node)) {
            throw std::invalid_argument(
                fmt::format("frame: node {} is no support of the net", node));
        }
        if (!taken.insert(node).second) {
            throw std::invalid_argument(fmt::format(
                "frame: support {} comes twice, or stands on a frame already", net.node_id(node)));
        }
        std::erase(data.supports, node);
        auto found = std::ranges::find(data.elastic_supports, node, &ElasticSupport::node);
        if (found == data.elastic_supports.end()) {
            data.elastic_supports.push_back({.node = node});
            found = std::prev(data.elastic_supports.end());
        }
        found->place = data.nodes.col(node);
        indices.push_back(static_cast<int>(found - data.elastic_supports.begin()));
    }
    return indices;
}

}  // namespace

CableNet on_frame(const CableNet& net, const FrameStiffness& frame) {
    check_stiffness(frame);
    const Eigen::MatrixXd K = 0.5 * (frame.stiffness + frame.stiffness.transpose());
    CableNetData data = net.data();
    const std::vector<int> indices = place_on_frame(net, frame, data);
    for (Eigen::Index i = 0; i < std::ssize(indices); ++i) {
        const int a = indices[static_cast<size_t>(i)];
        data.elastic_supports[a].stiffness = K.block<3, 3>(3 * i, 3 * i);
        for (Eigen::Index k = 0; k < i; ++k) {
            const int b = indices[static_cast<size_t>(k)];
            const Eigen::Matrix3d block = K.block<3, 3>(3 * i, 3 * k);
            if (!block.isZero(0.0)) {
                data.support_couplings.push_back(
                    {.first = std::min(a, b),
                     .second = std::max(a, b),
                     .stiffness = a < b ? block : Eigen::Matrix3d(block.transpose())});
            }
        }
    }
    const CableNet balanced = with_supports_in_balance(CableNet(data));
    for (const int index : indices) {
        data.elastic_supports[index].place = balanced.elastic_supports()[index].place;
    }
    return CableNet(std::move(data));
}

}  // namespace taut
