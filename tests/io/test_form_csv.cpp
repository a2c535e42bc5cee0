// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a form that loses digits or names on its way through a file.

#include "taut/io/form_csv.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <set>

#include "support/examples.hpp"
#include "taut/io/survey_csv.hpp"

namespace taut {
namespace {

CableNet with_names(const std::vector<std::string>& names) {
    CableNetData data = hypar(1, 1).data();
    data.node_ids = names;
    return CableNet(std::move(data));
}

TEST(FormCsv, HasAHeaderAndARowANodeInTheirOrder) {
    const CableNet net = hypar(1, 1);
    Points form = net.nodes();
    form.col(0) = Eigen::Vector3d(0.1, -2.0, 1.0 / 3.0);
    const std::string csv = form_to_csv(net, form);
    EXPECT_THAT(csv, testing::StartsWith("id,x,y,z\n0,0.1,-2,0.3333333333333333\n1,"));
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + net.node_count());
}

RC_GTEST_PROP(FormCsv, ReadsBackAsASurveyWithAnyNamesAndNumbersToTheLastBit, ()) {
    const auto names = *rc::gen::container<std::vector<std::string>>(
        5, rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::oneOf(
               rc::gen::elementOf(std::string("a#,;\"\t ")), rc::gen::suchThat<char>([](char c) {
                   return c != '\0' && c != '\n' && c != '\r';
               })))));
    RC_PRE(std::set<std::string>(names.begin(), names.end()).size() == names.size());
    const CableNet net = with_names(names);
    Points form = net.nodes();
    for (double& x : form.reshaped()) {
        x = *rc::gen::arbitrary<double>() / 3.0;
    }
    const auto points = parse_survey_points(form_to_csv(net, form), "form.csv");
    RC_ASSERT(static_cast<int>(points.size()) == net.node_count());
    for (int node = 0; node < net.node_count(); ++node) {
        RC_ASSERT(points[node].id == names[node]);
        RC_ASSERT(test::same_bits(points[node].position, form.col(node)));
    }
}

TEST(FormCsv, RefusesAFormOfAnotherSizeOrThatIsNotFinite) {
    const CableNet net = hypar(1, 1);
    EXPECT_THROW(static_cast<void>(form_to_csv(net, Points::Zero(3, 4))), std::invalid_argument);
    Points form = net.nodes();
    form(1, 2) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(static_cast<void>(form_to_csv(net, form)), std::invalid_argument);
}

}  // namespace
}  // namespace taut
