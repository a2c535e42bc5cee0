// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against figures that no program opens, that are too large for a page, or that leave out
// what they should show.

#include "taut/report/study_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "report/figures.hpp"
#include "report/markup_tree.hpp"
#include "report/studies.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The data of the first path of a style.
std::string path(const std::string& svg, const std::string& style) {
    for (const testing::Tree& element : testing::elements(testing::parse_xml(svg), "path")) {
        if (element.get<std::string>("<xmlattr>.class") == style &&
            element.get<std::string>("<xmlattr>.d").find('h') != std::string::npos) {
            return element.get<std::string>("<xmlattr>.d");
        }
    }
    return "";
}

std::map<std::string, std::string> figures_of(const Study& study) {
    const auto files = study_figures_svg(study);
    return {files.begin(), files.end()};
}

class StudyFigures : public ::testing::Test {
protected:
    const Study m_study = testing::made_up_study(hypar(5, 6));
    const std::map<std::string, std::string> m_figures = figures_of(m_study);
};

TEST_F(StudyFigures, AreNamedAsPromised) {
    std::vector<std::string> names;
    for (const auto& [name, content] : study_figures_svg(m_study)) {
        names.push_back(name);
    }
    EXPECT_THAT(names,
                ::testing::ElementsAre("net_view.svg", "net_plan.svg", "length_deviations.svg",
                                       "length_errors.svg", "form_error_nominal.svg",
                                       "form_error_identified.svg"));
}

TEST_F(StudyFigures, AreWellFormedAndStandAlone) {
    for (const auto& [name, svg] : m_figures) {
        const testing::Tree tree = testing::parse_xml(svg);
        EXPECT_EQ(tree.get<std::string>("svg.<xmlattr>.xmlns"), "http://www.w3.org/2000/svg");
        // That name, which nothing fetches, is the only address.
        EXPECT_EQ(svg.find("http"), svg.rfind("http")) << name;
        EXPECT_THAT(svg, Not(HasSubstr("href"))) << name;
        EXPECT_THAT(svg, Not(HasSubstr("<script"))) << name;
        EXPECT_FALSE(testing::elements(tree, "style").empty()) << name;
    }
}

TEST_F(StudyFigures, NameTheirUnits) {
    EXPECT_THAT(m_figures.at("net_plan.svg"), HasSubstr(">x [m]<"));
    EXPECT_THAT(m_figures.at("net_plan.svg"), HasSubstr(">y [m]<"));
    EXPECT_THAT(m_figures.at("length_deviations.svg"), HasSubstr(">length deviation [mm]<"));
    EXPECT_THAT(m_figures.at("length_deviations.svg"), HasSubstr(">interior edge i<"));
    EXPECT_THAT(m_figures.at("length_errors.svg"), HasSubstr(">error [mm]<"));
    EXPECT_THAT(m_figures.at("form_error_nominal.svg"), HasSubstr(">nominal form error [mm]<"));
    EXPECT_THAT(m_figures.at("form_error_identified.svg"),
                HasSubstr(">identified form error [mm]<"));
}

TEST_F(StudyFigures, DrawEveryNodeAndEdgeOfASmallNet) {
    const CableNet& net = m_study.net;
    for (const std::string name : {"net_view.svg", "net_plan.svg"}) {
        std::map<std::string, long> lines;
        std::map<std::string, long> dots;
        for (const testing::Tree& element :
             testing::elements(testing::parse_xml(m_figures.at(name)), "path")) {
            const auto style = element.get<std::string>("<xmlattr>.class");
            const auto data = element.get<std::string>("<xmlattr>.d");
            // The legend comes first; what is drawn replaces its marks.
            lines[style] = std::ranges::count(data, 'l');
            dots[style] = std::ranges::count(data, 'h');
        }
        EXPECT_EQ(lines["interior"], net.interior_edge_count()) << name;
        EXPECT_EQ(lines["adjustable"], static_cast<long>(net.adjustable_edges().size())) << name;
        EXPECT_EQ(dots["free"], net.free_node_count()) << name;
        EXPECT_EQ(dots["support"], 2 * static_cast<long>(net.supports().size())) << name;
    }
}

TEST_F(StudyFigures, DrawEveryEdgesTrueIdentifiedAndErroneousLength) {
    const std::string& svg = m_figures.at("length_deviations.svg");
    for (const std::string style : {"true", "predicted", "error"}) {
        EXPECT_EQ(std::ranges::count(path(svg, style), 'h'), m_study.net.interior_edge_count())
            << style;
    }
}

TEST_F(StudyFigures, DrawEveryErrorThatCanBeToldApart) {
    const long dots =
        std::ranges::count(path(m_figures.at("length_errors.svg"), "all-errors"), 'h');
    const long errors = static_cast<long>(m_study.estimates.mean.size());
    EXPECT_LE(dots, errors);
    EXPECT_GT(dots, 9 * errors / 10);
}

TEST_F(StudyFigures, ColourEveryFreeNode) {
    for (const std::string name : {"form_error_nominal.svg", "form_error_identified.svg"}) {
        long dots = 0;
        for (const testing::Tree& element :
             testing::elements(testing::parse_xml(m_figures.at(name)), "path")) {
            if (element.get<std::string>("<xmlattr>.class") == "level") {
                dots += std::ranges::count(element.get<std::string>("<xmlattr>.d"), 'h');
            }
        }
        EXPECT_EQ(dots, m_study.net.free_node_count()) << name;
    }
}

TEST_F(StudyFigures, StayWithinTheirDrawing) {
    for (const report::Figure& figure : report::study_figures(m_study)) {
        for (const report::Drawing& drawing : figure.drawings) {
            const testing::Tree tree = testing::parse_xml(report::inline_svg(drawing));
            for (const testing::Tree& element : testing::elements(tree, "text")) {
                const double x = element.get<double>("<xmlattr>.x", 0.0);
                const double y = element.get<double>("<xmlattr>.y", 10.0);
                EXPECT_GE(x, 0.0) << drawing.name;
                EXPECT_LE(x, drawing.width) << drawing.name;
                EXPECT_GE(y, 10.0) << drawing.name;
                EXPECT_LE(y, drawing.height) << drawing.name;
            }
        }
    }
}

TEST(StudyFiguresOf, TheBuiltInNetAreSmallEnoughForAPage) {
    std::size_t bytes = 0;
    for (const auto& [name, svg] : figures_of(testing::made_up_study(hilo_quarter(), 50))) {
        bytes += svg.size();
    }
    EXPECT_LT(bytes, 350'000U);
}

TEST(StudyFiguresOf, ALargeNetAreThinnedOutAndSaySo) {
    const Study study = testing::made_up_study(hypar(75, 75), 2);
    ASSERT_GT(study.net.interior_edge_count(), 10'000);
    std::size_t bytes = 0;
    for (const auto& [name, svg] : figures_of(study)) {
        bytes += svg.size();
    }
    EXPECT_LT(bytes, 1'500'000U);
    for (const report::Figure& figure : report::study_figures(study)) {
        EXPECT_THAT(figure.caption, HasSubstr("So that the page stays small, only"))
            << figure.heading;
    }
}

TEST(StudyFiguresOf, ManyValidationSamplesAreThinnedOut) {
    const report::Figure figure =
        report::length_error_figure(testing::made_up_study(hypar(5, 6), 2000));
    EXPECT_LT(figure.drawings.front().body.size(), 300'000U);
    EXPECT_THAT(figure.caption, HasSubstr("of 49 edges are drawn"));
}

TEST(StudyFiguresOf, ASmallNetAreNotThinnedOut) {
    for (const report::Figure& figure :
         report::study_figures(testing::made_up_study(hypar(5, 6)))) {
        EXPECT_THAT(figure.caption, Not(HasSubstr("stays small"))) << figure.heading;
    }
}

}  // namespace
}  // namespace taut
