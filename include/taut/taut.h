/* SPDX-FileCopyrightText: 2026 The taut authors
 * SPDX-License-Identifier: MIT */
#ifndef TAUT_TAUT_H
#define TAUT_TAUT_H

/* taut from C, and from all that calls C: MATLAB, Julia, C#. The library is taut_c.
 *
 * Lengths are in m, forces in N. Arrays of places hold x, y, z of one node after the other, in the
 * order of the net's nodes. Text is UTF-8 and ends with 0.
 *
 * A call that fails returns NULL, or a status other than TAUT_OK, and changes nothing. taut_error()
 * then has the reason. Whatever a taut_... pointer is freed with may be given NULL. What was made
 * from a net does not need it any longer. Calls from several threads may run at the same time, but
 * for two that change or free the same object. */

#if defined(_WIN32) && defined(taut_c_EXPORTS)
#define TAUT_API __declspec(dllexport)
#elif defined(_WIN32)
#define TAUT_API __declspec(dllimport)
#else
#define TAUT_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* NOLINTBEGIN(readability-identifier-naming): as C writes them */

/* How a call ended. The values are the exit codes of the program. */
typedef enum taut_status {
    TAUT_OK = 0,
    TAUT_FAILED = 1,      /* no equilibrium, no convergence, limits that cannot hold, no memory */
    TAUT_WRONG_INPUT = 2, /* a file, an argument or an option; the message names it */
    TAUT_INTERRUPTED = 130
} taut_status;

typedef struct taut_net taut_net;       /* as designed */
typedef struct taut_survey taut_survey; /* of a net */
typedef struct taut_result taut_result; /* of an identification, with its net and survey */
typedef struct taut_plan taut_plan;     /* of turns */

/* "0.3.0" */
TAUT_API const char* taut_version(void);

/* Of the last call of this thread: one line, "" where it did not fail. Valid until its next call.
 */
TAUT_API const char* taut_error(void);
TAUT_API taut_status taut_last_status(void);

/* What long calls of this thread report to from now on, at each step and in between: the work, its
 * steps done and their number (0: not known). A value other than 0 stops the call. It must not call
 * taut, and may be called by another thread. NULL: nobody. */
typedef int (*taut_progress)(const char* work, int done, int total, void* data);
TAUT_API void taut_set_progress(taut_progress report, void* data);

/* Largest number of threads of the later calls of this thread; 0: one a core. */
TAUT_API taut_status taut_set_threads(int count);

/* Most bytes that each later call of this thread may take for its large arrays: matrices, data
 * sets, posterior samples. One that needs more ends with TAUT_FAILED. 0: no limit. */
TAUT_API taut_status taut_set_memory_limit(double bytes);

/* A net file (net.json), its text, or a built-in net ("hypar:9x9"). */
TAUT_API taut_net* taut_read_net(const char* file);
TAUT_API taut_net* taut_parse_net(const char* json);
TAUT_API taut_net* taut_builtin_net(const char* name);
TAUT_API void taut_free_net(taut_net* net);

TAUT_API int taut_node_count(const taut_net* net);
TAUT_API int taut_edge_count(const taut_net* net);
/* As net.json. Valid as long as the net. */
TAUT_API const char* taut_net_json(const taut_net* net);

/* The equilibrium of the net.
 * unstressed_lengths: of each edge; NULL: those of the net
 * form: gets the places of all nodes, 3 * taut_node_count(); NULL: not wanted
 * tensions: gets that of each edge, taut_edge_count(); NULL: not wanted */
TAUT_API taut_status taut_equilibrium(const taut_net* net, const double* unstressed_lengths,
                                      double* form, double* tensions);

/* A survey file in any format that taut identify reads.
 * noise_std: standard deviation of each coordinate where the file gives none; 0: by its digits */
TAUT_API taut_survey* taut_read_survey(const taut_net* net, const char* file, double noise_std);
/* A survey in the net's coordinate system.
 * form: 3 * taut_node_count(); NaN at free nodes that were not surveyed; supports are not read
 * noise_std: of each coordinate, more than 0 */
TAUT_API taut_survey* taut_make_survey(const taut_net* net, const double* form, double noise_std);
TAUT_API void taut_free_survey(taut_survey* survey);

/* Identifies lengths and tensions.
 * options: JSON object, each key may be missing; NULL: none. "prior": "normal:2mm", "uncertain":
 *   ["stiffness:3%", "supports:2mm"], to which the default assumptions are added, or "none";
 *   "prior_exact", "estimate_noise": true or false; "method": "map", "gp" or "balance"; "draws",
 *   "seed": integers; "forces" and "frequencies": the content of these files, as
 *   "edge,tension[,std]\nc1,12000,240\n" in N, and
 *   "edge,frequency[,mode][,std]\n..." in Hz; "free_length_std": "10mm"; "taut_edges",
 *   "slack_edges": [identifiers]. All else means what it means to taut identify. Forces in a unit
 *   that is most likely another are refused. */
TAUT_API taut_result* taut_identify(const taut_net* net, const taut_survey* survey,
                                    const char* options);
/* The same from two or more surveys of one net, in their order; the result is of the last without
 * loads of its own.
 * surveys: count of them
 * options: as above, and of each survey but the first "turned": what was turned before it, and
 *   "loads": what hung on the net at it alone, lists of the content of these files,
 *   ["edge,stroke,std\nr1,0.005,0.0003\n", ""] in m or N; "": nothing */
TAUT_API taut_result* taut_identify_epochs(const taut_net* net, const taut_survey* const* surveys,
                                           int count, const char* options);
TAUT_API void taut_free_result(taut_result* result);
/* "passed", "doubtful" or "failed". Valid as long as the result. */
TAUT_API const char* taut_verdict(const taut_result* result);
/* As result.json. Valid as long as the result. */
TAUT_API const char* taut_result_json(const taut_result* result);
/* Of each edge as identified, taut_edge_count(): unstressed lengths, tensions, and the standard
 * deviations of both (0 where a length is known; NaN where a tension has none). Each may be NULL.
 */
TAUT_API taut_status taut_result_edges(const taut_result* result, double* lengths,
                                       double* length_stds, double* tensions, double* tension_stds);

/* Plans which turnbuckles to turn how far.
 * target: places to reach, 3 * taut_node_count(); NULL: the nodes of the net
 * options: JSON object, each key may be missing; NULL: none. "tension": ["1.5kN..10kN",
 *   "..60%@ridge"], "reaction": ["20kN"], "target_tension": ["12kN:5%@ridge"], "stages":
 *   "ridge:50%,ridge", "edges": [identifiers], "stroke", "total_stroke", "turn", "tolerance",
 *   "actuator_std": lengths as "5mm", "step": part of a turn, "confidence": number, "crews",
 *   "seed": integers, "accept_failed": true or false. All mean what they mean to taut plan. */
TAUT_API taut_plan* taut_plan_turns(const taut_result* result, const double* target,
                                    const char* options);
TAUT_API void taut_free_plan(taut_plan* plan);
/* Whether all limits hold with the probability asked for: 1 or 0. */
TAUT_API int taut_plan_is_feasible(const taut_plan* plan);
/* As plan.json. Valid as long as the plan. */
TAUT_API const char* taut_plan_json(const taut_plan* plan);
/* Change of length of each edge, taut_edge_count(). */
TAUT_API taut_status taut_plan_strokes(const taut_plan* plan, double* strokes);

/* NOLINTEND(readability-identifier-naming) */

#ifdef __cplusplus
}
#endif

#endif
