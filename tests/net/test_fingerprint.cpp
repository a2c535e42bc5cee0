// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against files of one net being accepted for another, and against old files being
// refused because the fingerprint of the same net has changed.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

#include "support/small_nets.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {
namespace {

using Change = std::function<void(CableNetData&)>;

std::string fingerprint_after(const Change& change) {
    CableNetData data = test::two_node_net_data();
    change(data);
    return CableNet(std::move(data)).fingerprint();
}

const Change no_change = [](CableNetData&) {};

TEST(Fingerprint, IsTheSameInEveryVersion) {
    // FNV-1a of the bytes, computed independently of this code: for each of the lists nodes,
    // supports, edges, axial_stiffness, unstressed_lengths, adjustable and loads its size as 64
    // bit, then its entries (64 bit floating point, 32 bit integers, little endian; of pairs and
    // points the sizes are those of the pairs and of the coordinates).
    EXPECT_EQ(fingerprint_after(no_change), "3230a6368aee248d");
}

TEST(Fingerprint, ChangesWithAnyPhysicalNumber) {
    std::set<std::string> fingerprints{fingerprint_after(no_change)};
    const std::vector<Change> changes{
        [](CableNetData& d) { d.nodes(0, 0) += 1e-15; },
        [](CableNetData& d) { d.nodes(2, 5) *= 1.0 + 1e-15; },
        [](CableNetData& d) { std::swap(d.supports[0], d.supports[1]); },
        [](CableNetData& d) { std::swap(d.edges[2][0], d.edges[2][1]); },
        [](CableNetData& d) { d.edges[1] = {5, 0}; },
        [](CableNetData& d) { d.axial_stiffness(0) *= 1.0 + 1e-15; },
        [](CableNetData& d) { d.axial_stiffness(4) *= 1.0 + 1e-15; },
        [](CableNetData& d) { d.unstressed_lengths(0) += 1e-15; },
        [](CableNetData& d) { d.unstressed_lengths(4) += 1e-15; },
        [](CableNetData& d) { d.adjustable = {0, 3}; },
        [](CableNetData& d) { d.adjustable = {0}; },
        [](CableNetData& d) { d.loads(2, 0) += 1e-12; },
        [](CableNetData& d) { d.loads.setZero(); },
    };
    for (size_t i = 0; i < changes.size(); ++i) {
        EXPECT_TRUE(fingerprints.insert(fingerprint_after(changes[i])).second) << "change " << i;
    }
}

TEST(Fingerprint, DoesNotChangeWithNames) {
    const std::string fingerprint = fingerprint_after(no_change);
    EXPECT_EQ(fingerprint_after([](CableNetData& d) { d.name = "other"; }), fingerprint);
    EXPECT_EQ(fingerprint_after([](CableNetData& d) { d.node_ids.clear(); }), fingerprint);
    EXPECT_EQ(fingerprint_after([](CableNetData& d) { d.edge_ids[0] = "other"; }), fingerprint);
}

TEST(Fingerprint, DoesNotDependOnHowTheSameNetIsWritten) {
    EXPECT_EQ(fingerprint_after([](CableNetData& d) { d.adjustable = {0, 4}; }),
              fingerprint_after([](CableNetData& d) { d.adjustable = {4, 0}; }));
    EXPECT_EQ(fingerprint_after([](CableNetData& d) { d.loads.setZero(); }),
              fingerprint_after([](CableNetData& d) { d.loads.resize(3, 0); }));
}

}  // namespace
}  // namespace taut
