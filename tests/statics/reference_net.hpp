// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"

/// Nets with the results of other programs, in tests/data.
namespace taut::test {

using Json = nlohmann::json;

/// @throws std::runtime_error if the file has no such net
inline Json reference_net(const std::string& file, const std::string& name) {
    std::ifstream stream(TAUT_TEST_DATA_DIR "/" + file);
    const Json reference = Json::parse(stream);
    for (const Json& net : reference.at("nets")) {
        if (net.at("name") == name) {
            return net;
        }
    }
    throw std::runtime_error(name + " is not in " + file);
}

inline Points points_of(const Json& json) {
    Points result(3, static_cast<Eigen::Index>(json.size()));
    for (size_t i = 0; i < json.size(); ++i) {
        const auto point = json.at(i).get<std::vector<double>>();
        result.col(static_cast<Eigen::Index>(i)) << point.at(0), point.at(1), point.at(2);
    }
    return result;
}

inline Eigen::VectorXd vector_of(const Json& json) {
    const auto values = json.get<std::vector<double>>();
    return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

/// Nodes on one frame.
inline void add_frame(const Json& frame, CableNetData& data) {
    const auto nodes = frame.at("nodes").get<std::vector<int>>();
    const Points places = points_of(frame.at("places"));
    const auto block = [&frame](int a, int b) {
        Eigen::Matrix3d result;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                result(i, k) = frame.at("stiffness").at(3 * a + i).at(3 * b + k).get<double>();
            }
        }
        return result;
    };
    for (int a = 0; a < std::ssize(nodes); ++a) {
        for (int b = 0; b < a; ++b) {
            data.support_couplings.push_back({.first = b, .second = a, .stiffness = block(b, a)});
        }
        data.elastic_supports.push_back(
            {.node = nodes[a], .stiffness = block(a, a), .place = places.col(a)});
    }
}

inline CableNet net_of(const Json& json) {
    CableNetData data;
    data.nodes = points_of(json.at("nodes"));
    data.supports = json.at("supports").get<std::vector<int>>();
    data.edges = json.at("edges").get<std::vector<Edge>>();
    data.axial_stiffness = vector_of(json.at("axial_stiffness"));
    data.unstressed_lengths = vector_of(json.at("unstressed_lengths"));
    data.loads = points_of(json.at("loads"));
    for (const Json& spring : json.value("springs", Json::array())) {
        const Points stiffness = points_of(spring.at("stiffness"));
        data.elastic_supports.push_back({.node = spring.at("node").get<int>(),
                                         .stiffness = stiffness,
                                         .place = vector_of(spring.at("place"))});
    }
    if (json.contains("frame") && !json.at("frame").at("nodes").empty()) {
        add_frame(json.at("frame"), data);
    }
    for (const int edge : json.value("struts", std::vector<int>())) {
        data.kind.resize(data.edges.size(), EdgeKind::cable);
        data.kind[edge] = EdgeKind::strut;
    }
    if (json.contains("sags") && !json.at("sags").empty()) {
        data.sag_weight = vector_of(json.at("sags"));
    }
    return CableNet(std::move(data));
}

}  // namespace taut::test
