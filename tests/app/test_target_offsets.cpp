// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards intervals of surveys whose targets are offset from the cables.

#include "app/built_net.hpp"

namespace {

using namespace taut::test;
using testing::AllOf;
using testing::HasSubstr;

using OffsetTargets = BuiltNetTest;

TEST_F(OffsetTargets, HaveIntervalsThatHoldWhereTheOffsetIsGivenAndAreFoundWhereItIsNot) {
    survey({"--noise", "0.5mm", "--offset", "3mm:0.2mm"});
    const auto given = identify("survey.csv", {"--offset", "3mm:0.2mm"}).result;
    EXPECT_EQ(given["trust"]["verdict"], "passed") << given["trust"];
    EXPECT_GE(coverage(given), 0.92);
    EXPECT_NE(identify("survey.csv").result["trust"]["verdict"], "passed");
    EXPECT_LT(coverage(identify("survey.csv", {"--uncertain", "none"}).result), 0.9);
}

TEST_F(OffsetTargets, HaveTheOffsetOfTheirKind) {
    survey({"--noise", "0.5mm", "--offset", "-3mm"});
    edit("survey.csv", [](const std::string& line, int number) {
        return number == 0 ? "Name,X,Y,Z,Code" : first_fields(line, 4) + ",prism";
    });
    write("offsets.csv", "target,offset,std\nprism,-3mm,0.1mm\n17,-0.003,0\n");
    const auto [result, err] =
        identify("survey.csv", {"--noise", "0.5mm", "--offsets", "offsets.csv", "--unit", "m"});
    EXPECT_THAT(err, AllOf(HasSubstr("299 targets"), HasSubstr("1 target ")));
    EXPECT_GE(coverage(result), 0.92);
}

}  // namespace
