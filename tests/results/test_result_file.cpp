// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a damaged or foreign result that is accepted, that crashes the reader, or whose
// message does not say where and what is wrong.

#include "taut/results/result_file.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/bad_input.hpp"
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
    EXPECT_TRUE(read.error_std.isApprox(study.as_in_paper().errors.std_dev, 1e-5));
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
    result["tension"] = json(result["cable_net"]["edges"].size(), 1.0);
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

/// Reads a result of changed JSON.
ResultFile read(const std::string& text) {
    return parse_result(text, "r.json");
}

TEST(ResultFile, OfAnotherFormatOrVersionIsRefused) {
    test::expect_refused("r.json", good("study"), R"(
/format | "taut-net" | is 'taut-net', expected "taut-study", "taut-identification"...
/format |  | is missing...
/version | 3 | is 3, expected 1 to 2...
/version |  | is missing...
)",
                         read);
}

TEST(ResultFile, OfAStudyIsRefusedAtThePlaceOfItsDamage) {
    test::expect_refused("r.json", good("study"), R"(
/cable_net/edges/1 | [0, 99] | /cable_net/edges/1...
/net/fingerprint | "0000000000000000" | is '0000000000000000'...
/sample/true/2 | null | is null, expected a number...
/sample/identified | [0.1] | has 1 entries, expected a number for each interior edge: 7...
/nominal_form | [] | has 0 entries...
/sample/true_form/0 | [1.0, 2.0] | has 2 entries...
/errors/all/0 | [0.1, 0.2] | has 2 entries...
/methods | {} | is empty...
/samples/validation | 0 | /samples/validation...
/samples/total | 3000000000 | is 3000000000, expected a whole number of 0 to 2147483647...
/samples/training | 100000 | is 100000, expected at most total...
/net/free_nodes | 5 | is 5, expected 6, as /cable_net has...
/methods/gp_as_in_paper/coverage_95 | 1.5 | is 1.5, expected a number of 0 to 1, or null...
/form_error/nominal/min | 1e9 | is 1000000000, expected at most max...
/sample/true_form/0/0 | 99.0 | /sample/true_form/0: is ...
)",
                         read);
}

TEST(ResultFile, OfAnIdentificationIsRefusedAtThePlaceOfItsDamage) {
    json result = good("identification");
    const json covariance{1, 0, 0, 1, 0, 1};
    result["form_covariance"] = json(result["form"].size(), covariance);
    result["tension"] = json(result["cable_net"]["edges"].size(), 1.0);
    result["diagnostics"]["boundary"] = json::parse(R"([{"edge": 0, "id": "0", "deviation": 0.01,
        "std": 0.001, "statistic": 99.0, "confounded_with": null}])");
    test::expect_refused("r.json", result, R"(
/edges/6 |  | /edges: has 6 entries, expected one for each interior edge: 7...
/survey/used | 100 | /survey/missing: is 0, expected -94, the free nodes that were not used...
/edges/0/nodes | [0, 1] | is [0,1], expected [...
/edges/0/nominal | 77.0 | is 77, expected ...
/frame | {"rotation": [[1, 0, 0]], "from": [0, 0, 0], "to": [0, 0, 0],
    "fit": {"rms": 0, "count": 0}, "control": []} |
    /frame/rotation: has 1 entries, expected an array of 3 entries...
/frame | "net" | is the text 'net', expected an object, or null...
/edges/0/edge | 1000 | is 1000, expected an edge of the net...
/edges/1 | /edges/0 | is the edge...
/edges/0/status | "broken" | is the text 'broken', expected "determined" or ...
/edges/0/lower | 1.0 | /edges/0: has...
/survey/outliers | [{"node": 999}] | /survey/outliers/0/node: is 999...
/survey/missing_nodes | [-1] | /survey/missing_nodes/0: is -1...
/uncertain | [{"name": "wind", "group": null, "given": "wind:5%", "mean": 0, "std": 1, "unit": "1",
    "observed": true}] | /uncertain/0/given: 'wind:5%' is no uncertain parameter...
/uncertain | [{"name": "stiffness-each", "group": null, "edge": 999, "given": "stiffness-each:3%",
    "mean": 0, "std": 0.01, "unit": "1", "observed": true}] | /uncertain/0/edge: is 999...
/uncertain | [{"name": "supports", "group": null, "given": "supports:1mm", "mean": 0, "std": 0.001,
    "unit": "m", "observed": true}] | /uncertain/0/node: is missing...
/tension | [1.0] | has 1 entries...
/mean_tension | {"mean": 1, "std": 1, "lower": 2, "upper": 1} |
    /mean_tension/lower: is 2, expected at most upper, which is 1...
/survey/residuals/1 | /survey/residuals/0 | is of the node ...
/adjustable_edges | [{"edge": 4, "tension": 1, "tension_std": 1, "tension_lower": 0,
    "tension_upper": 2, "slack_probability": 0}] |
    /adjustable_edges/0/edge: is 4, expected each adjustable edge...
/tension/0 | -1 | is -1, expected a number of at least 0...
/form/0/2 | 5.0 | /form/0: is 4.9...
/edges/1/std | 0.5 | is 0.5, expected at most 0.002...
/adjustable_edges | [{"edge": 0, "nodes": [3, 4], "tension": 1, "tension_std": 1,
    "tension_lower": 0, "tension_upper": 2, "slack_probability": 0}] |
    /adjustable_edges/0/nodes: is [3,4], expected [...
/edges/0/id | "edge 77" | is 'edge 77', expected '...
/prior/nodes | [{"prior": "uniform:5mm", "weight": 0.25}] | has weights of sum ...
/findings | [{"kind": "slip", "severity": "failed", "ids": [], "value": null, "std": null,
    "confounded_with": [], "remedy": null, "reason": "all", "next": ""}] |
    /trust/verdict: is 'passed', expected 'failed', the worst of all findings...
/length_covariance | {"edges": [0, 1], "ids": ["0", "1"], "covariance": [[1, 0]]} |
    /length_covariance/covariance: has 1 entries, expected a row for each edge: 2...
/form_covariance | [[1, 0, 0, 1, 0, 1]] | has 1 entries, expected a covariance for each node: ...
/form_covariance/0 | [1, 0, 1] | has 3 entries, expected an array of 6...
/form_covariance/0/3 | -1 | is -1, expected a variance of at least 0...
/form_covariance/0/1 | 2 | is 2, expected at most 1 beside variances of 1 and 1...
/diagnostics/boundary/0 | {"edge": 4, "id": "4", "deviation": 0.01, "std": 0.001,
    "statistic": 99.0, "confounded_with": null} |
    /diagnostics/boundary/0/edge: is 4, expected an adjustable edge...
/diagnostics/boundary/0 | {"node": 0, "id": "0", "deviation": 0.01, "std": 0.001,
    "statistic": 99.0, "confounded_with": null} |
    /diagnostics/boundary/0/deviation: is 0.01, expected a number for each axis...
/epochs | [{"used": 1, "turned": [], "outliers": [], "change_ratio": 0, "changes": [],
    "trust": {"verdict": "passed", "findings": []}, "boundary": [{"id": "0", "deviation": 0.01,
    "std": 0.001, "statistic": 9, "confounded_with": null}]}] |
    /epochs/0/boundary/0/node: is missing...
)",
                         read);
    result["net"]["fingerprint"] = std::string(100'000, 'x');
    EXPECT_THAT(input_error_of([&] { return read(result.dump()); }),
                ::testing::HasSubstr("x...', expected "));
}

TEST(ResultFile, OfAPlanIsRefusedAtThePlaceOfItsDamage) {
    json result = good("plan");
    test::expect_refused("r.json", result, R"(
/net_fingerprint | "0000000000000000" | is '0000000000000000', expected ...
/planned_form/15 |  | /planned_form: has 15 entries, expected a point [x, y, z] for each node...
/target_normals/15 |  | /target_normals: has ...
/planned_form_covariance/15 |  |
    /planned_form_covariance: has 15 entries, expected a covariance for each node: 16...
/tension/edges/16 |  | /tension/edges: has 16 entries, expected one for each edge: 17...
/tension/edges/1/edge | 0 | is 0, expected 1...
/tension/edges/1/lower | null | /tension/edges/1: has one end of the interval...
/tension/edges/1/lower | 1e9 | /tension/edges/1: has the interval of tension from...
/tension/edges/1/limit_lower | 1e9 | /tension/edges/1: has limits of tension from...
/tension/least | 1e9 | is 1000000000, expected at most most, which is ...
/touched | 100 | is 100, expected ...
/planned_form/0/0 | 99.0 | /planned_form/0: is ...
/turns/0/edge_id | "no edge" | is 'no edge', expected '...
/turns/0/edge | 999 | is 999, expected an edge of the net...
/turns/0/action | "lengthen" | is 'lengthen', expected ...
/feasible | true | is true, expected false...
/violations/0/edge | 999 | is 999...
/order/worst/breach/edge | 999 | is 999...
)",
                         read);
    result["turns"][0].update({{"edge", 4}, {"edge_id", "4"}});
    EXPECT_THAT(input_error_of([&] { return read(result.dump()); }),
                ::testing::HasSubstr("/turns/0/edge: is 4, expected an adjustable edge"));
}

TEST(ResultFile, OfSimulatedJobsIsRefusedAtThePlaceOfItsDamage) {
    test::expect_refused("r.json", good("control"), R"(
/strategies/1/strategy | "true lengths" | is 'true lengths' again...
/settings/trials | 0 | /settings: has 2 rounds and 0 trials...
/settings/rounds | 1 |
    /strategies/0/rounds: has 3 entries, expected one for each round from 0 to 1...
/settings/trials | 2147483647 | /strategies/0/states: has 15 entries...
/strategies/0/rounds/1/round | 2 | is 2, expected 1...
/strategies/0/states/3/trial | 2 | is 2, expected 1: by trial, then round...
/strategies/0/rounds/1/broken_trials | 6 | is 6, expected at most the 5 trials...
)",
                         read);
}

TEST(ResultFile, OfAComparisonIsRefusedAtThePlaceOfItsDamage) {
    test::expect_refused("r.json", good("comparison"), R"(
/version |  | is missing...
/rows/0/noise | -1e-3 | is -0.001, expected a number of at least 0...
/rows/0/failed | 1000 | is 1000, expected at most surveys...
)",
                         read);
}

}  // namespace
}  // namespace taut
