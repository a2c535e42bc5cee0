/* SPDX-FileCopyrightText: 2026 The taut authors
 * SPDX-License-Identifier: MIT
 *
 * Guards against a C library that says other things than taut, or ends the program that calls it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "taut/taut.h"

static int failures = 0;

#define CHECK(holds)                                                \
    do {                                                            \
        if (!(holds)) {                                             \
            ++failures;                                             \
            printf("%d: %s; %s\n", __LINE__, #holds, taut_error()); \
        }                                                           \
    } while (0)

static int stop_at_once(const char* work, int done, int total, void* data) {
    (void)work;
    (void)done;
    (void)total;
    ++*(int*)data;
    return 1;
}

static int fails(const void* made, taut_status status, const char* text) {
    return made == NULL && taut_last_status() == status && strstr(taut_error(), text) != NULL &&
           strchr(taut_error(), '\n') == NULL;
}

/* Errors as of a total station, the same at each run. */
static double noise(int i) {
    return 0.5e-3 * sin(1.0 + 7.31 * i * i);
}

static taut_survey* survey_of(const taut_net* net, double* form) {
    CHECK(taut_equilibrium(net, NULL, form, NULL) == TAUT_OK);
    for (int i = 0; i < 3 * taut_node_count(net); ++i) {
        form[i] += noise(i);
    }
    return taut_make_survey(net, form, 0.5e-3);
}

static void check_whole_chain(void) {
    taut_net* net = taut_builtin_net("hypar:5x5");
    CHECK(net != NULL && taut_last_status() == TAUT_OK && strcmp(taut_error(), "") == 0);
    const int n = taut_node_count(net);
    const int m = taut_edge_count(net);
    CHECK(n == 45 && m == 60);
    taut_net* again = taut_parse_net(taut_net_json(net));
    CHECK(again != NULL && strcmp(taut_net_json(again), taut_net_json(net)) == 0);
    taut_free_net(again);

    double* form = malloc(3 * n * sizeof *form);
    double* tensions = malloc(m * sizeof *tensions);
    double* lengths = malloc(m * sizeof *lengths);
    double* stds = malloc(m * sizeof *stds);
    double* tension_stds = malloc(m * sizeof *tension_stds);
    CHECK(taut_equilibrium(net, NULL, form, tensions) == TAUT_OK);
    for (int e = 0; e < m; ++e) {
        CHECK(tensions[e] > 0.0);
    }

    taut_survey* survey = survey_of(net, form);
    CHECK(survey != NULL);
    taut_set_threads(1);
    taut_result* result = taut_identify(
        net, survey,
        "{\"prior\": \"normal:2mm\", \"uncertain\": [\"stiffness:3%\"], \"draws\": 60}");
    CHECK(result != NULL && strcmp(taut_verdict(result), "passed") == 0);
    CHECK(strstr(taut_result_json(result), "\"taut-identification\"") != NULL);
    double* identified = malloc(m * sizeof *identified);
    CHECK(taut_result_edges(result, lengths, stds, identified, tension_stds) == TAUT_OK);
    for (int e = 0; e < m; ++e) {
        CHECK(lengths[e] > 0.0 && stds[e] >= 0.0 && stds[e] < 2.1e-3);
        CHECK(fabs(identified[e] / tensions[e] - 1.0) < 0.2 && tension_stds[e] > 0.0);
    }
    taut_result* same = taut_identify(
        net, survey,
        "{\"prior\": \"normal:2mm\", \"uncertain\": [\"stiffness:3%\"], \"draws\": 60}");
    CHECK(strcmp(taut_result_json(same), taut_result_json(result)) == 0);
    taut_free_result(same);

    taut_plan* plan =
        taut_plan_turns(result, NULL, "{\"tension\": [\"0.1kN..10kN\"], \"turn\": \"5mm\"}");
    CHECK(plan != NULL && taut_plan_is_feasible(plan) == 1);
    CHECK(strstr(taut_plan_json(plan), "\"taut-plan\"") != NULL);
    CHECK(taut_plan_strokes(plan, lengths) == TAUT_OK);
    double largest = 0.0;
    for (int e = 0; e < m; ++e) {
        largest = fmax(largest, fabs(lengths[e]));
    }
    CHECK(largest > 0.0 && largest <= 15e-3);
    /* What was made from a net does not need it any longer. */
    taut_free_net(net);
    taut_free_survey(survey);
    taut_plan* later = taut_plan_turns(result, form, "{\"stroke\": \"10mm\"}");
    CHECK(later != NULL);
    taut_free_plan(later);
    taut_free_plan(plan);
    taut_free_result(result);
    free(form);
    free(tensions);
    free(lengths);
    free(stds);
    free(identified);
    free(tension_stds);
}

static void check_all_evidence(void) {
    taut_net* net = taut_builtin_net("hypar:5x5");
    const int m = taut_edge_count(net);
    double* form = malloc(3 * taut_node_count(net) * sizeof *form);
    double* tensions = malloc(m * sizeof *tensions);
    double* stds = malloc(m * sizeof *stds);
    double* fewer = malloc(m * sizeof *fewer);
    taut_survey* first = survey_of(net, form);
    CHECK(taut_equilibrium(net, NULL, NULL, tensions) == TAUT_OK);
    for (int i = 0; i < 3 * taut_node_count(net); ++i) {
        form[i] += 0.5e-3 * cos(2.0 + 5.17 * i * i) - noise(i);
    }
    taut_survey* second = taut_make_survey(net, form, 0.5e-3);
    CHECK(first != NULL && second != NULL);

    /* A load cell narrows tensions: of all edges, since their stiffness is uncertain in common. */
    char options[200];
    snprintf(options, sizeof options,
             "{\"draws\": 60, \"forces\": \"edge,tension,std\\n0,%.6g,%.6g\\n\", "
             "\"taut_edges\": [\"1\"]}",
             tensions[0], 0.005 * tensions[0]);
    taut_result* alone = taut_identify(net, first, "{\"draws\": 60}");
    taut_result* with_cell = taut_identify(net, first, options);
    CHECK(taut_result_edges(alone, NULL, NULL, NULL, stds) == TAUT_OK);
    CHECK(taut_result_edges(with_cell, NULL, NULL, NULL, fewer) == TAUT_OK);
    CHECK(fewer[0] < 0.6 * stds[0] && fewer[1] < stds[1]);
    taut_free_result(with_cell);

    /* Two surveys know lengths better than one. */
    const taut_survey* both[] = {first, second};
    taut_result* of_both = taut_identify_epochs(net, both, 2, "{\"draws\": 60}");
    CHECK(of_both != NULL && strstr(taut_result_json(of_both), "\"epochs\"") != NULL);
    CHECK(taut_result_edges(alone, NULL, stds, NULL, NULL) == TAUT_OK);
    CHECK(taut_result_edges(of_both, NULL, fewer, NULL, NULL) == TAUT_OK);
    double sum = 0.0;
    double sum_of_both = 0.0;
    for (int e = 0; e < m; ++e) {
        sum += stds[e];
        sum_of_both += fewer[e];
    }
    CHECK(sum_of_both < sum);
    taut_free_result(of_both);

    CHECK(fails(taut_identify(net, first, "{\"forces\": \"none,1\\n\"}"), TAUT_WRONG_INPUT,
                "options:/forces:1"));
    CHECK(fails(taut_identify(net, first, "{\"frequencies\": \"0,8\\n\"}"), TAUT_WRONG_INPUT,
                "options:/frequencies: "));
    CHECK(fails(taut_identify(net, first, "{\"forces\": \"0,1\\n1,1\\n2,1\\n\"}"), TAUT_WRONG_INPUT,
                "options:/forces: "));
    CHECK(fails(taut_identify(net, first, "{\"draws\": 3000000000}"), TAUT_WRONG_INPUT,
                "below 2^31"));
    CHECK(fails(taut_identify_epochs(net, both, 2, "{\"draws\": 2000000000}"), TAUT_WRONG_INPUT,
                "draws is 2000000000"));
    CHECK(fails(taut_identify(net, first, "{\"slack_edges\": [\"none\"]}"), TAUT_WRONG_INPUT,
                "options:/slack_edges: names 'none'"));
    CHECK(fails(taut_identify_epochs(net, both, 1, NULL), TAUT_WRONG_INPUT, "1 surveys"));
    CHECK(fails(taut_identify_epochs(net, NULL, 2, NULL), TAUT_WRONG_INPUT, "surveys is NULL"));
    CHECK(fails(taut_identify_epochs(net, both, 2, "{\"turned\": [\"\", \"\"]}"), TAUT_WRONG_INPUT,
                "expected one for each of 1 later"));
    CHECK(fails(taut_identify_epochs(net, both, 2, "{\"turned\": [\"none,0.001\\n\"]}"),
                TAUT_WRONG_INPUT, "options:/turned/0:1"));
    both[1] = first;
    CHECK(fails(taut_identify_epochs(net, both, 2, NULL), TAUT_WRONG_INPUT,
                "surveys[1]: repeats survey"));
    taut_free_result(alone);
    taut_free_survey(first);
    taut_free_survey(second);
    taut_free_net(net);
    free(form);
    free(tensions);
    free(stds);
    free(fewer);
}

static void check_refusals(void) {
    taut_net* net = taut_builtin_net("hypar:5x5");
    double* form = malloc(3 * taut_node_count(net) * sizeof *form);
    taut_survey* survey = survey_of(net, form);
    CHECK(fails(taut_read_net("no/such.json"), TAUT_WRONG_INPUT, "no/such.json"));
    CHECK(fails(taut_read_net(NULL), TAUT_WRONG_INPUT, "file is NULL"));
    CHECK(fails(taut_parse_net("{\"nodes\": 3}"), TAUT_WRONG_INPUT, "net"));
    CHECK(fails(taut_parse_net("\xff\xfe"), TAUT_WRONG_INPUT, "net"));
    CHECK(fails(taut_builtin_net("roof"), TAUT_WRONG_INPUT, "roof"));
    CHECK(fails(taut_builtin_net("two\nlines"), TAUT_WRONG_INPUT, "two"));
    CHECK(fails(taut_make_survey(net, form, 0.0), TAUT_WRONG_INPUT, "noise_std is 0"));
    CHECK(fails(taut_make_survey(net, NULL, 1e-3), TAUT_WRONG_INPUT, "form is NULL"));
    CHECK(fails(taut_make_survey(NULL, form, 1e-3), TAUT_WRONG_INPUT, "net is NULL"));
    CHECK(fails(taut_read_survey(net, "no.csv", NAN), TAUT_WRONG_INPUT, "noise_std"));
    CHECK(fails(taut_identify(net, NULL, NULL), TAUT_WRONG_INPUT, "survey is NULL"));
    static const char* const options[][2] = {
        {"[", "options: is no JSON"},
        {"[]", "options: is no JSON object"},
        {"{\"prior\": 2}", "options:/prior: is not a text"},
        {"{\"prior\": \"2\"}", "options:/prior: "},
        {"{\"priors\": \"normal:2mm\"}", "options:/priors: is no option, expected forces"},
        {"{\"draws\": -1}", "options:/draws: is not an integer of 0 or more"},
        {"{\"draws\": 1e9}", "options:/draws: is not an integer"},
        {"{\"uncertain\": \"all\"}", "options:/uncertain: "},
        {"{\"uncertain\": [\"stiffness:40%\"]}", "width of 30 %"},
        {"{\"method\": \"best\"}", "options:/method: no method is called"},
    };
    for (size_t k = 0; k < sizeof options / sizeof *options; ++k) {
        CHECK(fails(taut_identify(net, survey, options[k][0]), TAUT_WRONG_INPUT, options[k][1]));
    }
    taut_result* result = taut_identify(net, survey, "{\"draws\": 0}");
    CHECK(fails(taut_plan_turns(result, NULL, "{\"tension\": [\"much\"]}"), TAUT_WRONG_INPUT,
                "options:/tension: is 'much'"));
    CHECK(fails(taut_plan_turns(result, NULL, "{\"edges\": [\"none\"]}"), TAUT_WRONG_INPUT,
                "options:/edges: names 'none'"));
    CHECK(fails(taut_plan_turns(result, NULL, "{\"step\": 0.5}"), TAUT_WRONG_INPUT,
                "turn is not given"));
    form[0] = INFINITY;
    form[3] = INFINITY;
    CHECK(fails(taut_plan_turns(result, form, NULL), TAUT_WRONG_INPUT, ""));
    CHECK(taut_plan_strokes(NULL, form) == TAUT_WRONG_INPUT);
    CHECK(taut_equilibrium(NULL, NULL, NULL, NULL) == TAUT_WRONG_INPUT);
    double* lengths = calloc(taut_edge_count(net), sizeof *lengths);
    CHECK(taut_equilibrium(net, lengths, form, NULL) == TAUT_WRONG_INPUT);
    CHECK(taut_set_threads(-1) == TAUT_WRONG_INPUT);
    CHECK(taut_set_memory_limit(-1.0) == TAUT_WRONG_INPUT);
    taut_set_memory_limit(1e4);
    CHECK(fails(taut_identify(net, survey, NULL), TAUT_FAILED, "the call needs"));
    taut_set_memory_limit(0.0);
    int calls = 0;
    taut_set_progress(stop_at_once, &calls);
    CHECK(fails(taut_identify(net, survey, NULL), TAUT_INTERRUPTED, "interrupted"));
    CHECK(calls >= 1);
    taut_set_progress(NULL, NULL);
    free(lengths);
    free(form);
    taut_free_result(result);
    taut_free_survey(survey);
    taut_free_net(net);
    taut_free_net(NULL);
    taut_free_survey(NULL);
    taut_free_result(NULL);
    taut_free_plan(NULL);
    CHECK(taut_node_count(NULL) == 0 && taut_net_json(NULL) == NULL && taut_verdict(NULL) == NULL);
}

int main(void) {
    CHECK(strlen(taut_version()) >= 5);
    check_whole_chain();
    check_all_evidence();
    check_refusals();
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
