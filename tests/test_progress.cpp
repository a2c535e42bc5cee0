// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against work that cannot be stopped, and against stages made of parts whose progress goes
// backwards or ends too early.

#include "taut/progress.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace taut;

TEST(Progress, WithoutFunctionsDoesNothing) {
    const Progress none;
    EXPECT_FALSE(none.stopped());
    EXPECT_NO_THROW(none("sampling", 1, 2));
    EXPECT_NO_THROW(none.part(1, 2)("sampling", 1, 2));
}

TEST(Progress, ThrowsInsteadOfReportingIfAStopWasRequested) {
    int reports = 0;
    bool stop = false;
    const Progress progress{.report = [&](std::string_view, int, int) { ++reports; },
                            .stop_requested = [&] { return stop; }};
    progress("sampling", 1, 2);
    stop = true;
    EXPECT_TRUE(progress.part(0, 2).stopped());
    EXPECT_THROW(progress("sampling", 2, 2), Interrupted);
    EXPECT_THROW(progress.part(0, 2)("sampling", 2, 2), Interrupted);
    EXPECT_EQ(reports, 1);
}

TEST(Progress, OfPartsCountsTheStepsOfAll) {
    std::vector<std::string> reports;
    const Progress whole{.report = [&](std::string_view stage, int done, int total) {
        reports.push_back(std::string(stage) + " " + std::to_string(done) + " of " +
                          std::to_string(total));
    }};
    for (const int index : {0, 1, 2}) {
        const Progress part = whole.part(index, 3);
        part("training", 0, 4);
        part("training", 4, 4);
    }
    const std::vector<std::string> expected{"training 0 of 12", "training 4 of 12",
                                            "training 4 of 12", "training 8 of 12",
                                            "training 8 of 12", "training 12 of 12"};
    EXPECT_EQ(reports, expected);
}

}  // namespace
