// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against figures that no program opens, that are too large for a page, or that leave out
// what they should show.

#include "taut/report/figures_svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "report/colour_bar.hpp"
#include "report/figures.hpp"
#include "report/markup_tree.hpp"
#include "support/studies.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The data of the first path of a style.
std::string path(const std::string& svg, const std::string& style) {
    for (const test::Tree& element : test::elements(test::parse_xml(svg), "path")) {
        if (element.get<std::string>("<xmlattr>.class") == style &&
            element.get<std::string>("<xmlattr>.d").find('h') != std::string::npos) {
            return element.get<std::string>("<xmlattr>.d");
        }
    }
    return "";
}

std::map<std::string, std::string> figures_of(const ResultFile& result) {
    const auto files = figures_svg(result);
    return {files.begin(), files.end()};
}

std::vector<std::string> names_of(const ResultFile& result) {
    std::vector<std::string> names;
    for (const auto& [name, content] : figures_svg(result)) {
        names.push_back(name);
    }
    return names;
}

class StudyFigures : public ::testing::Test {
protected:
    const Study m_study = test::made_up_study(hypar(5, 6));
    const ResultFile m_result = test::saved(m_study);
    const std::map<std::string, std::string> m_figures = figures_of(m_result);
};

TEST_F(StudyFigures, AreNamedAsPromised) {
    EXPECT_THAT(names_of(m_result),
                ::testing::ElementsAre("net_view.svg", "net_plan.svg", "length_deviations.svg",
                                       "length_errors.svg", "form_error_nominal.svg",
                                       "form_error_identified.svg"));
}

TEST_F(StudyFigures, AreWellFormedAndStandAlone) {
    for (const auto& [name, svg] : m_figures) {
        const test::Tree tree = test::parse_xml(svg);
        EXPECT_EQ(tree.get<std::string>("svg.<xmlattr>.xmlns"), "http://www.w3.org/2000/svg");
        // That name, which nothing fetches, is the only address.
        EXPECT_EQ(svg.find("http"), svg.rfind("http")) << name;
        EXPECT_THAT(svg, Not(HasSubstr("href"))) << name;
        EXPECT_THAT(svg, Not(HasSubstr("<script"))) << name;
        EXPECT_FALSE(test::elements(tree, "style").empty()) << name;
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
        for (const test::Tree& element :
             test::elements(test::parse_xml(m_figures.at(name)), "path")) {
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
        for (const test::Tree& element :
             test::elements(test::parse_xml(m_figures.at(name)), "path")) {
            if (element.get<std::string>("<xmlattr>.class") == "level") {
                dots += std::ranges::count(element.get<std::string>("<xmlattr>.d"), 'h');
            }
        }
        EXPECT_EQ(dots, m_study.net.free_node_count()) << name;
    }
}

TEST_F(StudyFigures, StayWithinTheirDrawing) {
    for (const report::Figure& figure : report::result_figures(m_result)) {
        for (const report::Drawing& drawing : figure.drawings) {
            const test::Tree tree = test::parse_xml(report::inline_svg(drawing));
            for (const test::Tree& element : test::elements(tree, "text")) {
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

TEST_F(StudyFigures, ShowBothFormErrorsOnOneScale) {
    // The largest mark of the colour bar stands beside both maps.
    EXPECT_THAT(m_figures.at("form_error_nominal.svg"), HasSubstr(">10<"));
    EXPECT_THAT(m_figures.at("form_error_identified.svg"), HasSubstr(">10<"));
}

TEST(StudyFiguresOf, ErrorsThatWereNotSavedShowTheirStatisticsStill) {
    ResultFile study = test::saved(test::made_up_study(hypar(5, 6)));
    auto& content = std::get<StudyResult>(study.content);
    content.errors.resize(content.errors.rows(), 0);
    const std::string svg = figures_of(study).at("length_errors.svg");
    EXPECT_EQ(path(svg, "all-errors"), "") << "no dots";
    EXPECT_THAT(svg, HasSubstr("class=\"mean\""));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(IdentificationFigures, AreNamedAsPromisedAndLeaveOutWhatIsNotThere) {
    EXPECT_THAT(names_of(test::made_up_identification(hypar(5, 6))),
                ::testing::ElementsAre("net_view.svg", "net_plan.svg", "length_intervals.svg",
                                       "residual_map.svg"));
}

TEST(IdentificationFigures, TellASlackEdgeFromAnIdentifiedOne) {
    const auto figures = figures_of(test::made_up_identification(hypar(5, 6)));
    EXPECT_THAT(figures.at("length_intervals.svg"), HasSubstr(">slack: at least<"));
    EXPECT_THAT(figures.at("length_intervals.svg"), HasSubstr(">identified<"));
    EXPECT_THAT(figures.at("length_intervals.svg"), Not(HasSubstr(">unobserved<")));
}

TEST(IdentificationFigures, CountEveryStandardisedResidual) {
    ResultFile result = test::made_up_identification(hypar(5, 6));
    auto& content = std::get<IdentificationResult>(result.content);
    for (auto& residual : content.residuals) {
        residual.standardised = Eigen::Vector3d(0.1, -0.3, 40.0);
    }
    const report::Figure figure = report::residual_histogram_figure(content);
    ASSERT_EQ(figure.drawings.size(), 1U);
    EXPECT_THAT(figure.caption, HasSubstr("90 coordinates"));
    EXPECT_THAT(figure.caption, HasSubstr("30 lie beyond three"));
}

TEST(IdentificationFigures, MeasureTheTargetsInUseAlone) {
    ResultFile result = test::made_up_identification(hypar(5, 6));
    auto& content = std::get<IdentificationResult>(result.content);
    for (auto& residual : content.residuals) {
        residual.surveyed_less_predicted = {0.0, 3e-3, 4e-3};
        residual.standardised = Eigen::Vector3d(0.0, 3.1, 4.0);
    }
    content.residuals[7].surveyed_less_predicted = {0.0, 0.0, 49.1e-3};
    content.residuals[7].is_in_use = false;
    const report::Figure map = report::residual_map_figure(content);
    EXPECT_THAT(map.caption, HasSubstr("of 29 nodes"));
    EXPECT_THAT(map.caption, HasSubstr("5.00 mm RMS, at most 5.00 mm."));
    EXPECT_THAT(map.caption, HasSubstr("1 target left out for gross errors, up to 49.1 mm away."));
    EXPECT_THAT(map.drawings.front().body, HasSubstr("class=\"marked\""));
    EXPECT_THAT(map.drawings.front().body, Not(HasSubstr(">40<"))) << "on the colour scale";
    const report::Figure histogram = report::residual_histogram_figure(content);
    EXPECT_THAT(histogram.caption, HasSubstr("87 coordinates"));
    EXPECT_THAT(histogram.caption, HasSubstr("58 lie beyond three"));
    EXPECT_THAT(histogram.caption, HasSubstr("Not among them: 1 target left out"));
}

TEST(IdentificationFigures, ShowOfASlackEdgeItsBoundAndNoEstimate) {
    ResultFile result = test::made_up_identification(hypar(5, 6));
    auto& content = std::get<IdentificationResult>(result.content);
    IdentifiedEdge& slack = content.edges.front();
    slack.lower = 1e-3;
    slack.upper = 9e-3;
    slack.length_deviation = 8e-3;
    const std::string before = report::length_interval_figure(content).drawings.front().body;
    slack.length_deviation = 2e-3;
    const report::Figure figure = report::length_interval_figure(content);
    EXPECT_EQ(figure.drawings.front().body, before);
    EXPECT_THAT(figure.caption, HasSubstr("of 48 interior edges in tension"));
    EXPECT_THAT(figure.caption, HasSubstr("the widest goes 0.200 mm"));
    EXPECT_THAT(figure.caption, HasSubstr("Of 1 slack edge only a lower bound is known"));
}

TEST(ComparisonFigures, DrawEachMethodAndTheBestPossible) {
    const auto figures = figures_of(test::made_up_comparison());
    ASSERT_EQ(figures.size(), 2U);
    EXPECT_THAT(figures.at("error_over_noise.svg"), HasSubstr(">gp<"));
    EXPECT_THAT(figures.at("error_over_noise.svg"), HasSubstr(">balance<"));
    EXPECT_THAT(figures.at("error_over_noise.svg"), HasSubstr(">best possible<"));
    EXPECT_THAT(figures.at("error_over_training.svg"), HasSubstr(">900<"));
}

TEST(ComparisonFigures, DrawErrorsOverHiddenNodesWhereTheyWereVaried) {
    ResultFile result = test::made_up_comparison();
    auto& rows = std::get<ComparisonResult>(result.content).rows;
    const auto hide = [&](const char* method, double noise, double hidden, double mse) {
        rows.push_back({.method = method, .noise = noise, .mse = mse, .hidden_fraction = hidden});
    };
    hide("balance", 1e-4, 0.0, 3e-8);
    hide("map", 1e-4, 0.0, 2e-8);
    hide("map", 1e-4, 0.1, 4e-8);
    hide("map", 1e-4, 0.3, 9e-8);
    const auto figures = figures_of(result);
    ASSERT_EQ(figures.size(), 3U);
    const std::string& svg = figures.at("error_over_hidden.svg");
    EXPECT_THAT(svg, HasSubstr("nodes not surveyed [%], at a noise of 0.1 mm"));
    for (const char* share : {">0<", ">10<", ">30<"}) {
        EXPECT_THAT(svg, HasSubstr(share));
    }
    EXPECT_THAT(svg, HasSubstr(">map<"));
}

TEST(ComparisonFigures, KeepWhatIsFarBelowTheScaleApartFromTheCurves) {
    // balance is at 1e-9 mm without noise.
    ResultFile result = test::made_up_comparison();
    const report::Figure figure =
        report::comparison_figure(std::get<ComparisonResult>(result.content));
    const std::string& body = figure.drawings.front().body;
    EXPECT_THAT(body, HasSubstr("10⁻⁹ mm"));
    const auto y_of = [](const std::string& text, size_t at) {
        return std::stod(text.substr(text.find(" y=\"", text.rfind("<text", at)) + 4));
    };
    // y grows downwards; of the ticks 0.2 is the lowest.
    EXPECT_GT(y_of(body, body.find("10⁻⁹ mm")), y_of(body, body.find(">0.2<")) + 10.0);
}

TEST(StudyFiguresOf, TheBuiltInNetAreSmallEnoughForAPage) {
    std::size_t bytes = 0;
    for (const auto& [name, svg] :
         figures_of(test::saved(test::made_up_study(hilo_quarter(), 50)))) {
        bytes += svg.size();
    }
    EXPECT_LT(bytes, 350'000U);
}

TEST(StudyFiguresOf, ALargeNetAreThinnedOutAndSaySo) {
    const ResultFile study = test::saved(test::made_up_study(hypar(75, 75), 2));
    ASSERT_GT(std::get<StudyResult>(study.content).net.interior_edge_count(), 10'000);
    std::size_t bytes = 0;
    for (const auto& [name, svg] : figures_of(study)) {
        bytes += svg.size();
    }
    EXPECT_LT(bytes, 1'500'000U);
    for (const report::Figure& figure : report::result_figures(study)) {
        EXPECT_THAT(figure.caption, HasSubstr("So that the page stays small, only"))
            << figure.heading;
    }
}

TEST(StudyFiguresOf, ManyValidationSamplesAreThinnedOut) {
    const ResultFile study = test::saved(test::made_up_study(hypar(5, 6), 2000));
    const report::Figure figure = report::length_error_figure(std::get<StudyResult>(study.content));
    EXPECT_LT(figure.drawings.front().body.size(), 300'000U);
    EXPECT_THAT(figure.caption, HasSubstr("of 49 edges are drawn"));
}

TEST(StudyFiguresOf, ASmallNetAreNotThinnedOut) {
    for (const report::Figure& figure :
         report::result_figures(test::saved(test::made_up_study(hypar(5, 6))))) {
        EXPECT_THAT(figure.caption, Not(HasSubstr("stays small"))) << figure.heading;
    }
}

/// All that is written in a drawing but its heading.
std::vector<std::string> labels(const std::string& svg) {
    std::vector<std::string> texts;
    for (const test::Tree& element : test::elements(test::parse_xml(svg), "text")) {
        texts.push_back(element.data());
    }
    texts.erase(texts.begin());
    return texts;
}

TEST(PlanFigures, ShowBeforeAndAfterOnOneScale) {
    const CableNet net = hypar(5, 6);
    const ResultFile plan = test::made_up_plan(net);
    EXPECT_THAT(names_of(plan),
                ::testing::ElementsAre("plan_normal_built.svg", "plan_normal_planned.svg",
                                       "plan_distance_built.svg", "plan_distance_planned.svg",
                                       "plan_tensions.svg"));
    const auto figures = figures_of(plan);
    for (const std::string name :
         {"plan_normal_built.svg", "plan_normal_planned.svg", "plan_distance_planned.svg"}) {
        EXPECT_EQ(labels(figures.at(name)), labels(figures.at("plan_distance_built.svg"))) << name;
    }
    // Only where the net is farthest from its target is the brightest colour.
    const std::string brightest =
        "stroke:" + report::ColourBar::colour_of(report::ColourBar::levels - 1);
    EXPECT_THAT(figures.at("plan_distance_built.svg"), HasSubstr(brightest));
    EXPECT_THAT(figures.at("plan_distance_planned.svg"), Not(HasSubstr(brightest)));
    EXPECT_THAT(figures.at("plan_normal_built.svg"), Not(HasSubstr(brightest)));
}

TEST(PlanFigures, DrawEveryTensionAndMarkThoseBeyondTheirLimit) {
    const CableNet net = hypar(5, 6);
    const ResultFile plan = test::made_up_plan(net);
    const std::string svg = figures_of(plan).at("plan_tensions.svg");
    const auto& tensions = std::get<PlanResult>(plan.content).tensions;
    const long beyond = std::ranges::count_if(
        tensions, [](const auto& t) { return t.limit_upper && t.planned > *t.limit_upper; });
    ASSERT_GT(beyond, 0);
    // The legend has a mark of each style, which path() passes over or finds first.
    const auto dots = [&](const std::string& style) {
        long most = 0;
        for (const test::Tree& element : test::elements(test::parse_xml(svg), "path")) {
            if (element.get<std::string>("<xmlattr>.class") == style) {
                const auto data = element.get<std::string>("<xmlattr>.d");
                most = std::max<long>(most, std::ranges::count(data, 'h'));
            }
        }
        return most;
    };
    EXPECT_EQ(dots("true"), net.edge_count());
    EXPECT_EQ(dots("predicted"), net.edge_count() - beyond);
    EXPECT_EQ(dots("error"), beyond);
    EXPECT_THAT(svg, HasSubstr("beyond a limit"));
    EXPECT_THAT(svg, HasSubstr(">tension [kN]<"));
}

TEST(PlanFigures, WithoutDrawsShowNoIntervals) {
    const auto figures = figures_of(test::made_up_plan(hypar(3, 4), 0));
    EXPECT_THAT(figures.at("plan_tensions.svg"), Not(HasSubstr("95 % interval")));
}

/// Numbers of dots and of lines that begin anew, of the longest path of a style.
std::pair<long, long> longest_path(const std::string& svg, const std::string& style) {
    std::pair<long, long> most;
    for (const test::Tree& element : test::elements(test::parse_xml(svg), "path")) {
        if (element.get<std::string>("<xmlattr>.class") == style) {
            const auto data = element.get<std::string>("<xmlattr>.d");
            most.first = std::max<long>(most.first, std::ranges::count(data, 'h'));
            most.second = std::max<long>(most.second, std::ranges::count_if(data, [](char c) {
                                             return c == 'm' || c == 'M';
                                         }));
        }
    }
    return most;
}

TEST(ControlFigures, DrawEveryStrategyAfterEveryRound) {
    const ResultFile control = test::made_up_control(hypar(3, 4));
    EXPECT_THAT(names_of(control), ::testing::ElementsAre("control_form.svg", "control_limits.svg",
                                                          "control_strokes.svg"));
    const auto figures = figures_of(control);
    for (const std::string style : {"best", "series0", "series1", "series5"}) {
        EXPECT_EQ(longest_path(figures.at("control_form.svg"), style).first, 3) << style;
        EXPECT_EQ(longest_path(figures.at("control_limits.svg"), style).first, 3) << style;
        EXPECT_EQ(longest_path(figures.at("control_strokes.svg"), style).first, 2) << style;
    }
    EXPECT_THAT(figures.at("control_form.svg"), HasSubstr(">along the normal, RMS [mm]<"));
    EXPECT_THAT(figures.at("control_form.svg"), HasSubstr(">as built<"));
    EXPECT_THAT(figures.at("control_limits.svg"), HasSubstr(">jobs with a broken limit [%]<"));
    EXPECT_THAT(figures.at("control_limits.svg"), HasSubstr(">100<")) << "of those on the design";
    EXPECT_THAT(figures.at("control_strokes.svg"), HasSubstr(">strokes of a round, in all [mm]<"));
    EXPECT_THAT(figures.at("control_strokes.svg"), Not(HasSubstr(">as built<")));
}

TEST(ControlFigures, TellTheSpreadOfJobsAndThePlansThatFailed) {
    const auto captions = [](int trials) {
        const ResultFile result = test::made_up_control(hypar(3, 4), 2, trials);
        return report::control_form_figure(std::get<ControlResult>(result.content)).caption;
    };
    EXPECT_THAT(captions(5), HasSubstr("the middle half of the jobs. Where nothing could be"));
    EXPECT_THAT(captions(5), HasSubstr("1 time over all jobs"));
    EXPECT_THAT(captions(3), HasSubstr("from the least to the most of a job."));
    EXPECT_THAT(captions(1), HasSubstr("nothing is told of how much jobs differ"));
}

TEST(ControlFigures, OfOneRoundOrWithoutAnyDistanceAreDrawnStill) {
    ResultFile result = test::made_up_control(hypar(3, 4), 1, 1);
    for (auto& strategy : std::get<ControlResult>(result.content).strategies) {
        for (auto& round : strategy.rounds) {
            round = {.normal_rmse_of_trials = {0.0}};
        }
    }
    for (const auto& [name, svg] : figures_of(result)) {
        EXPECT_NO_THROW(static_cast<void>(test::parse_xml(svg)));
        EXPECT_THAT(svg, Not(HasSubstr("nan"))) << name;
        EXPECT_THAT(svg, Not(HasSubstr("inf"))) << name;
        EXPECT_THAT(svg, HasSubstr(">1<")) << name;
    }
}

TEST(ControlFigures, StandADistanceOfNoneAtTheLowerEdge) {
    ResultFile result = test::made_up_control(hypar(3, 4));
    auto& rounds = std::get<ControlResult>(result.content).strategies.front().rounds;
    rounds.back().normal_rmse = 0.0;
    rounds.back().normal_rmse_of_trials.assign(5, 0.0);
    const std::string svg = figures_of(result).at("control_form.svg");
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
    EXPECT_THAT(svg, HasSubstr(">0.1<")) << "on the axis";
}

}  // namespace
}  // namespace taut
