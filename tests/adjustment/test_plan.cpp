// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against plans that are not optimal, that break limits they report as kept, or that report
// a higher probability than other samples confirm.
#include "taut/adjustment/plan.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "adjustment/built_nets.hpp"
#include "support/json_numbers.hpp"
#include "support/refusals.hpp"
#include "support/surfaces.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using nlohmann::json;
using test::limits_between;
using test::random_built;
using test::solved_tensions;
using test::strokes_up_to;
using test::vector_of;
using test::with_lengths;
using test::without_draws;

/// Lengths of the built net after a plan.
Eigen::VectorXd lengths_after(const BuiltNet& built, const Plan& plan) {
    Eigen::VectorXd lengths = built.net.unstressed_lengths();
    for (const PlannedStroke& stroke : plan.strokes) {
        lengths(stroke.edge) += stroke.stroke;
    }
    return lengths;
}

Eigen::VectorXd tensions_after(const BuiltNet& built, const Plan& plan) {
    return solved_tensions(built.net, lengths_after(built, plan), built.net.nodes());
}

/// The net of make_plan_reference.py, as built, and its limits.
struct Reference {
    json numbers = json::parse(std::ifstream(TAUT_TEST_DATA_DIR "/plan_reference.json"));
    CableNet net = designed(numbers);
    BuiltNet built = without_draws(with_lengths(net, vector_of(numbers["built"])));
    Limits limits = limits_between(built.net, numbers["stroke"].get<double>(),
                                   numbers["lower"].get<double>(), numbers["upper"].get<double>());
    FormTarget target{net, net.nodes(), {.normal = 1.0, .tangential = 1.0}};

private:
    static CableNet designed(const json& reference);
};

CableNet Reference::designed(const json& reference) {
    CableNetData data;
    data.nodes = test::points_of(reference["nodes"]);
    data.supports = reference["supports"].get<std::vector<int>>();
    data.edges = reference["edges"].get<std::vector<Edge>>();
    data.unstressed_lengths = vector_of(reference["nominal"]);
    data.axial_stiffness = Eigen::VectorXd::Constant(data.unstressed_lengths.size(),
                                                     reference["axial_stiffness"].get<double>());
    data.adjustable = reference["adjustable"].get<std::vector<int>>();
    return CableNet(data);
}

TEST(Plan, AsksWhetherToStopAtEachState) {
    const CableNet net = hypar(4, 5);
    const BuiltNet built = random_built(net, 6, 4e-3);
    const FormTarget target{net, net.nodes(), {.normal = 1.0, .tangential = 1.0}};
    const Limits limits = limits_between(built.net, 0.01, 0.0, 1e9);
    std::atomic<int> asked = 0;
    const auto stop_after = [&](int times) {
        asked = 0;
        return Progress{.stop_requested = [&asked, times] { return ++asked > times; }};
    };
    (void)plan_strokes(built, target, limits, {}, stop_after(1 << 30));
    const int in_all = asked;
    ASSERT_GT(in_all, 6);  // of which plan_strokes() reports 6
    for (const int times : {2, in_all / 2, in_all - 2}) {
        EXPECT_THROW((void)plan_strokes(built, target, limits, {}, stop_after(times)), Interrupted)
            << times;
    }
}

TEST(Plan, IsThatOfAnIndependentOptimiser) {
    const auto [reference, net, built, limits, target] = Reference();
    const Plan plan = plan_strokes(built, target, limits);
    EXPECT_TRUE(plan.has_converged);
    EXPECT_TRUE(plan.is_feasible);
    EXPECT_NEAR(plan.as_built.rmse * plan.as_built.rmse,
                reference["mean_square_as_built"].get<double>(), 1e-11);
    const double best = reference["mean_square"].get<double>();
    EXPECT_NEAR(plan.planned.rmse * plan.planned.rmse, best, 2e-4 * best);
    const Eigen::VectorXd after = tensions_after(built, plan);
    EXPECT_LT((after - plan.tensions).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_LE(plan.largest_stroke(), reference["stroke"].get<double>());
    EXPECT_NEAR(after.minCoeff(), reference["least_tension"].get<double>(), 0.5);
    EXPECT_NEAR(after.maxCoeff(), reference["most_tension"].get<double>(), 0.5);
}

TEST(Plan, ToTensionsIsThatOfAnIndependentOptimiser) {
    const auto [reference, net, built, limits, target] = Reference();
    const json& expected = reference["with_tensions"];
    PlanOptions options{.form_tolerance = expected["form_tolerance"].get<double>()};
    for (const json& one : expected["targets"]) {
        options.target_tensions.push_back({.edge = one["edge"].get<int>(),
                                           .tension = one["tension"].get<double>(),
                                           .tolerance = one["tolerance"].get<double>()});
    }
    const Plan plan = plan_strokes(built, target, limits, options);
    EXPECT_TRUE(plan.has_converged);
    EXPECT_TRUE(plan.is_feasible);
    const auto count = static_cast<double>(plan.target_tensions.size());
    double square = 0.0;
    for (size_t i = 0; i < plan.target_tensions.size(); ++i) {
        const ReachedTension& one = plan.target_tensions[i];
        square += one.deviation() * one.deviation() / count;
        EXPECT_NEAR(one.planned, expected["targets"][i]["reached"].get<double>(),
                    0.05 * one.tolerance);
    }
    EXPECT_GT(square, 1e-3);  // form and tensions contradict each other
    const double best = expected["cost"].get<double>();
    EXPECT_NEAR(std::pow(plan.planned.rmse, 2) + std::pow(*options.form_tolerance, 2) * square,
                best, 2e-4 * best);
}

/// The quadric nearest to a net, with waves [m], finely cut, over all of it and beyond.
std::shared_ptr<const TargetSurface> wavy_surface(const CableNet& net, double wave) {
    constexpr int cells = 80;
    const Eigen::Vector3d low = net.nodes().rowwise().minCoeff();
    const Eigen::Vector3d size = net.nodes().rowwise().maxCoeff() - low;
    // The net's own quadric, a x^2 + b x y + c y^2 + ..., by least squares; then waves on it.
    const auto terms = [&](double x, double y) {
        return Eigen::Vector<double, 6>{{1.0, x, y, x * x, x * y, y * y}};
    };
    Eigen::MatrixXd rows(net.node_count(), 6);
    for (int i = 0; i < net.node_count(); ++i) {
        rows.row(i) = terms(net.nodes()(0, i), net.nodes()(1, i)).transpose();
    }
    const Eigen::VectorXd quadric =
        rows.colPivHouseholderQr().solve(net.nodes().row(2).transpose());
    Points vertices(3, (cells + 1) * (cells + 1));
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            const int at = i * (cells + 1) + j;
            const double x = low.x() + (1.2 * i / cells - 0.1) * size.x();
            const double y = low.y() + (1.2 * j / cells - 0.1) * size.y();
            vertices.col(at) << x, y, quadric.dot(terms(x, y)) + wave * std::sin(3.0 * x);
            if (i < cells && j < cells) {
                triangles.push_back({at, at + cells + 1, at + cells + 2});
                triangles.push_back({at, at + cells + 2, at + 1});
            }
        }
    }
    return std::make_shared<const TargetSurface>(vertices, triangles);
}

TEST(Plan, BringsANetToASurfaceAlongWhichItsNodesMaySlide) {
    const CableNet net = hypar(8, 8);
    const BuiltNet built = random_built(net, 6, 4e-3);
    const auto surface = wavy_surface(net, 10e-3);
    const Limits limits = strokes_up_to(built.net, 15e-3);
    const FormTarget target(net, surface, {.normal = 1.0, .tangential = 0.0});
    const Plan plan = plan_strokes(built, target, limits);
    // The reported deviation is the distance of the planned form from the surface.
    double mean = 0.0;
    double square = 0.0;
    for (const int node : net.free_nodes()) {
        const double distance = surface->nearest(plan.form.col(node)).distance;
        mean += distance / net.free_node_count();
        square += distance * distance / net.free_node_count();
    }
    EXPECT_NEAR(plan.planned.normal_mean, mean, 1e-9);
    EXPECT_NEAR(plan.planned.normal_rmse, std::sqrt(square), 1e-9);
    EXPECT_LT(plan.planned.normal_rmse, 0.8 * plan.as_built.normal_rmse);
    // It is better than the plan for the places where the surface is nearest to the design, and
    // than strokes nearby.
    const Plan fixed = plan_strokes(
        built, FormTarget(net, target.at(net.nodes()).places(), {.normal = 1.0, .tangential = 0.0}),
        limits);
    const FormDeviation of_fixed = deviation_from(target, net, fixed.form);
    EXPECT_LT(plan.planned.normal_rmse, 0.99 * of_fixed.normal_rmse);
    Plan other = plan;
    for (const double change : {-0.2e-3, 0.2e-3}) {
        for (size_t k = 0; k < plan.strokes.size(); k += 5) {
            if (std::abs(plan.strokes[k].stroke) > 14.5e-3) {
                continue;
            }
            other.strokes = plan.strokes;
            other.strokes[k].stroke += change;
            const Eigen::VectorXd lengths = lengths_after(built, other);
            const Points form = EquilibriumSolver(built.net).solve(lengths, plan.form).form;
            EXPECT_GT(deviation_from(target, net, form).normal_rmse,
                      (1.0 - 1e-4) * plan.planned.normal_rmse);
        }
    }
}

TEST(Plan, OfASurfaceHoldsNodesAlongItByTheTangentialWeight) {
    const CableNet net = hypar(6, 6);
    const BuiltNet built = random_built(net, 8, 4e-3);
    const auto surface = test::surface_through(net, net.nodes());
    const Limits limits = strokes_up_to(built.net, 15e-3);
    const auto planned = [&](double tangential) {
        return plan_strokes(
            built, FormTarget(net, surface, {.normal = 1.0, .tangential = tangential}), limits);
    };
    const auto along = [](const Plan& plan) {
        return std::pow(plan.planned.rmse, 2) - std::pow(plan.planned.normal_rmse, 2);
    };
    const Plan loose = planned(0.01);
    const Plan tight = planned(10.0);
    EXPECT_LT(along(tight), along(loose));
    EXPECT_GT(tight.planned.normal_rmse, loose.planned.normal_rmse);
}

TEST(Plan, MinimisesTheLargestDeviationIfAskedTo) {
    const CableNet net = hypar(6, 6);
    const BuiltNet built = random_built(net, 6, 3e-3);
    const Limits limits = strokes_up_to(built.net, 10e-3);
    const DeviationWeights weights{.normal = 1.0, .tangential = 1.0};
    const Plan mean = plan_strokes(built, FormTarget(net, net.nodes(), weights), limits);
    const Plan largest =
        plan_strokes(built, FormTarget(net, net.nodes(), weights, FormObjective::largest), limits);
    EXPECT_LT(largest.planned.max, 0.98 * mean.planned.max);
    EXPECT_GT(largest.planned.rmse, mean.planned.rmse);
    const Plan few = plan_strokes(
        built, FormTarget(net, net.nodes(), weights, FormObjective::largest), limits,
        {.tolerance = 0.5 * (largest.planned.normal_max + largest.as_built.normal_max)});
    EXPECT_TRUE(few.is_within_tolerance.value_or(false));
    EXPECT_LT(few.strokes.size(), largest.strokes.size());
}

TEST(Plan, DependsOnlyOnRatiosOfWeights) {
    const CableNet net = hypar(5, 5);
    const BuiltNet built = random_built(net, 6, 3e-3);
    const Limits limits = strokes_up_to(built.net, 10e-3);
    const auto plan_with = [&](double unit) {
        return plan_strokes(
            built, FormTarget(net, net.nodes(), {.normal = 2.0 * unit, .tangential = 0.5 * unit}),
            limits);
    };
    const Plan plan = plan_with(1.0);
    for (const double unit : {1e-6, 1e6}) {
        const Plan other = plan_with(unit);
        ASSERT_EQ(other.strokes.size(), plan.strokes.size());
        for (size_t i = 0; i < plan.strokes.size(); ++i) {
            EXPECT_NEAR(other.strokes[i].stroke, plan.strokes[i].stroke, 1e-9);
        }
    }
}

TEST(Plan, HasTheLeastViolationWhereLimitsCannotBeKept) {
    const CableNet net = hypar(4, 4);
    const BuiltNet built = random_built(net, 1, 2e-3);
    const Eigen::VectorXd now =
        tensions_of(built.net, built.net.unstressed_lengths(), built.net.nodes());
    const Plan plan =
        plan_strokes(built, FormTarget(net, net.nodes()),
                     limits_between(built.net, 1e-3, 3.0 * now.mean(), 10.0 * now.mean()));
    EXPECT_FALSE(plan.is_feasible);
    EXPECT_FALSE(plan.limit_probability.has_value());
    ASSERT_FALSE(plan.breaches.empty());
    // All strokes at their limit tighten the net.
    EXPECT_GT(plan.tensions.mean(), now.mean());
    EXPECT_NEAR(plan.largest_stroke(), 1e-3, 1e-9);
}

TEST(Plan, OfWholeStepsIsOfWholeStepsAndCostsLittle) {
    const CableNet net = hilo_quarter();
    const BuiltNet built = random_built(net, 3, 5e-3);
    const Plan plan = plan_strokes(built, FormTarget(net, net.nodes()),
                                   limits_between(built.net, 15e-3, 1.5e3, 10e3),
                                   {.turn = TurnSize{.pitch = 5e-3, .smallest = 0.25}});
    EXPECT_TRUE(plan.is_feasible);
    for (const PlannedStroke& stroke : plan.strokes) {
        const double steps = stroke.stroke / 1.25e-3;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
    }
    EXPECT_LT(plan.planned.normal_rmse, 1.1 * plan.normal_rmse_of_free_strokes);
    const Eigen::VectorXd after = tensions_after(built, plan);
    EXPECT_GT(after.minCoeff(), 1.5e3 - 0.1);
    EXPECT_LT(after.maxCoeff(), 10e3 + 0.1);
}

TEST(Plan, TurnsFewEdgesForATolerance) {
    const CableNet net = hypar(8, 8);
    const BuiltNet built = random_built(net, 4, 3e-3);
    const FormTarget target(net, net.nodes());
    const Limits limits = strokes_up_to(built.net, 10e-3);
    const Plan all = plan_strokes(built, target, limits);
    PlanOptions options;
    options.tolerance = 0.5 * (all.planned.normal_rmse + all.as_built.normal_rmse);
    const Plan few = plan_strokes(built, target, limits, options);
    ASSERT_TRUE(few.is_within_tolerance.has_value());
    EXPECT_TRUE(*few.is_within_tolerance);
    EXPECT_LE(few.planned.normal_rmse, *options.tolerance);
    EXPECT_LE(2 * few.strokes.size(), all.strokes.size());
    ASSERT_TRUE(few.fewest_bound);
    EXPECT_LE(*few.fewest_bound, static_cast<int>(few.strokes.size()));
    options.tolerance = 1e-6;
    EXPECT_EQ(plan_strokes(built, target, limits, options).is_within_tolerance, false);
}

/// A net that differs from another in its lengths, or in its stiffness.
struct Sample {
    Eigen::VectorXd lengths;
    ModelPerturbation perturbation;
};

/// Variances are those of the coordinates, along the normals those of the plan's sum.
void check_covariances(const CableNet& net, const Plan& plan) {
    ASSERT_EQ(plan.form_covariance.size(), static_cast<size_t>(net.node_count()));
    const FormTarget target(net, net.nodes());
    double along_normals = 0.0;
    for (int node = 0; node < net.node_count(); ++node) {
        const Eigen::Matrix3d& C = plan.form_covariance[node];
        EXPECT_LT((C.diagonal().cwiseSqrt() - plan.form_std.col(node)).norm(), 1e-12);
        if (net.free_index(node) >= 0) {
            const Eigen::Vector3d normal = target.normals().col(node);
            along_normals += normal.dot(C * normal) / net.free_node_count();
        }
    }
    EXPECT_NEAR(std::sqrt(along_normals), plan.normal_std, 1e-9);
}

TEST(Plan, KeepsItsLimitsInOtherSamplesThanItsOwn) {
    const CableNet net = hilo_quarter();
    for (const bool is_stiffness : {false, true}) {
        SCOPED_TRACE(is_stiffness);
        BuiltNet built = random_built(net, 2, is_stiffness ? 0.0 : 5e-3);
        test::Random random(11);
        std::normal_distribution<double> normal;
        const int uncertain = net.supports().front();
        const auto draw = [&] {
            Sample sample{.lengths = built.net.unstressed_lengths(),
                          .perturbation = unperturbed(built.net)};
            if (is_stiffness) {
                sample.perturbation.stiffness.setConstant(0.05 * normal(random));
                sample.perturbation.supports(0, uncertain) = 0.1e-3 * normal(random);
            }
            for (const int edge : net.interior_edges()) {
                sample.lengths(edge) += is_stiffness ? 0.0 : 0.5e-3 * normal(random);
            }
            return sample;
        };
        constexpr int count = 200;
        built.length_draws.resize(net.edge_count(), count);
        for (auto column : built.length_draws.colwise()) {
            const Sample sample = draw();
            column = sample.lengths;
            built.perturbations.push_back(sample.perturbation);
        }
        const double most = is_stiffness ? 8e3 : 9e3;
        const Limits limits = limits_between(built.net, 15e-3, 2.5e3, most);
        const FormTarget target(net, net.nodes());
        const Plan plan = plan_strokes(built, target, limits);
        EXPECT_TRUE(plan.is_feasible);
        EXPECT_GE(plan.limit_probability, 0.95);
        if (!is_stiffness) {
            EXPECT_NEAR(plan.normal_std, 0.5e-3, 0.2e-3);
        }
        check_covariances(net, plan);
        EXPECT_NEAR(plan.form_std(0, uncertain), is_stiffness ? 0.1e-3 : 0.0, 0.02e-3);
        EXPECT_EQ(plan.form_std.bottomRows(2).col(uncertain).norm(), 0.0);
        int kept = 0;
        for (int i = 0; i < count; ++i) {
            Sample sample = draw();
            for (const PlannedStroke& stroke : plan.strokes) {
                sample.lengths(stroke.edge) += stroke.stroke;
            }
            const CableNet truth = net_under(built.net, sample.perturbation, sample.lengths);
            const Eigen::VectorXd after =
                solved_tensions(truth, truth.unstressed_lengths(), plan.form);
            kept += after.minCoeff() >= 2.5e3 && after.maxCoeff() <= most ? 1 : 0;
        }
        EXPECT_GE(kept, 0.9 * count);  // 95 % required; 186 to 194 are two deviations
        // The estimate alone comes closer to the limits.
        built.length_draws.resize(net.edge_count(), 0);
        built.perturbations.clear();
        const Plan careless = plan_strokes(built, target, limits);
        if (is_stiffness) {
            EXPECT_LT(plan.tensions.maxCoeff(), careless.tensions.maxCoeff());
        } else {
            EXPECT_GT(plan.tensions.minCoeff(), careless.tensions.minCoeff());
        }
    }
}

TEST(Plan, KeepsReactionsAndTensionsWithinTheirLimitsUnderLaterLoads) {
    const CableNet net = hypar(6, 6);
    const BuiltNet built = random_built(net, 5, 2e-3);
    const FormTarget target(net, net.nodes());
    Limits limits = strokes_up_to(built.net, 10e-3);
    Points wet = Points::Zero(3, net.node_count());
    wet.row(2).setConstant(-60.0);
    limits.load_cases = {{.name = "wet", .loads = wet, .tension = limits.tension}};
    CableNetData loaded = built.net.data();
    loaded.loads = wet;
    const CableNet under(loaded);
    const auto tensions_then = [&](const Plan& plan) {
        return solved_tensions(under, lengths_after(built, plan), built.net.nodes());
    };
    // One edge at each support: its tension is the reaction.
    const auto largest_reaction = [&](const Plan& plan) {
        return tensions_then(plan)(net.adjustable_edges()).maxCoeff();
    };
    const Plan free = plan_strokes(built, target, limits);
    const double most_tension = 0.97 * tensions_then(free).maxCoeff();
    limits.load_cases[0].tension.upper.setConstant(most_tension);
    const Plan of_tensions = plan_strokes(built, target, limits);
    EXPECT_TRUE(of_tensions.is_feasible);
    EXPECT_LT(tensions_then(of_tensions).maxCoeff(), most_tension + 0.1);

    limits.load_cases[0].tension = limits.tension;
    const double most = 0.98 * largest_reaction(free);
    limits.reactions = {{.name = "all", .supports = net.supports(), .upper = most}};
    const Plan plan = plan_strokes(built, target, limits);
    EXPECT_TRUE(plan.is_feasible);
    EXPECT_LT(largest_reaction(plan), most + 0.1);
    // Where they cannot be kept, it says under which loads.
    limits.reactions[0].upper = 0.5 * most;
    limits.shortest_stroke.setConstant(-1e-4);
    limits.longest_stroke.setConstant(1e-4);
    const Plan broken = plan_strokes(built, target, limits);
    EXPECT_FALSE(broken.is_feasible);
    EXPECT_TRUE(std::ranges::any_of(broken.breaches, [](const LimitBreach& breach) {
        return breach.kind == LimitBreach::Kind::reaction && breach.load_case == "wet";
    }));
}

TEST(Plan, IsNotMadeOnAFailedIdentificationUnlessThatIsAccepted) {
    const CableNet net = hypar(3, 3);
    BuiltNet built = random_built(net, 1, 1e-3);
    built.failed_because = "the noise is contradicted";
    const FormTarget target(net, net.nodes());
    const Limits limits = strokes_up_to(net, 5e-3);
    test::expect_refused<FailedIdentification>([&] { return plan_strokes(built, target, limits); },
                                               "the noise is contradicted");
    EXPECT_FALSE(plan_strokes(built, target, limits, {.accept_failed = true}).strokes.empty());
}

TEST(Plan, IsBasedOnAFailedIdentificationWhereItsChecksFailed) {
    const CableNet net = hypar(3, 3);
    Identification identification;
    identification.trust.findings = {
        {.severity = Trust::Verdict::doubtful, .reason = "a length is odd", .advice = ""}};
    EXPECT_EQ(built_net_of(net, identification).failed_because, "");
    identification.trust.findings = {{.severity = Trust::Verdict::failed,
                                      .reason = "The noise is contradicted.",
                                      .advice = "Estimate it."}};
    EXPECT_EQ(built_net_of(net, identification).failed_because,
              "The noise is contradicted. Estimate it.");
}

TEST(Plan, RefusesOptionsOutOfRange) {
    const CableNet net = hypar(3, 3);
    BuiltNet built = random_built(net, 1, 1e-3);
    const auto planned = [&](const PlanOptions& options) {
        const std::vector<int>& edges =
            options.edges.empty() ? net.adjustable_edges() : options.edges;
        return plan_strokes(built, FormTarget(net, net.nodes()), stroke_limits(net, edges, 5e-3),
                            options);
    };
    const auto expect_refused = [&](const PlanOptions& options, const char* text) {
        test::expect_refused([&] { return planned(options); }, text);
    };
    expect_refused({.edges = {99}}, "edge 99");
    expect_refused({.edges = {2, 2}}, "at most once");
    expect_refused({.confidence = 1.0}, "confidence is 1");
    expect_refused({.actuator_std = -1.0}, "actuator std is -1 m");
    expect_refused({.actuator_std = 1.0}, "a quarter of the shortest edge");
    expect_refused({.turn = TurnSize{.pitch = 5.0, .smallest = 0.25}}, "a turn is 5 m");
    expect_refused({.turn = TurnSize{.pitch = 0.0, .smallest = 0.25}}, "a turn is 0");
    expect_refused({.turn = TurnSize{.pitch = 5e-3, .smallest = 2.0}},
                   "of a turn, expected 0.001 to 1");
    expect_refused({.turn = TurnSize{.pitch = 5e-3, .smallest = -0.25}},
                   "of a turn, expected 0.001 to 1");
    EXPECT_NO_THROW(static_cast<void>(planned({.turn = TurnSize{.pitch = 5e-3, .smallest = 0.0}})));
    expect_refused({.tolerance = 0.0}, "tolerance is 0");
    built.length_draws = Eigen::MatrixXd::Ones(2, 50);
    expect_refused({}, "one per edge");
    built.length_draws = Eigen::MatrixXd::Ones(net.edge_count(), 50);
    expect_refused({.confidence = 0.99}, "50 posterior samples show at most 0.98");
}

}  // namespace
}  // namespace taut
