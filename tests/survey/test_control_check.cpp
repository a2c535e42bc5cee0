// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a support that was measured elsewhere than the net has it being passed over.
#include "survey/control_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<ControlResidual> residuals{{.id = "A", .residual = {0.0, 0.0, 0.0}},
                                             {.id = "B", .residual = {0.0, 0.003, 0.0}},
                                             {.id = "C", .residual = {0.0, 0.0, 0.0}}};

TEST(ControlCheck, NamesThePointThatTheNoiseDoesNotExplain) {
    for (const double noise : {0.0, 0.0005}) {
        EXPECT_THAT(control_warnings(hypar(2, 2), residuals, noise),
                    ElementsAre(AllOf(HasSubstr("1 of 3 supports or control points"),
                                      HasSubstr("'B' is 3 mm off"))));
    }
}

TEST(ControlCheck, SaysNothingWhereAllLieAsFarOffOrTheNoiseExplainsIt) {
    EXPECT_THAT(control_warnings(hypar(2, 2),
                                 {{.id = "A", .residual = {0.002, 0.0, 0.0}},
                                  {.id = "B", .residual = {0.0, 0.003, 0.0}},
                                  {.id = "C", .residual = {0.0, 0.0, 0.001}}},
                                 0.0001),
                IsEmpty());
    EXPECT_THAT(control_warnings(hypar(2, 2), residuals, 0.0007), IsEmpty());
    EXPECT_THAT(control_warnings(hypar(2, 2), {}, 0.0), IsEmpty());
}

}  // namespace
}  // namespace taut
