// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a damaged or foreign result that is accepted, that crashes the reader, or whose
// message does not say where and what is wrong.

#include "taut/results/result_file.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/errors.hpp"
#include "support/studies.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using nlohmann::json;
using test::input_error_of;

json good(const std::string& kind) {
    static const std::map<std::string, std::string> texts{
        {"study", test::saved(test::made_up_study(hypar(2, 3))).json},
        {"identification", test::made_up_identification(hypar(2, 3)).json},
        {"comparison", test::made_up_comparison().json},
        {"plan", test::made_up_plan(hypar(2, 3)).json},
        {"control", test::made_up_control(hypar(2, 3)).json}};
    return json::parse(texts.at(kind));
}

TEST(ResultFile, OfAStudyGivesItsNumbersBack) {
    const Study study = test::made_up_study(hypar(2, 3));
    const ResultFile file = test::saved(study);
    const auto& read = std::get<StudyResult>(file.content);
    EXPECT_EQ(read.net.fingerprint(), study.net.fingerprint());
    EXPECT_EQ(read.validation, 5);
    EXPECT_TRUE(read.true_deviation.isApprox(
        study.data.length_deviations.col(study.validation.front()), 1e-8));
    EXPECT_TRUE(read.identified_deviation.isApprox(study.estimates.mean.col(0), 1e-8));
    EXPECT_TRUE(read.error_mean.isApprox(study.as_in_paper().errors.mean, 1e-5));
    EXPECT_TRUE(read.error_std.isApprox(study.as_in_paper().errors.std, 1e-5));
    EXPECT_EQ(read.errors.cols(), 5);
    EXPECT_TRUE(read.errors.rowwise().mean().isApprox(study.as_in_paper().errors.mean, 1e-3));
    EXPECT_TRUE(read.nominal_form_error.isApprox(study.nominal_form_error, 1e-5));
}

TEST(ResultFile, OfAnIdentificationGivesItsNumbersBack) {
    const ResultFile file = test::made_up_identification(hypar(2, 3));
    const auto& read = std::get<IdentificationResult>(file.content);
    EXPECT_EQ(read.edges.size(), 7U);
    EXPECT_EQ(read.edges.front().status, EdgeStatus::slack);
    EXPECT_EQ(read.residuals.size(), 6U);
    EXPECT_NEAR(read.residuals.front().surveyed_less_predicted.x(), 1e-4, 1e-12);
    EXPECT_FALSE(read.residuals.front().standardised);
}

TEST(ResultFile, OfAPlanGivesItsNumbersBack) {
    const CableNet net = hypar(2, 3);
    const ResultFile file = test::made_up_plan(net);
    const auto& read = std::get<PlanResult>(file.content);
    EXPECT_EQ(read.net.fingerprint(), net.fingerprint());
    EXPECT_TRUE(read.target_form.isApprox(net.nodes(), 1e-8));
    Points built_less_target = 0.003 * read.target_normals;
    built_less_target.row(0).array() += 0.004;
    built_less_target(Eigen::all, net.supports()).setZero();
    EXPECT_TRUE((read.built_form - read.target_form).isApprox(built_less_target, 1e-4));
    EXPECT_TRUE((3.0 * (read.planned_form - read.target_form))
                    .isApprox(read.built_form - read.target_form, 1e-4));
    ASSERT_EQ(read.tensions.size(), static_cast<size_t>(net.edge_count()));
    EXPECT_EQ(read.tensions.back().planned, 4200.0);
    EXPECT_EQ(read.tensions.back().upper, 4350.0);
    EXPECT_EQ(read.tensions.back().limit_upper, 4000.0);
    EXPECT_FALSE(read.tensions.front().limit_upper);
    EXPECT_EQ(read.tensions.front().limit_lower, 1500.0);
}

TEST(ResultFile, OfAPlanWithoutDrawsHasNoIntervals) {
    const ResultFile file = test::made_up_plan(hypar(2, 3), 0);
    for (const auto& tension : std::get<PlanResult>(file.content).tensions) {
        EXPECT_FALSE(tension.lower || tension.upper);
    }
}

TEST(ResultFile, OfSimulatedJobsGivesItsNumbersBack) {
    const ResultFile file = test::made_up_control(hypar(2, 3));
    const auto& read = std::get<ControlResult>(file.content);
    EXPECT_EQ(read.trials, 5);
    ASSERT_EQ(read.strategies.size(), 4U);
    const ControlResult::Strategy& identified = read.strategies[1];
    EXPECT_EQ(identified.name, "identified");
    ASSERT_EQ(identified.rounds.size(), 3U);
    EXPECT_EQ(identified.rounds[0].failed, 0);
    EXPECT_EQ(identified.rounds[2].failed, 1);
    EXPECT_NEAR(identified.rounds[1].turned, 0.25, 1e-12);
    ASSERT_EQ(identified.rounds[1].normal_rmse_of_trials.size(), 5U);
    EXPECT_NEAR(identified.rounds[1].normal_rmse_of_trials[4], 0.0014, 1e-12);
    double sum = 0.0;
    for (const double distance : identified.rounds[1].normal_rmse_of_trials) {
        sum += distance * distance;
    }
    EXPECT_NEAR(identified.rounds[1].normal_rmse, std::sqrt(sum / 5.0), 1e-12);
    EXPECT_EQ(identified.rounds[2].broken_trials, 0);
    EXPECT_EQ(read.strategies[2].rounds[2].broken_trials, 5);
}

TEST(ResultFile, OfAnIdentificationMayLackWhatOnlySomeMethodsGive) {
    json result = good("identification");
    for (const char* key : {"residuals", "missing_nodes", "unmatched"}) {
        result["survey"].erase(key);
    }
    result.erase("tension");
    EXPECT_NO_THROW(static_cast<void>(parse_result(result.dump(), "result.json")));
    result["survey"]["residuals"] =
        json::parse(R"([{"node": 0, "dx": 0, "dy": 0, "dz": 1e-3, "standardised": null}])");
    EXPECT_NO_THROW(static_cast<void>(parse_result(result.dump(), "result.json")));
}

TEST(ResultFile, OfAnOlderTautLacksPriorAndFrame) {
    json result = good("identification");
    result.erase("length_prior");
    result.erase("frame");
    result.erase("trust");
    result["survey"].erase("control");
    const ResultFile file = parse_result(result.dump(), "result.json");
    EXPECT_EQ(std::get<IdentificationResult>(file.content).trust.verdict(),
              Trust::Verdict::doubtful);  // its checks are not known
    result["findings"] = json::parse(R"([{"kind": "slip", "severity": "failed", "ids": [],
        "value": null, "std": null, "confounded_with": [], "remedy": null, "reason": "all",
        "next": ""}])");
    const ResultFile failed = parse_result(result.dump(), "result.json");
    EXPECT_EQ(std::get<IdentificationResult>(failed.content).trust.verdict(),
              Trust::Verdict::failed);
}

TEST(ResultFile, MarksTargetsThatWereLeftOut) {
    json result = good("identification");
    const int node = result["survey"]["residuals"][2]["node"];
    result["survey"]["outliers"] = {{{"node", node}, {"distance", 0.05}, {"statistic", 90.0}}};
    const ResultFile file = parse_result(result.dump(), "result.json");
    for (const auto& residual : std::get<IdentificationResult>(file.content).residuals) {
        EXPECT_EQ(residual.is_in_use, residual.node != node);
    }
}

TEST(ResultFile, HasAdjustableEdgesAndSupportsThatAreNotAsDesigned) {
    json result = good("identification");
    const int edge = result["cable_net"]["adjustable"][1];
    result["diagnostics"]["boundary"] = json::array(
        {{{"edge", edge}, {"id", std::to_string(edge)}, {"deviation", -0.012}, {"std", 4e-4}},
         {{"node", 0}, {"id", "0"}, {"deviation", {0.0, 0.02, 0.0}}, {"std", {1e-3, 1e-3, 1e-3}}}});
    for (json& one : result["diagnostics"]["boundary"]) {
        one.update({{"statistic", 99.0}, {"confounded_with", nullptr}});
    }
    const auto parse = [&] { return parse_result(result.dump(), "r.json"); };
    EXPECT_THAT(input_error_of(parse), ::testing::HasSubstr("/form/0: is 0.02 m from ["));
    result["form"][0][1] = result["form"][0][1].get<double>() + 0.02;
    const ResultFile file = parse();
    const auto& found = std::get<IdentificationResult>(file.content).boundary_outliers;
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].index, edge);
    EXPECT_EQ(found[0].deviation.x(), -0.012);
    EXPECT_EQ(found[1].kind, BoundaryOutlier::Kind::support);
    EXPECT_EQ(found[1].deviation.y(), 0.02);
}

/// Calls with each object of a document and the rule of the schema that it keeps to.
template <class Action>
void for_each_object(const json& value, const json& rule_or_reference,
                     const json::json_pointer& pointer, const Action& action) {
    static const json definitions = json::parse(result_schema())["definitions"];
    json rule = rule_or_reference;
    while (rule.contains("$ref")) {
        rule = definitions.at(json::json_pointer(rule["$ref"].get<std::string>().substr(1)).back());
    }
    if (rule.contains("anyOf") && value.is_structured()) {
        return for_each_object(value, rule["anyOf"][0], pointer, action);
    }
    if (value.is_object()) {
        action(rule, pointer);
        for (const auto& [key, member] : value.items()) {
            const json& others = rule.value("additionalProperties", json());
            const json of_member = rule.value("properties", json::object()).value(key, others);
            if (!of_member.is_null()) {
                for_each_object(member, of_member, pointer / key, action);
            }
        }
    } else if (value.is_array() && !value.empty()) {
        for_each_object(value.front(), rule.value("items", json()), pointer / 0, action);
    }
}

TEST(ResultFile, LacksNoKeyThatTheSchemaRequiresAndMayLackAllOthers) {
    int required = 0;
    int optional = 0;
    for (const std::string kind : {"study", "identification", "comparison", "plan", "control"}) {
        const json whole = good(kind);
        for_each_object(
            whole, {{"$ref", "#/definitions/" + kind}}, json::json_pointer(),
            [&](const json& rule, const json::json_pointer& pointer) {
                const json keys = rule.value("required", json::array());
                for (const auto& [key, value] : whole.at(pointer).items()) {
                    json result = whole;
                    result.at(pointer).erase(key);
                    const auto parse = [&] { return parse_result(result.dump(), "r.json"); };
                    if (std::ranges::find(keys, json(key)) != keys.end()) {
                        ++required;
                        EXPECT_THAT(input_error_of(parse),
                                    ::testing::StartsWith("r.json:" + (pointer / key).to_string() +
                                                          ": is missing, expected "));
                    } else if (rule.contains("properties")) {
                        ++optional;
                        EXPECT_NO_THROW(static_cast<void>(parse())) << pointer / key;
                    }
                }
            });
    }
    EXPECT_GT(required, 60);
    EXPECT_GT(optional, 40);
}

TEST(ResultFile, ThatIsCutShortAnywhereIsRefused) {
    const std::string text = good("identification").dump();
    for (size_t size = 0; size < text.size(); size += 97) {
        EXPECT_FALSE(test::succeeds_or_refuses([&] {
            return parse_result(text.substr(0, size), "result.json");
        })) << size;
    }
}

json without_last(json list) {
    list.erase(list.size() - 1);
    return list;
}

struct Damage {
    const char* name;
    std::string kind;
    std::string pointer;
    json value;  ///< null stands for itself; discarded: the key is taken away
    std::string message;
};

const json gone = json(json::value_t::discarded);

/// Of a result: one adjustable edge or support that is not as designed.
json boundary(const std::string& entry) {
    json one = json::parse(entry);
    one.update({{"statistic", 99.0}, {"confounded_with", nullptr}});
    return json::array({one});
}

/// Of an identification: covariances of all nodes, the first of them given.
json covariances(const std::string& first) {
    json list(good("identification")["form"].size(), json::parse("[1, 0, 0, 1, 0, 1]"));
    list.front() = json::parse(first);
    return list;
}

class DamagedResult : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedResult, IsRefusedWithItsPlace) {
    const Damage& damage = GetParam();
    json result = good(damage.kind);
    const json::json_pointer pointer(damage.pointer);
    if (damage.value.is_discarded()) {
        result.at(pointer.parent_pointer()).erase(pointer.back());
    } else {
        result[pointer] = damage.value;
    }
    const std::string message =
        input_error_of([&] { return parse_result(result.dump(), "r.json"); });
    EXPECT_THAT(message, ::testing::StartsWith("r.json:"));
    EXPECT_THAT(message, ::testing::HasSubstr(damage.message));
}

std::string name_of(const ::testing::TestParamInfo<Damage>& damage) {
    return damage.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    AnyFormat, DamagedResult,
    ::testing::Values(
        Damage{"OfAnotherFormat", "study", "/format", "taut-net",
               R"(/format: is 'taut-net', expected "taut-study", "taut-identification")"},
        Damage{"WithoutFormat", "study", "/format", gone, "/format: is missing"},
        Damage{"OfALaterVersion", "study", "/version", 3, "/version: is 3, expected 1 to 2"},
        Damage{"WithoutVersion", "comparison", "/version", gone, "/version: is missing"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Study, DamagedResult,
    ::testing::Values(
        Damage{"WithABrokenNet", "study", "/cable_net/edges/1", json{0, 99}, "/cable_net/edges/1"},
        Damage{"WithAnothersCounts", "study", "/net/fingerprint", "0000000000000000",
               "/net/fingerprint: is '0000000000000000'"},
        Damage{"WithNullForANumber", "study", "/sample/true/2", nullptr,
               "/sample/true/2: is null, expected a number"},
        Damage{"WithAListTooShort", "study", "/sample/identified", json{0.1},
               "/sample/identified: has 1 entries, expected a number for each interior edge: 7"},
        Damage{"WithAFormTooShort", "study", "/nominal_form", json::array(),
               "/nominal_form: has 0 entries"},
        Damage{"WithAFlatForm", "study", "/sample/true_form/0", json{1.0, 2.0},
               "/sample/true_form/0: has 2 entries"},
        Damage{"WithErrorsOfTooFewSamples", "study", "/errors/all/0", json{0.1, 0.2},
               "/errors/all/0: has 2 entries"},
        Damage{"WithoutMethods", "study", "/methods", json::object(), "/methods: is empty"},
        Damage{"WithoutValidation", "study", "/samples/validation", 0, "/samples/validation"},
        Damage{"WithACountBeyondAllReason", "study", "/samples/total", 3'000'000'000,
               "/samples/total: is 3000000000, expected a whole number of 0 to 2147483647"},
        Damage{"WithMoreForTrainingThanThereAre", "study", "/samples/training", 100'000,
               "/samples/training: is 100000, expected at most total"},
        Damage{"OfFewerNodesThanItsNet", "study", "/net/free_nodes", 5,
               "/net/free_nodes: is 5, expected 6, as /cable_net has"},
        Damage{"WithACoverageBeyondAll", "study", "/methods/gp_as_in_paper/coverage_95", 1.5,
               "/methods/gp_as_in_paper/coverage_95: is 1.5, expected a number of 0 to 1, or null"},
        Damage{"WithAReversedFormError", "study", "/form_error/nominal/min", 1e9,
               "/form_error/nominal/min: is 1000000000, expected at most max"},
        Damage{"WithASupportMoved", "study", "/sample/true_form/0/0", 99.0,
               "/sample/true_form/0: is "}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Identification, DamagedResult,
    ::testing::Values(
        Damage{"WithoutAnEdge", "identification", "/edges",
               without_last(good("identification")["edges"]),
               "/edges: has 6 entries, expected one for each interior edge: 7"},
        Damage{"WithMoreTargetsThanNodes", "identification", "/survey/used", 100,
               "/survey/missing: is 0, expected -94, the free nodes that were not used"},
        Damage{"WithAnEdgeBetweenOtherNodes", "identification", "/edges/0/nodes", json{0, 1},
               "/edges/0/nodes: is [0,1], expected ["},
        Damage{"WithAnotherNominalLength", "identification", "/edges/0/nominal", 77.0,
               "/edges/0/nominal: is 77, expected "},
        Damage{"WithAFlatRotation", "identification", "/frame",
               json::parse(R"({"rotation": [[1, 0, 0]], "from": [0, 0, 0], "to": [0, 0, 0],
                               "fit": {"rms": 0, "count": 0}, "control": []})"),
               "/frame/rotation: has 1 entries, expected an array of 3 entries"},
        Damage{"WithTextForAFrame", "identification", "/frame", "net",
               "/frame: is the text 'net', expected an object, or null"},
        Damage{"WithAnEdgeBeyondTheNet", "identification", "/edges/0/edge", 1000,
               "/edges/0/edge: is 1000, expected an edge of the net"},
        Damage{"WithAnEdgeTwice", "identification", "/edges/1", good("identification")["edges"][0],
               "/edges/1: is the edge"},
        Damage{"WithAnUnknownStatus", "identification", "/edges/0/status", "broken",
               R"(/edges/0/status: is the text 'broken', expected "determined" or )"},
        Damage{"WithAReversedInterval", "identification", "/edges/0/lower", 1.0, "/edges/0: has"},
        Damage{"WithAnOutlierBeyondTheNet", "identification", "/survey/outliers",
               json::parse(R"([{"node": 999}])"), "/survey/outliers/0/node: is 999"},
        Damage{"WithAHiddenNodeBeyondTheNet", "identification", "/survey/missing_nodes", json{-1},
               "/survey/missing_nodes/0: is -1"},
        Damage{"WithAnUncertainParameterOfNoName", "identification", "/uncertain",
               json::parse(R"([{"name": "wind", "group": null, "given": "wind:5%", "mean": 0,
                                "std": 1, "unit": "1", "observed": true}])"),
               "/uncertain/0/given: 'wind:5%' is no uncertain parameter"},
        Damage{"WithAnUncertainParameterOfNoEdgeOfTheNet", "identification", "/uncertain",
               json::parse(R"([{"name": "stiffness-each", "group": null, "edge": 999,
                                "given": "stiffness-each:3%", "mean": 0, "std": 0.01, "unit": "1",
                                "observed": true}])"),
               "/uncertain/0/edge: is 999"},
        Damage{"WithAnUncertainParameterOfNoNode", "identification", "/uncertain",
               json::parse(R"([{"name": "supports", "group": null, "given": "supports:1mm",
                                "mean": 0, "std": 0.001, "unit": "m", "observed": true}])"),
               "/uncertain/0/node: is missing"},
        Damage{"WithTooFewTensions", "identification", "/tension", json{1.0},
               "/tension: has 1 entries"},
        Damage{"WithAReversedIntervalOfTheMeanTension", "identification", "/mean_tension",
               json::parse(R"({"mean": 1, "std": 1, "lower": 2, "upper": 1})"),
               "/mean_tension/lower: is 2, expected at most upper, which is 1"},
        Damage{"WithAResidualTwice", "identification", "/survey/residuals/1",
               good("identification")["survey"]["residuals"][0],
               "/survey/residuals/1: is of the node "},
        Damage{"WithAnAdjustableEdgeThatIsNone", "identification", "/adjustable_edges",
               json::parse(R"([{"edge": 4, "tension": 1, "tension_std": 1, "tension_lower": 0,
                                "tension_upper": 2, "slack_probability": 0}])"),
               "/adjustable_edges/0/edge: is 4, expected each adjustable edge"},
        Damage{"WithATensionBelowZero", "identification", "/tension",
               json(std::vector<double>(good("identification")["cable_net"]["edges"].size(), -1.0)),
               "/tension/0: is -1, expected a number of at least 0"},
        Damage{"WithASupportMovedInItsForm", "identification", "/form/0/2", 5.0, "/form/0: is 4.9"},
        Damage{"WithAStdBesideNarrowerBounds", "identification", "/edges/1/std", 0.5,
               "/edges/1/std: is 0.5, expected at most 0.002"},
        Damage{"WithAnAdjustableEdgeBetweenOtherNodes", "identification", "/adjustable_edges",
               json::parse(R"([{"edge": 0, "nodes": [3, 4], "tension": 1, "tension_std": 1,
                                "tension_lower": 0, "tension_upper": 2, "slack_probability": 0}])"),
               "/adjustable_edges/0/nodes: is [3,4], expected ["},
        Damage{"WithTheIdOfAnotherEdge", "identification", "/edges/0/id", "edge 77",
               "/edges/0/id: is 'edge 77', expected '"},
        Damage{"WithPriorsOfAnotherSumThanOne", "identification", "/prior/nodes",
               json::parse(R"([{"prior": "uniform:5mm", "weight": 0.25}])"),
               "/prior/nodes: has weights of sum "},
        Damage{"WithAVerdictBetterThanItsFindings", "identification", "/findings",
               json::parse(R"([{"kind": "slip", "severity": "failed", "ids": [], "value": null,
                                "std": null, "confounded_with": [], "remedy": null,
                                "reason": "all", "next": ""}])"),
               "/trust/verdict: is 'passed', expected 'failed', the worst of all findings"},
        Damage{"WithALengthCovarianceOfTooFewRows", "identification", "/length_covariance",
               json::parse(R"({"edges": [0, 1], "ids": ["0", "1"], "covariance": [[1, 0]]})"),
               "/length_covariance/covariance: has 1 entries, expected a row for each edge: 2"},
        Damage{"WithACovarianceTooFew", "identification", "/form_covariance",
               json::parse("[[1, 0, 0, 1, 0, 1]]"),
               "/form_covariance: has 1 entries, expected a covariance for each node: "},
        Damage{"WithACovarianceOfAPlane", "identification", "/form_covariance",
               covariances("[1, 0, 1]"),
               "/form_covariance/0: has 3 entries, expected an array of 6"},
        Damage{"WithAVarianceBelowZero", "identification", "/form_covariance",
               covariances("[1, 0, 0, -1, 0, 1]"),
               "/form_covariance/0/3: is -1, expected a variance of at least 0"},
        Damage{"WithACovarianceBeyondItsVariances", "identification", "/form_covariance",
               covariances("[1, 2, 0, 1, 0, 1]"),
               "/form_covariance/0/1: is 2, expected at most 1 beside variances of 1 and 1"},
        Damage{"WithABoundaryOutlierThatIsNoAdjustableEdge", "identification",
               "/diagnostics/boundary",
               boundary(R"({"edge": 4, "id": "4", "deviation": 0.01, "std": 0.001})"),
               "/diagnostics/boundary/0/edge: is 4, expected an adjustable edge"},
        Damage{"WithANumberForAMoveOfASupport", "identification", "/diagnostics/boundary",
               boundary(R"({"node": 0, "id": "0", "deviation": 0.01, "std": 0.001})"),
               "/diagnostics/boundary/0/deviation: is 0.01, expected a number for each axis"},
        Damage{"WithAnEpochsBoundaryOutlierOfNothing", "identification", "/epochs",
               json::parse(R"([{"used": 1, "turned": [], "outliers": [], "change_ratio": 0,
                                "changes": [], "trust": {"verdict": "passed", "findings": []},
                                "boundary": [{"id": "0", "deviation": 0.01, "std": 0.001,
                                              "statistic": 9, "confounded_with": null}]}])"),
               "/epochs/0/boundary/0/node: is missing"},
        Damage{"WithAFingerprintWithoutEnd", "identification", "/net/fingerprint",
               std::string(100'000, 'x'), "x...', expected "}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Plan, DamagedResult,
    ::testing::Values(
        Damage{"OfAnotherNet", "plan", "/net_fingerprint", "0000000000000000",
               "/net_fingerprint: is '0000000000000000', expected "},
        Damage{"OfANodeTooFew", "plan", "/planned_form", without_last(good("plan")["planned_form"]),
               "/planned_form: has 15 entries, expected a point [x, y, z] for each node"},
        Damage{"WithANormalTooFew", "plan", "/target_normals",
               without_last(good("plan")["target_normals"]), "/target_normals: has "},
        Damage{"WithACovarianceTooFew", "plan", "/planned_form_covariance",
               without_last(good("plan")["planned_form_covariance"]),
               "/planned_form_covariance: has 15 entries, expected a covariance for each node: 16"},
        Damage{"WithATensionTooFew", "plan", "/tension/edges",
               without_last(good("plan")["tension"]["edges"]), "expected one for each edge: "},
        Damage{"WithEdgesOutOfOrder", "plan", "/tension/edges/1/edge", 0,
               "/tension/edges/1/edge: is 0, expected 1"},
        Damage{"WithHalfAnInterval", "plan", "/tension/edges/1/lower", json(nullptr),
               "/tension/edges/1: has one end of the interval"},
        Damage{"WithAnIntervalUpsideDown", "plan", "/tension/edges/1/lower", 1e9,
               "/tension/edges/1: has the interval of tension from"},
        Damage{"WithLimitsThatContradict", "plan", "/tension/edges/1/limit_lower", 1e9,
               "/tension/edges/1: has limits of tension from"},
        Damage{"WithALeastTensionAboveTheMost", "plan", "/tension/least", 1e9,
               "/tension/least: is 1000000000, expected at most most, which is "},
        Damage{"WithMoreTouchedThanTurned", "plan", "/touched", 100, "/touched: is 100, expected "},
        Damage{"ThatMovesASupport", "plan", "/planned_form/0/0", 99.0, "/planned_form/0: is "},
        Damage{"ThatCallsAnEdgeByAnothersId", "plan", "/turns/0/edge_id", "no edge",
               "/turns/0/edge_id: is 'no edge', expected '"},
        Damage{"ThatTurnsNoEdge", "plan", "/turns/0/edge", 999,
               "/turns/0/edge: is 999, expected an edge of the net"},
        Damage{"ThatTurnsAnInteriorEdge", "plan", "/turns/0",
               [] {
                   json turn = good("plan")["turns"][0];
                   turn["edge"] = 4;
                   turn["edge_id"] = "4";
                   return turn;
               }(),
               "/turns/0/edge: is 4, expected an adjustable edge"},
        Damage{"WithAnActionAgainstItsStroke", "plan", "/turns/0/stroke",
               -good("plan")["turns"][0]["stroke"].get<double>(), "/turns/0/action: is '"},
        Damage{"ThatIsFeasibleWithViolations", "plan", "/feasible", true,
               "/feasible: is true, expected false"},
        Damage{"WithABreachOfNoEdge", "plan", "/violations/0/edge", 999,
               "/violations/0/edge: is 999"},
        Damage{"WithAWorstStepOfNoEdge", "plan", "/order/worst/breach/edge", 999,
               "/order/worst/breach/edge: is 999"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Control, DamagedResult,
    ::testing::Values(
        Damage{"OfAStrategyTwice", "control", "/strategies/1/strategy", "true lengths",
               "/strategies/1/strategy: is 'true lengths' again"},
        Damage{"WithoutTrials", "control", "/settings/trials", 0,
               "/settings: has 2 rounds and 0 trials"},
        Damage{"OfMoreRoundsThanItsSettings", "control", "/settings/rounds", 1,
               "/strategies/0/rounds: has 3 entries, expected one for each round from 0 to 1"},
        Damage{"OfFarTooManyTrials", "control", "/settings/trials", 2147483647,
               "/strategies/0/states: has 15 entries"},
        Damage{"WithRoundsOutOfOrder", "control", "/strategies/0/rounds/1/round", 2,
               "/strategies/0/rounds/1/round: is 2, expected 1"},
        Damage{"WithTrialsOutOfOrder", "control", "/strategies/0/states/3/trial", 2,
               "/strategies/0/states/3/trial: is 2, expected 1: by trial, then round"},
        Damage{"WithMoreBrokenThanTrials", "control", "/strategies/0/rounds/1/broken_trials", 6,
               "/strategies/0/rounds/1/broken_trials: is 6, expected at most the 5 trials"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Comparison, DamagedResult,
    ::testing::Values(Damage{"WithNegativeNoise", "comparison", "/rows/0/noise", -1e-3,
                             "/rows/0/noise: is -0.001, expected a number of at least 0"},
                      Damage{"WithMoreFailedThanSurveys", "comparison", "/rows/0/failed", 1000,
                             "/rows/0/failed: is 1000, expected at most surveys"}),
    name_of);

}  // namespace
}  // namespace taut
