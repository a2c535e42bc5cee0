// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a page that tells other numbers than the study's, runs what stands in a net's
// name, needs more than itself, or shows what is no number.

#include "taut/report/study_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/markup_tree.hpp"
#include "report/studies.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string page_of(const Study& study) {
    return study_report_html(study, "1.2.3", "2026-02-03 04:05 UTC");
}

/// A number as the page writes it: "−2.07×10⁻⁸".
double number(std::string_view text) {
    constexpr std::pair<std::string_view, char> signs[] = {
        {"×10", 'e'}, {"⁻", '-'}, {"−", '-'}, {"⁰", '0'}, {"¹", '1'}, {"²", '2'}, {"³", '3'},
        {"⁴", '4'},   {"⁵", '5'}, {"⁶", '6'}, {"⁷", '7'}, {"⁸", '8'}, {"⁹", '9'}};
    std::string plain;
    while (!text.empty()) {
        const auto* sign = std::ranges::find_if(
            signs, [&](const auto& candidate) { return text.starts_with(candidate.first); });
        const bool found = sign != std::end(signs);
        plain += found ? sign->second : text.front();
        text.remove_prefix(found ? sign->first.size() : 1);
    }
    return std::stod(plain);
}

/// The cells of the only table row with some head.
std::vector<std::string> cells(const std::string& page, const std::string& head) {
    std::vector<std::string> found;
    int rows = 0;
    for (const testing::Tree& row : testing::elements(testing::parse_xml(page), "tr")) {
        const auto heads = testing::elements(row, "th");
        if (!heads.empty() && testing::text_of(heads.front()) == head) {
            ++rows;
            for (const testing::Tree& cell : testing::elements(row, "td")) {
                found.push_back(testing::text_of(cell));
            }
        }
    }
    EXPECT_EQ(rows, 1) << head;
    return found;
}

/// Each number with three significant digits.
void expect_numbers(const std::vector<std::string>& texts, const std::vector<double>& expected) {
    ASSERT_EQ(texts.size(), expected.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_NEAR(number(texts[i]), expected[i], 0.00501 * std::abs(expected[i])) << texts[i];
    }
}

class StudyReport : public ::testing::Test {
protected:
    const Study m_study = testing::made_up_study(hypar(3, 4));
    const std::string m_page = page_of(m_study);
};

TEST_F(StudyReport, TellsTheErrorsOfTheLengthsBesideThePapers) {
    const LengthErrors& errors = m_study.gp_as_in_paper.errors;
    expect_numbers(cells(m_page, "mean squared error, MSE [m²]"), {1.7e-8, errors.mse});
    expect_numbers(cells(m_page, "mean relative squared error, MRSE [%]"),
                   {0.2, 100.0 * errors.mrse});
    EXPECT_THAT(cells(m_page, "largest mean error of an edge [mm]")[0], "–");
    EXPECT_NEAR(number(cells(m_page, "largest mean error of an edge [mm]")[1]),
                1e3 * errors.mean_max_abs(), 1e-4);
    EXPECT_NEAR(number(cells(m_page, "standard deviation, mean of the edges [mm]")[1]),
                1e3 * errors.std_mean(), 1e-3);
    EXPECT_THAT(cells(m_page, "true lengths inside their 95 % interval [%]"),
                ElementsAre("–", "94.2"));
}

TEST_F(StudyReport, TellsTheFormErrorsInMillimetresBesideThePapers) {
    const auto expect_row = [&](const std::string& name, double FormErrorSummary::* value,
                                double paper_nominal, double paper_identified) {
        const auto& [first, mean] = std::pair(m_study.form_errors, m_study.mean_form_errors);
        expect_numbers(
            cells(m_page, name),
            {paper_nominal, 1e3 * (first.nominal.*value), 1e3 * (mean.nominal.*value),
             paper_identified, 1e3 * (first.identified.*value), 1e3 * (mean.identified.*value)});
    };
    // The numbers of the paper's table, there in 1e-4 m.
    expect_row("max", &FormErrorSummary::max, 13.8, 0.776);
    expect_row("min", &FormErrorSummary::min, 0.193, 0.0194);
    expect_row("mean", &FormErrorSummary::mean, 4.7, 0.273);
    expect_row("RMSE", &FormErrorSummary::rmse, 5.3, 0.315);
}

TEST_F(StudyReport, TellsTheSettingsAndWhatBecameOfTheSamples) {
    EXPECT_THAT(cells(m_page, "law of the length deviations"), ElementsAre("uniform:5mm"));
    EXPECT_THAT(cells(m_page, "seed"), ElementsAre("7"));
    EXPECT_THAT(cells(m_page, "samples drawn"), ElementsAre("10"));
    EXPECT_THAT(cells(m_page, "of these trained on"), ElementsAre("5"));
    EXPECT_THAT(cells(m_page, "of these validated on"), ElementsAre("5"));
    EXPECT_THAT(cells(m_page, "with slack edges"), ElementsAre("1"));
    EXPECT_THAT(cells(m_page, "not converged"), ElementsAre("1"));
    EXPECT_THAT(cells(m_page, "taut"), ElementsAre("1.2.3"));
    EXPECT_THAT(cells(m_page, "date"), ElementsAre("2026-02-03 04:05 UTC"));
    EXPECT_THAT(cells(m_page, "sampling"), ElementsAre("1.23 s"));
    EXPECT_THAT(cells(m_page, "training"), ElementsAre("4.56 s"));
    EXPECT_THAT(cells(m_page, "identification"), ElementsAre("0.789 s"));
    EXPECT_THAT(cells(m_page, "in all"), ElementsAre("6.58 s"));
}

TEST_F(StudyReport, SaysInSentencesWhatWasDone) {
    std::string text;
    for (const testing::Tree& paragraph : testing::elements(testing::parse_xml(m_page), "p")) {
        text += testing::text_of(paragraph) + '\n';
    }
    EXPECT_THAT(text, AllOf(HasSubstr("12 free nodes"), HasSubstr("14 supports"),
                            HasSubstr("17 interior edges"), HasSubstr("14 adjustable edges")));
    EXPECT_THAT(text, AllOf(HasSubstr("uniformly within ±5 mm"), HasSubstr("10 samples")));
    EXPECT_THAT(text, HasSubstr("from 6.10 mm with nominal lengths to 0.425 mm"));
}

TEST_F(StudyReport, SaysWhenThePapersNetIsAnotherOne) {
    EXPECT_THAT(m_page, HasSubstr("another one: it has 300 free nodes and 536 interior edges"));
    const std::string same_counts = page_of(testing::made_up_study(hilo_quarter()));
    EXPECT_THAT(same_counts, Not(HasSubstr("another one")));
    EXPECT_THAT(same_counts, HasSubstr("geometry, which was not published"));
}

TEST_F(StudyReport, NamesEveryLawInWords) {
    Study study = m_study;
    study.settings.law = {LengthLaw::Kind::normal, 0.002};
    EXPECT_THAT(page_of(study), HasSubstr("a standard deviation of 2 mm"));
    study.settings.law = {LengthLaw::Kind::bimodal, 0.0035};
    EXPECT_THAT(page_of(study), HasSubstr("close to −3.5 mm or to +3.5 mm"));
}

TEST_F(StudyReport, IsWellFormedAndHasAllFigures) {
    const testing::Tree page = testing::parse_xml(m_page);
    EXPECT_EQ(testing::elements(page, "figure").size(), 4U);
    EXPECT_EQ(testing::elements(page, "figcaption").size(), 4U);
    EXPECT_EQ(testing::elements(page, "svg").size(), 6U);
}

TEST_F(StudyReport, NeedsNothingButItself) {
    for (const char* const foreign : {"http", "//", "<script", "<link", "<img", "<iframe",
                                      "<object", "url(", "@import", "javascript", "src="}) {
        EXPECT_THAT(m_page, Not(HasSubstr(foreign)));
    }
}

TEST_F(StudyReport, FollowsTheReadersColourSchemeOnScreenOnly) {
    EXPECT_THAT(m_page, HasSubstr("@media screen and (prefers-color-scheme:dark)"));
    EXPECT_THAT(m_page, HasSubstr("@media print"));
}

TEST_F(StudyReport, EscapesTextOfTheNetAndOfItsCaller) {
    const std::string evil = "</title><script>alert(1)</script>\"'&<img onerror=alert(1)>\x01\xFF";
    CableNetData data = hypar(3, 4).data();
    data.name = evil;
    for (int e = 0; e < static_cast<int>(data.edges.size()); ++e) {
        data.edge_ids.push_back(std::to_string(e) + evil);
    }
    for (int node = 0; node < data.nodes.cols(); ++node) {
        data.node_ids.push_back(std::to_string(node) + evil);
    }
    const std::string page = study_report_html(testing::made_up_study(CableNet(data)), evil, evil);
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_THAT(page, Not(HasSubstr("<img")));
    const testing::Tree tree = testing::parse_xml(page);
    const std::string shown = evil.substr(0, evil.size() - 2) + "\uFFFD\uFFFD";
    EXPECT_EQ(testing::text_of(testing::elements(tree, "title").front()),
              shown + ": identified unstressed lengths");
    EXPECT_THAT(cells(page, "taut"), ElementsAre(shown));
    EXPECT_THAT(cells(page, "date"), ElementsAre(shown));
    // The worst edge is named in a caption.
    EXPECT_THAT(testing::text_of(testing::elements(tree, "figcaption")[2]), HasSubstr(shown));
}

void expect_only_numbers(const std::string& page) {
    EXPECT_NO_THROW((void)testing::parse_xml(page));
    EXPECT_THAT(testing::words(page), Not(::testing::Contains(::testing::AnyOf("nan", "inf"))));
}

TEST_F(StudyReport, ShowsNothingThatIsNoNumber) {
    expect_only_numbers(m_page);
    Study broken = m_study;
    broken.gp_as_in_paper.errors.mse = std::numeric_limits<double>::quiet_NaN();
    broken.form_errors.identified.mean = std::numeric_limits<double>::infinity();
    expect_only_numbers(page_of(broken));
}

TEST_F(StudyReport, BearsLengthsThatAreIdentifiedExactly) {
    const std::string page = page_of(testing::made_up_study(hypar(3, 4), 5, 0.0));
    expect_only_numbers(page);
    EXPECT_THAT(cells(page, "mean squared error, MSE [m²]")[1], "0");
    EXPECT_THAT(page, Not(HasSubstr("times smaller")));
}

TEST_F(StudyReport, TellsHowManyTimesSmallerTheFormErrorBecomes) {
    EXPECT_THAT(m_page, HasSubstr("form error 14.4 times smaller"));
    Study worse = m_study;
    std::swap(worse.form_errors.nominal, worse.form_errors.identified);
    EXPECT_THAT(page_of(worse), HasSubstr("form error 14.4 times larger"));
}

TEST(StudyReportOf, OneValidationSampleAndOneInteriorEdge) {
    const std::string page = page_of(run_study(hypar(1, 2), {.samples = 5, .validation = 1}));
    expect_only_numbers(page);
    EXPECT_THAT(page, HasSubstr("the one validation sample"));
    EXPECT_THAT(page, HasSubstr("1 other."));
}

TEST(StudyReportOf, ANetWithSlackEdges) {
    const Study study = run_study(
        hypar(4, 5), {.samples = 40, .validation = 6, .law = {LengthLaw::Kind::uniform, 0.03}});
    ASSERT_GT(study.data.with_slack(), 0);
    const std::string page = page_of(study);
    expect_only_numbers(page);
    EXPECT_THAT(cells(page, "with slack edges"),
                ElementsAre(std::to_string(study.data.with_slack())));
}

TEST(StudyReportOf, ANetWithoutAName) {
    CableNetData data = testing::two_node_net_data();
    data.name.clear();
    const std::string page = page_of(testing::made_up_study(CableNet(data)));
    expect_only_numbers(page);
    EXPECT_THAT(page, HasSubstr("<p>The net has 2 free nodes"));
}

}  // namespace
}  // namespace taut
