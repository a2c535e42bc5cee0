// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a survey that is refused without the word that would help, or with a wrong one.

#include "survey/misfit_hint.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <random>

#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class MisfitHint : public testing::Test {
protected:
    const CableNet m_net = hypar(5, 7);

    /// Points on all nodes, 1 mm off, their places multiplied and moved.
    std::vector<SurveyPoint> points(const Eigen::Matrix3d& matrix,
                                    const Eigen::Vector3d& to = Eigen::Vector3d::Zero(),
                                    bool has_names = true) const {
        std::mt19937_64 engine(5);
        std::normal_distribution<double> noise(0.0, 0.001);
        std::vector<SurveyPoint> result;
        for (int node = 0; node < m_net.node_count(); ++node) {
            const Eigen::Vector3d off(noise(engine), noise(engine), noise(engine));
            result.push_back({.id = has_names ? m_net.node_id(node) : "",
                              .position = matrix * (m_net.nodes().col(node) + off) + to,
                              .line = node + 1});
        }
        return result;
    }

    static Eigen::Matrix3d negated(int axis) {
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
        matrix(axis, axis) = -1.0;
        return matrix;
    }

    static Eigen::Matrix3d exchanged() {
        return (Eigen::Matrix3d() << 0, 1, 0, 1, 0, 0, 0, 0, 1).finished();
    }

    /// About the plumb line, as instruments stand.
    static Eigen::Matrix3d turned() {
        return Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    }

    const Eigen::Vector3d m_far{4000.0, -300.0, 12.0};
};

TEST_F(MisfitHint, NamesTheAxesOfAMirroredSurvey) {
    for (const bool has_names : {true, false}) {
        EXPECT_THAT(misfit_hint(m_net, points(exchanged(), {0, 0, 0}, has_names)),
                    AllOf(HasSubstr("the survey is mirrored: its x and y are exchanged"),
                          HasSubstr("in a table by the columns id,y,x,z")));
        EXPECT_THAT(misfit_hint(m_net, points(negated(2), {0, 0, 0}, has_names)),
                    HasSubstr("mirrored: its z has the other sign"));
    }
    EXPECT_THAT(misfit_hint(m_net, points(negated(0))), HasSubstr("its x has the other sign"));
    EXPECT_THAT(misfit_hint(m_net, points(negated(1))), HasSubstr("its y has the other sign"));
}

TEST_F(MisfitHint, NamesThemInAnyFrame) {
    EXPECT_THAT(misfit_hint(m_net, points(turned() * exchanged(), m_far), 1.0, true),
                HasSubstr("its x and y are exchanged"));
    EXPECT_THAT(misfit_hint(m_net, points(turned() * negated(2), m_far), 1.0, true),
                HasSubstr("its z has the other sign"));
    EXPECT_THAT(misfit_hint(m_net, points(1e3 * turned() * exchanged(), m_far), 1.0, true),
                AllOf(HasSubstr("its x and y are exchanged"), HasSubstr("give the unit mm")));
}

TEST_F(MisfitHint, NamesTheUnit) {
    const auto in = [&](double unit, double taken_for, bool has_names) {
        return misfit_hint(m_net,
                           points(taken_for / unit * Eigen::Matrix3d::Identity(),
                                  has_names ? m_far : Eigen::Vector3d::Zero(), has_names),
                           taken_for, true);
    };
    for (const bool has_names : {true, false}) {
        EXPECT_EQ(in(1e-3, 1.0, has_names),
                  "; its coordinates are in millimetres, not in metres: give the unit mm");
        EXPECT_EQ(in(0.3048, 1.0, has_names),
                  "; its coordinates are in feet, not in metres: give the unit ft");
        EXPECT_EQ(in(0.0254, 1e-3, has_names),
                  "; its coordinates are in inches, not in millimetres: give the unit in");
        EXPECT_EQ(in(1.0, 0.3048, has_names),
                  "; its coordinates are in metres, not in feet: give the unit m");
    }
}

TEST_F(MisfitHint, NamesAScaleThatIsNoUnit) {
    EXPECT_THAT(misfit_hint(m_net, points(1.05 * turned(), m_far), 1.0, true),
                AllOf(HasSubstr("its points are 1.05 times"), HasSubstr("which no unit explains"),
                      Not(HasSubstr("give the unit"))));
}

TEST_F(MisfitHint, NamesAnotherFrameWhereNoneIsFitted) {
    EXPECT_THAT(misfit_hint(m_net, points(turned(), m_far)), HasSubstr("it is in another frame"));
    EXPECT_EQ(misfit_hint(m_net, points(turned(), m_far), 1.0, true), "");
}

TEST_F(MisfitHint, NamesLinesOfTwoUnits) {
    std::vector<SurveyPoint> mixed = points(Eigen::Matrix3d::Identity());
    for (size_t i = 3; i < mixed.size(); i += 2) {
        mixed[i].position *= 1e3;
    }
    EXPECT_EQ(misfit_hint(m_net, mixed),
              "; lines 1 and 4 fit it in two units: expected one for all");
}

TEST_F(MisfitHint, HasNoWordForASurveyThatFitsOrFitsNothing) {
    EXPECT_EQ(misfit_hint(m_net, points(Eigen::Matrix3d::Identity())), "");
    EXPECT_EQ(misfit_hint(m_net, {}), "");
    std::vector<SurveyPoint> other = points(Eigen::Matrix3d::Identity());
    std::mt19937_64 engine(9);
    std::ranges::shuffle(other, engine);
    for (size_t i = 0; i < other.size(); ++i) {
        other[i].id = m_net.node_id(static_cast<int>(i));
        other[i].position *= 1.7;
    }
    EXPECT_EQ(misfit_hint(m_net, other), "");
}

}  // namespace
}  // namespace taut
