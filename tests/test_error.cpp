// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <new>
#include <stdexcept>

#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/error.hpp"
#include "taut/files/file.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/io/net_json.hpp"
#include "taut/net/units.hpp"
#include "taut/numerical_error.hpp"
#include "taut/process_group.hpp"

namespace taut {
namespace {

ErrorCode code_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::exception& error) {
        return error_code(error);
    }
    ADD_FAILURE() << "nothing was thrown";
    return ErrorCode::other;
}

TEST(Error, HasTheCodeOfWhatWentWrong) {
    const CableNet net = hypar(3, 3);
    const auto built_broken = [&] {
        CableNetData data = net.data();
        data.unstressed_lengths(0) = -1.0;
        const CableNet broken(std::move(data));
    };
    EXPECT_EQ(code_of(built_broken), ErrorCode::net);
    EXPECT_EQ(code_of([&] { (void)identify(net, Survey{}); }), ErrorCode::survey);
    EXPECT_EQ(code_of([] { (void)parse_length("5 miles"); }), ErrorCode::argument);
    EXPECT_EQ(code_of([] { (void)read_net("nowhere.json"); }), ErrorCode::missing_file);
    EXPECT_EQ(code_of([] { (void)parse_net("{", "net.json"); }), ErrorCode::input_file);
    EXPECT_EQ(code_of([] { write_file("/nowhere/at/all", ""); }), ErrorCode::output_file);
    const FormTarget target(net, net.nodes());
    EXPECT_EQ(code_of([&] { (void)plan_turns(net, {.net = net}, target, {.stroke = -1.0}); }),
              ErrorCode::request);
    const BuiltNet doubted{.net = net, .length_draws = {}, .failed_because = "a wrong scale"};
    EXPECT_EQ(code_of([&] { (void)plan_turns(net, doubted, target); }),
              ErrorCode::failed_identification);
}

TEST(Error, HasACodeForEachExceptionThatTautThrows) {
    EXPECT_EQ(error_code(EpochError(1, "is exact")), ErrorCode::survey);
    EXPECT_EQ(error_code(NumericalError("no equilibrium")), ErrorCode::no_solution);
    EXPECT_EQ(error_code(Interrupted()), ErrorCode::interrupted);
    EXPECT_EQ(error_code(PeerFailed("gone")), ErrorCode::peer);
    EXPECT_EQ(error_code(std::bad_alloc()), ErrorCode::out_of_memory);
    EXPECT_EQ(error_code(std::out_of_range("node 7")), ErrorCode::argument);
    EXPECT_EQ(error_code(std::runtime_error("else")), ErrorCode::other);
    EXPECT_EQ(to_string(ErrorCode::no_solution), "no_solution");
}

}  // namespace
}  // namespace taut
