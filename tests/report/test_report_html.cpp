// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a page that runs text of a net's name, that needs other files, or that holds
// another result than the one it was made from. What the page shows is tested in a browser, in
// tests/viewer.

#include "taut/report/report_html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/studies.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

class ReportHtml : public ::testing::Test {
protected:
    void SetUp() override {
        if (!has_report_viewer()) {
            GTEST_SKIP() << "this build has no viewer: Node.js was not found";
        }
    }
};

/// The result in the page.
json result_in(const std::string& page) {
    const std::string start = R"(<script type="application/json" id="result">)";
    const size_t from = page.find(start) + start.size();
    return json::parse(page.substr(from, page.find("</script", from) - from));
}

CableNet net_named(const std::string& name) {
    CableNetData data = hypar(3, 4).data();
    data.name = name;
    data.node_ids.assign(data.nodes.cols(), "");
    for (size_t i = 0; i < data.node_ids.size(); ++i) {
        data.node_ids[i] = name + std::to_string(i);
    }
    return CableNet(data);
}

TEST_F(ReportHtml, HoldsTheWholeResult) {
    const ResultFile results[] = {test::saved(test::made_up_study(hypar(3, 4))),
                                  test::made_up_identification(hypar(3, 4)),
                                  test::made_up_comparison(), test::made_up_plan(hypar(3, 4)),
                                  test::made_up_control(hypar(3, 4))};
    for (const ResultFile& result : results) {
        EXPECT_EQ(result_in(report_html(result)), json::parse(result.json));
    }
}

TEST_F(ReportHtml, ShowsMarkupInNamesAsText) {
    for (const std::string name :
         {"</script><script>alert(1)</script>", "<img src=x onerror=alert(1)>", "<!--<script>",
          "<!--taut:result-->"}) {
        const std::string page = report_html(test::made_up_identification(net_named(name)));
        const std::string plain = report_html(test::made_up_identification(net_named("plain")));
        EXPECT_EQ(result_in(page)["net"]["name"], name);
        const auto count = [](const std::string& text, const std::string& what) {
            int found = 0;
            for (size_t at = text.find(what); at != std::string::npos;
                 at = text.find(what, at + 1)) {
                ++found;
            }
            return found;
        };
        for (const std::string what : {"<script", "</script", "<img", "<!--"}) {
            EXPECT_EQ(count(page, what), count(plain, what)) << name << ": " << what;
        }
    }
}

TEST_F(ReportHtml, LetsNoScriptRunButItsOwnAndFetchesNothing) {
    const std::string page = report_html(test::made_up_comparison());
    EXPECT_THAT(page, HasSubstr("default-src 'none'; script-src 'sha256-"));
    EXPECT_THAT(page, Not(HasSubstr("unsafe-eval")));
    EXPECT_THAT(page, Not(HasSubstr("<link")));
    EXPECT_THAT(page, Not(HasSubstr(" src=\"")));
}

TEST_F(ReportHtml, OfTheBuiltInNetIsSmall) {
    const Study study = test::made_up_study(hilo_quarter(), 50);
    EXPECT_LT(report_html(test::saved(study)).size(), 3'000'000U);
}

}  // namespace
}  // namespace taut
