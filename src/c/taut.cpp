// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/taut.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/adjustment/request_error.hpp"
#include "taut/adjustment/request_text.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/error.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/printable.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/force_units.hpp"
#include "taut/identification/identify.hpp"
#include "taut/io/adjustment_csv.hpp"
#include "taut/io/forces_csv.hpp"
#include "taut/io/frequencies_csv.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/read_survey.hpp"
#include "taut/io/turned_csv.hpp"
#include "taut/memory.hpp"
#include "taut/net/units.hpp"
#include "taut/numerical_error.hpp"
#include "taut/results/plan_files.hpp"
#include "taut/results/results_json.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/survey/cable_vibration.hpp"
#include "taut/threads.hpp"
#include "taut/version.hpp"

struct taut_net {
    explicit taut_net(const taut::CableNet& of) : net(of), json(net_to_json(of)) {}

    taut::CableNet net;
    std::string json;
};

struct taut_survey {
    explicit taut_survey(taut::Survey seen) : survey(std::move(seen)) {}

    taut::Survey survey;
};

struct taut_result {
    taut_result(const taut::CableNet& of, taut::Identification identified, std::string text)
        : net(of), found(std::move(identified)), json(std::move(text)) {}

    taut::CableNet net;
    taut::Identification found;
    std::string json;
};

struct taut_plan {
    taut_plan(const taut::Plan& plan, int edges, std::string text)
        : is_feasible(plan.is_feasible),
          strokes(Eigen::VectorXd::Zero(edges)),
          json(std::move(text)) {
        for (const taut::PlannedStroke& one : plan.strokes) {
            strokes(one.edge) = one.stroke;
        }
    }

    bool is_feasible;
    Eigen::VectorXd strokes;
    std::string json;
};

namespace {

using nlohmann::json;
using taut::InputError;

/// Of the calls of one thread.
struct Caller {
    std::string message;
    taut_status status = TAUT_OK;
    taut_progress report = nullptr;
    void* data = nullptr;
    int threads = 0;      ///< 0: any number
    double memory = 0.0;  ///< [bytes]; 0: any
};

Caller& caller() {
    thread_local Caller one;
    return one;
}

taut_status failed(taut_status status, const char* message) noexcept {
    caller().status = status;
    try {
        caller().message = taut::printable(message);
    } catch (...) {
        caller().message.clear();
    }
    return status;
}

taut_status status_of(const std::exception& error) {
    using enum taut::ErrorCode;
    switch (taut::error_code(error)) {
        case argument:
        case net:
        case survey:
        case request:
        case failed_identification:
        case input_file:
        case missing_file:
        case output_file:
            return TAUT_WRONG_INPUT;
        case interrupted:
            return TAUT_INTERRUPTED;
        case no_solution:
        case out_of_memory:
        case peer:
        case other:
            break;
    }
    return TAUT_FAILED;
}

/// Runs a call: what it throws becomes status and message.
template <class Call>
taut_status guarded(const Call& call) noexcept {
    caller().status = TAUT_OK;
    caller().message.clear();
    try {
        std::function<void()> work = call;
        if (const double memory = caller().memory; memory > 0.0) {
            work = [memory, inner = std::move(work)] { taut::with_memory(memory, inner); };
        }
        if (const int threads = caller().threads; threads > 0) {
            taut::with_threads(threads, work);
        } else {
            work();
        }
        return TAUT_OK;
    } catch (const taut::MemoryLimitExceeded& error) {
        return failed(TAUT_FAILED, error.what());
    } catch (const std::bad_alloc&) {
        return failed(TAUT_FAILED, "not enough memory");
    } catch (const std::exception& error) {
        return failed(status_of(error), error.what());
    }
}

/// The same for a call that makes an object; null where it fails.
template <class Make>
auto made(const Make& make) noexcept -> decltype(make().release()) {
    decltype(make()) result;
    guarded([&] { result = make(); });
    return result.release();
}

template <class Pointer>
auto& given(Pointer* pointer, const char* name) {
    if (pointer == nullptr) {
        throw std::invalid_argument(fmt::format("{} is NULL", name));
    }
    return *pointer;
}

std::string text_given(const char* text, const char* name) {
    return &given(text, name);
}

/// What a call reports to: each step, and in between as often as it asks whether to stop.
class Report {
public:
    [[nodiscard]] taut::Progress progress() {
        if (m_report == nullptr) {
            return {};
        }
        return {.report =
                    [this](std::string_view work, int done, int total) {
                        const std::lock_guard lock(m_mutex);
                        m_work = work;
                        m_done = done;
                        m_total = total;
                        call();
                    },
                .stop_requested =
                    [this] {
                        constexpr std::chrono::milliseconds often(50);
                        const std::lock_guard lock(m_mutex);
                        if (std::chrono::steady_clock::now() >= m_last + often) {
                            call();
                        }
                        return m_is_stopped;
                    }};
    }

private:
    void call() {
        m_last = std::chrono::steady_clock::now();
        m_is_stopped = m_is_stopped || m_report(m_work.c_str(), m_done, m_total, m_data) != 0;
    }

    taut_progress m_report = caller().report;
    void* m_data = caller().data;
    std::mutex m_mutex;
    std::string m_work = "preparation";
    int m_done = 0;
    int m_total = 0;
    std::chrono::steady_clock::time_point m_last;  ///< of a call
    bool m_is_stopped = false;
};

/// Options as a JSON object, each read once by its name.
class Options {
public:
    explicit Options(const char* text) {
        if (text == nullptr) {
            return;
        }
        try {
            m_given = json::parse(text);
        } catch (const json::exception&) {
            throw InputError("options", "", "is no JSON");
        }
        if (!m_given.is_object()) {
            throw InputError("options", "", "is no JSON object");
        }
    }

    /// @param expected for the message
    template <class Value>
    std::optional<Value> get(const char* name, const char* expected) {
        m_names.emplace_back(name);
        const auto found = m_given.find(name);
        if (found == m_given.end()) {
            return std::nullopt;
        }
        if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, std::uint64_t>) {
            if (!found->is_number_integer() || *found < 0 ||
                (std::is_same_v<Value, int> && *found > std::numeric_limits<int>::max())) {
                refuse(name, expected);
            }
        } else if constexpr (std::is_same_v<Value, double>) {
            if (!found->is_number()) {
                refuse(name, expected);
            }
        } else if constexpr (std::is_same_v<Value, bool>) {
            if (!found->is_boolean()) {
                refuse(name, expected);
            }
        }
        try {
            return found->get<Value>();
        } catch (const json::exception&) {
            refuse(name, expected);
        }
    }
    std::optional<int> integer(const char* name) {
        return get<int>(name, "an integer of 0 or more, below 2^31");
    }
    std::optional<bool> flag(const char* name) { return get<bool>(name, "true or false"); }
    std::optional<std::string> text(const char* name) { return get<std::string>(name, "a text"); }
    std::vector<std::string> texts(const char* name) {
        return get<std::vector<std::string>>(name, "a list of texts")
            .value_or(std::vector<std::string>());
    }
    /// A text that a function of the library reads.
    template <class Parse>
    auto parsed(const char* name, const Parse& parse)
        -> std::optional<decltype(parse(std::string()))> {
        const std::optional<std::string> given = text(name);
        return given ? std::optional(naming(name, [&] { return parse(*given); })) : std::nullopt;
    }
    template <class Parse>
    auto each_parsed(const char* name, const Parse& parse) {
        std::vector<decltype(parse(std::string()))> result;
        for (const std::string& given : texts(name)) {
            result.push_back(naming(name, [&] { return parse(given); }));
        }
        return result;
    }
    template <class Action>
    static auto naming(const char* name, const Action& action) -> decltype(action()) {
        try {
            return action();
        } catch (const taut::RequestError& error) {
            throw InputError("options", fmt::format("/{}", name), error.problem());
        } catch (const std::invalid_argument& error) {
            throw InputError("options", fmt::format("/{}", name), error.what());
        }
    }
    [[nodiscard]] bool has(const char* name) const { return m_given.contains(name); }
    [[nodiscard]] bool is_text(const char* name) const { return m_given.at(name).is_string(); }

    /// @throws InputError for a name that was not asked for
    void check_names() const {
        for (const auto& [name, value] : m_given.items()) {
            if (std::ranges::find(m_names, name) == m_names.end()) {
                throw InputError(
                    "options", "/" + name,
                    fmt::format("is no option, expected {}", fmt::join(m_names, ", ")));
            }
        }
    }

private:
    [[noreturn]] static void refuse(const char* name, const char* expected) {
        throw InputError("options", fmt::format("/{}", name), fmt::format("is not {}", expected));
    }

    json m_given = json::object();
    std::vector<std::string> m_names;
};

double parse_length_of(const std::string& text) {
    return taut::parse_length(text);
}

std::vector<int> edges_named(Options& options, const char* list, const taut::CableNet& net) {
    std::vector<int> edges;
    for (const std::string& name : options.texts(list)) {
        edges.push_back(net.find_edge(name));
        if (edges.back() < 0) {
            throw InputError("options", fmt::format("/{}", list),
                             fmt::format("names '{}', which is no edge of the net", name));
        }
    }
    return edges;
}

/// Names the option in errors of the table that is its value.
std::string table_of(const std::string& option) {
    return "options:/" + option;
}

taut::Forces forces_of(Options& options, const taut::CableNet& net, const taut::Survey& survey) {
    constexpr double usual_free_length_std = 10e-3;
    taut::Forces forces;
    if (const std::optional<std::string> table = options.text("forces")) {
        forces.measurements = parse_force_measurements(net, *table, table_of("forces"));
    }
    const double free_length_std =
        options.parsed("free_length_std", parse_length_of).value_or(usual_free_length_std);
    if (const std::optional<std::string> table = options.text("frequencies")) {
        for (const taut::FrequencyMeasurement& one :
             parse_frequencies(net, *table, table_of("frequencies"))) {
            forces.measurements.push_back(Options::naming("frequencies", [&] {
                return tension_by_frequency(net, survey.form, one, free_length_std);
            }));
        }
    }
    forces.taut = edges_named(options, "taut_edges", net);
    forces.slack = edges_named(options, "slack_edges", net);
    const std::string warning = Options::naming("forces", [&] {
        check_forces(net, forces);
        return force_unit_warning(net, forces.measurements);
    });
    if (!warning.empty()) {
        throw InputError("options", "/forces", warning);
    }
    return forces;
}

taut::IdentifyOptions identify_options(Options& options, const taut::CableNet& net,
                                       const taut::Survey& survey) {
    taut::IdentifyOptions result;
    result.forces = forces_of(options, net, survey);
    result.method = options.parsed("method", taut::parse_identification_method);
    result.prior = options.parsed(
        "prior", [](const std::string& prior) { return taut::parse_length_prior(prior); });
    result.prior_exact = options.flag("prior_exact").value_or(result.prior_exact);
    result.estimate_noise = options.flag("estimate_noise").value_or(result.estimate_noise);
    result.draws = options.integer("draws");
    result.seed =
        options.get<std::uint64_t>("seed", "an integer of 0 or more").value_or(result.seed);
    if (options.has("uncertain") && options.is_text("uncertain")) {
        if (options.text("uncertain") != "none") {
            throw InputError("options", "/uncertain", "is a text, expected 'none' or a list");
        }
        result.assume_site = false;
    } else {
        result.uncertain = options.each_parsed("uncertain", [](const std::string& one) {
            return taut::parse_uncertain_parameter(one);
        });
    }
    return result;
}

taut::PlanRequest plan_request(const taut::CableNet& net, const char* text) {
    Options options(text);
    taut::PlanRequest result;
    result.options.edges = edges_named(options, "edges", net);
    result.stroke = options.parsed("stroke", parse_length_of).value_or(result.stroke);
    result.total_stroke = options.parsed("total_stroke", parse_length_of);
    result.options.tolerance = options.parsed("tolerance", parse_length_of);
    result.options.actuator_std =
        options.parsed("actuator_std", parse_length_of).value_or(result.options.actuator_std);
    if (const std::optional<double> turn = options.parsed("turn", parse_length_of)) {
        result.options.turn = taut::TurnSize{.pitch = *turn};
    }
    if (const std::optional<double> step = options.get<double>("step", "a number")) {
        if (!result.options.turn) {
            throw InputError("options", "/step", "is a part of a turn, and turn is not given");
        }
        result.options.turn->smallest = *step;
    }
    result.options.confidence =
        options.get<double>("confidence", "a number").value_or(result.options.confidence);
    result.options.seed =
        options.get<std::uint64_t>("seed", "an integer of 0 or more").value_or(result.options.seed);
    result.options.accept_failed = options.flag("accept_failed").value_or(false);
    result.crews = options.integer("crews").value_or(result.crews);
    result.tension = options.each_parsed("tension", taut::parse_tension_range);
    result.reaction = options.each_parsed("reaction", taut::parse_reaction_bound);
    result.target_tension = options.each_parsed("target_tension", taut::parse_target_tension);
    result.stages =
        options.parsed("stages", taut::parse_stages).value_or(std::vector<taut::GivenStage>());
    options.check_names();
    return result;
}

size_t count_of(int count) {
    if (count < 2) {
        throw std::invalid_argument(fmt::format("{} surveys, expected 2 or more", count));
    }
    return static_cast<size_t>(count);
}

/// The table of one survey in a list with one for each after the first; "" where there is none.
std::string table_before(const std::vector<std::string>& tables, size_t survey) {
    return survey > 0 && !tables.empty() ? tables[survey - 1] : "";
}

std::vector<taut::Epoch> epochs_of(Options& options, const taut::CableNet& net,
                                   std::span<const taut_survey* const> surveys) {
    const std::vector<std::string> turned = options.texts("turned");
    const std::vector<std::string> loads = options.texts("loads");
    for (const auto& [name, tables] : {std::pair("turned", &turned), std::pair("loads", &loads)}) {
        if (!tables->empty() && tables->size() + 1 != surveys.size()) {
            throw InputError("options", fmt::format("/{}", name),
                             fmt::format("has {} tables, expected one for each of {} later surveys",
                                         tables->size(), surveys.size() - 1));
        }
    }
    std::vector<taut::Epoch> epochs;
    for (size_t k = 0; k < surveys.size(); ++k) {
        taut::Epoch epoch{.survey = given(surveys[k], "a survey").survey, .turned = {}};
        if (const std::string table = table_before(turned, k); !table.empty()) {
            epoch.turned = parse_turned(net, table, table_of(fmt::format("turned/{}", k - 1)));
        }
        if (const std::string table = table_before(loads, k); !table.empty()) {
            epoch.loads = parse_loads(net, table, table_of(fmt::format("loads/{}", k - 1)));
        }
        epochs.push_back(std::move(epoch));
    }
    return epochs;
}

/// @throws NumericalError where it did not converge
std::unique_ptr<taut_result> result_of(const taut::CableNet& net, const taut::Survey& survey,
                                       taut::Identification found) {
    if (found.status != taut::IdentificationStatus::converged) {
        throw taut::NumericalError(fmt::format("method {}: {}", found.method, found.message));
    }
    std::string text =
        identification_to_json(net, with_noise_times(survey, found.noise_scale), found);
    return std::make_unique<taut_result>(net, std::move(found), std::move(text));
}

taut::Points places_of(const taut::CableNet& net, const double* form) {
    return Eigen::Map<const taut::Points>(form, 3, net.node_count());
}

void copy(const Eigen::VectorXd& from, double* to) {
    if (to != nullptr) {
        std::ranges::copy(from, to);
    }
}

}  // namespace

const char* taut_version(void) {
    static const std::string version(taut::version());
    return version.c_str();
}

const char* taut_error(void) {
    return caller().message.c_str();
}

taut_status taut_last_status(void) {
    return caller().status;
}

void taut_set_progress(taut_progress report, void* data) {
    caller().report = report;
    caller().data = data;
}

taut_status taut_set_threads(int count) {
    return guarded([&] {
        if (count < 0) {
            throw std::invalid_argument(fmt::format("{} threads, expected 0 or more", count));
        }
        caller().threads = count;
    });
}

taut_status taut_set_memory_limit(double bytes) {
    return guarded([&] {
        if (!(bytes >= 0.0)) {
            throw std::invalid_argument(fmt::format("{} bytes, expected 0 or more", bytes));
        }
        caller().memory = bytes;
    });
}

taut_net* taut_read_net(const char* file) {
    return made(
        [&] { return std::make_unique<taut_net>(taut::read_net(text_given(file, "file")).net); });
}

taut_net* taut_parse_net(const char* json_text) {
    return made([&] {
        return std::make_unique<taut_net>(
            taut::parse_net(text_given(json_text, "json"), "net").net);
    });
}

taut_net* taut_builtin_net(const char* name) {
    return made(
        [&] { return std::make_unique<taut_net>(taut::builtin_net(text_given(name, "name"))); });
}

void taut_free_net(taut_net* net) {
    delete net;
}

int taut_node_count(const taut_net* net) {
    return net != nullptr ? net->net.node_count() : 0;
}

int taut_edge_count(const taut_net* net) {
    return net != nullptr ? net->net.edge_count() : 0;
}

const char* taut_net_json(const taut_net* net) {
    return net != nullptr ? net->json.c_str() : nullptr;
}

taut_status taut_equilibrium(const taut_net* net, const double* unstressed_lengths, double* form,
                             double* tensions) {
    return guarded([&] {
        const taut::CableNet& of = given(net, "net").net;
        const Eigen::VectorXd lengths = unstressed_lengths != nullptr
                                            ? Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
                                                  unstressed_lengths, of.edge_count()))
                                            : of.unstressed_lengths();
        const taut::Equilibrium found = taut::EquilibriumSolver(of).solve(lengths, of.nodes());
        if (!found.balanced()) {
            throw taut::NumericalError(
                fmt::format("no equilibrium: {:.4g} N out of balance after {} iterations",
                            found.out_of_balance, found.iterations));
        }
        copy(found.form.reshaped(), form);
        copy(taut::tensions_of(of, found.unstressed_lengths, found.form), tensions);
    });
}

taut_survey* taut_read_survey(const taut_net* net, const char* file, double noise_std) {
    return made([&] {
        if (!(noise_std >= 0.0) || !std::isfinite(noise_std)) {
            throw std::invalid_argument(
                fmt::format("noise_std is {:g}, expected 0 m or more", noise_std));
        }
        taut::ReadSurveyOptions options;
        if (noise_std > 0.0) {
            options.noise_std = noise_std;
        }
        return std::make_unique<taut_survey>(
            taut::read_survey(given(net, "net").net, text_given(file, "file"), options));
    });
}

taut_survey* taut_make_survey(const taut_net* net, const double* form, double noise_std) {
    return made([&] {
        const taut::CableNet& of = given(net, "net").net;
        if (!(noise_std > 0.0) || !std::isfinite(noise_std)) {
            throw std::invalid_argument(
                fmt::format("noise_std is {:g}, expected more than 0 m", noise_std));
        }
        taut::Survey survey{.form = of.nodes(),
                            .noise_std = taut::Points::Constant(3, of.node_count(), noise_std)};
        const taut::Points places = places_of(of, &given(form, "form"));
        for (const int node : of.free_nodes()) {
            const bool is_seen = !places.col(node).hasNaN();
            (is_seen ? survey.surveyed : survey.missing).push_back(node);
            if (is_seen) {
                survey.form.col(node) = places.col(node);
            }
        }
        check_survey(of, survey);
        return std::make_unique<taut_survey>(std::move(survey));
    });
}

void taut_free_survey(taut_survey* survey) {
    delete survey;
}

taut_result* taut_identify(const taut_net* net, const taut_survey* survey, const char* options) {
    return made([&] {
        const taut::CableNet& of = given(net, "net").net;
        const taut::Survey& seen = given(survey, "survey").survey;
        Options all(options);
        const taut::IdentifyOptions settings = identify_options(all, of, seen);
        all.check_names();
        Report report;
        return result_of(of, seen, taut::identify(of, seen, settings, report.progress()));
    });
}

taut_result* taut_identify_epochs(const taut_net* net, const taut_survey* const* surveys, int count,
                                  const char* options) {
    return made([&] {
        const taut::CableNet& of = given(net, "net").net;
        given(surveys, "surveys");
        Options all(options);
        const std::vector<taut::Epoch> epochs = epochs_of(all, of, {surveys, count_of(count)});
        const taut::IdentifyOptions settings = identify_options(all, of, epochs.front().survey);
        all.check_names();
        Report report;
        const auto found = [&] {
            try {
                return taut::identify_epochs(of, epochs, settings, report.progress());
            } catch (const taut::EpochError& error) {
                throw std::invalid_argument(
                    fmt::format("surveys[{}]: {}", error.epoch(), error.what()));
            }
        };
        taut::Identification result = found();
        return result_of(of, epochs[static_cast<size_t>(taut::reported_epoch(epochs))].survey,
                         std::move(result));
    });
}

void taut_free_result(taut_result* result) {
    delete result;
}

const char* taut_verdict(const taut_result* result) {
    return result != nullptr ? to_string(result->found.trust.verdict()).data() : nullptr;
}

const char* taut_result_json(const taut_result* result) {
    return result != nullptr ? result->json.c_str() : nullptr;
}

taut_status taut_result_edges(const taut_result* result, double* lengths, double* length_stds,
                              double* tensions, double* tension_stds) {
    return guarded([&] {
        const auto& [net, found, text] = given(result, "result");
        Eigen::VectorXd identified = taut::built_net_of(net, found).net.unstressed_lengths();
        Eigen::VectorXd stds = Eigen::VectorXd::Zero(net.edge_count());
        for (const taut::IdentifiedEdge& one : found.edges) {
            stds(one.edge) = one.std_dev;
        }
        Eigen::VectorXd of_tensions =
            Eigen::VectorXd::Constant(net.edge_count(), std::numeric_limits<double>::quiet_NaN());
        for (const taut::DrawnTension& one : found.drawn.tensions) {
            of_tensions(one.edge) = one.tension.std_dev;
        }
        copy(identified, lengths);
        copy(stds, length_stds);
        copy(found.tensions, tensions);
        copy(of_tensions, tension_stds);
    });
}

taut_plan* taut_plan_turns(const taut_result* result, const double* target, const char* options) {
    return made([&] {
        const auto& [net, found, text] = given(result, "result");
        const taut::PlanRequest request = plan_request(net, options);
        const taut::BuiltNet built = taut::built_net_of(net, found);
        const taut::FormTarget to(net, target != nullptr ? places_of(net, target) : net.nodes());
        Report report;
        const taut::PlannedTurns turns =
            taut::plan_turns(net, built, to, request, report.progress());
        std::string document = taut::plan_to_json(
            {.net = &net, .built = &built, .trust = &found.trust, .target = &to, .turns = &turns});
        return std::make_unique<taut_plan>(turns.plan, net.edge_count(), std::move(document));
    });
}

void taut_free_plan(taut_plan* plan) {
    delete plan;
}

int taut_plan_is_feasible(const taut_plan* plan) {
    return plan != nullptr && plan->is_feasible ? 1 : 0;
}

const char* taut_plan_json(const taut_plan* plan) {
    return plan != nullptr ? plan->json.c_str() : nullptr;
}

taut_status taut_plan_strokes(const taut_plan* plan, double* strokes) {
    return guarded([&] { copy(given(plan, "plan").strokes, &given(strokes, "strokes")); });
}
