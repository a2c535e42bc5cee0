// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/suggested_measurements.hpp"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "identification/load_response.hpp"
#include "identification/planned_fit.hpp"
#include "net/sliding_nodes.hpp"
#include "numerics/dense.hpp"
#include "numerics/parallel.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/survey/cable_sag.hpp"
#include "taut/survey/cable_vibration.hpp"

namespace taut {
namespace {

constexpr std::array<std::pair<std::string_view, MeasurementKind>, 5> kinds{
    {{"load-cell", MeasurementKind::load_cell},
     {"frequency", MeasurementKind::frequency},
     {"sag", MeasurementKind::sag},
     {"target", MeasurementKind::target},
     {"load", MeasurementKind::load}}};

constexpr std::array<std::pair<std::string_view, SoughtQuantity>, 3> quantities{
    {{"mean-tension", SoughtQuantity::mean_tension},
     {"worst-tension", SoughtQuantity::worst_tension},
     {"form", SoughtQuantity::form}}};

template <typename Table, typename T>
std::string_view word_for(const Table& table, T value) {
    return std::ranges::find(table, value, [](const auto& entry) { return entry.second; })->first;
}

template <typename Table>
auto value_of(const Table& table, std::string_view what, std::string_view text) {
    const auto found =
        std::ranges::find(table, text, [](const auto& entry) { return entry.first; });
    if (found == table.end()) {
        std::string expected;
        for (const auto& [word, value] : table) {
            expected += fmt::format("{}{}", expected.empty() ? "" : ", ", word);
        }
        throw std::invalid_argument(
            fmt::format("{} is '{}', expected one of {}", what, text, expected));
    }
    return found->second;
}

/// A measurement that may be made, y = H z + e of the unknowns z of joint_covariance(), with their
/// covariance C given the measurements so far.
struct Candidate {
    SuggestedMeasurement what;
    Rates rates;            ///< H; empty for a load
    Eigen::MatrixXd noise;  ///< covariance of e
    // Of a load, which has many rows:
    Eigen::MatrixXd load_rates = {};  ///< H
    Eigen::MatrixXd with_all = {};    ///< H C
    Eigen::MatrixXd variances = {};   ///< H C H' and the covariance of e

    [[nodiscard]] bool is_load() const { return what.kind == MeasurementKind::load; }
    void start(const Eigen::MatrixXd& C) {
        if (is_load()) {
            with_all = product(load_rates, C);
            variances = noise + product(with_all, load_rates.transpose());
            noise.resize(0, 0);
        }
    }
    /// After C has lost E'E.
    void update(const Eigen::MatrixXd& E) {
        if (is_load()) {
            const Eigen::MatrixXd lost = product(load_rates, E.transpose());
            with_all -= product(lost, E);
            variances -= product(lost, lost.transpose());
        }
    }
    /// L, L L' = H C H' and the covariance of e.
    [[nodiscard]] Eigen::LLT<Eigen::MatrixXd> factor(const Eigen::MatrixXd& C) const {
        if (is_load()) {
            return Eigen::LLT<Eigen::MatrixXd>(variances);
        }
        const Eigen::MatrixXd with_z = rates * C;
        return Eigen::LLT<Eigen::MatrixXd>(rates * with_z.transpose() + noise);
    }
};

void check(const SuggestOptions& options) {
    const auto require = [](bool is_right, const char* what, double value) {
        if (!is_right) {
            throw std::invalid_argument(fmt::format("{}: got {}", what, value));
        }
    };
    const auto positive = [](double x) { return std::isfinite(x) && x > 0.0; };
    for (const auto& [kind, cost] : options.costs) {
        require(positive(cost), "a cost must be positive and finite", cost);
    }
    require(std::isfinite(options.load) && options.load >= 0.0,
            "the load must be 0 or more, and finite", options.load);
    require(positive(options.frequency_std),
            "the standard deviation of frequencies must be positive and finite",
            options.frequency_std);
    require(std::isfinite(options.free_length_std) && options.free_length_std >= 0.0,
            "the standard deviation of the free length must be 0 or more, and finite",
            options.free_length_std);
    require(options.most >= 1, "the number of measurements must be 1 or more", options.most);
}

/// All measurements that may be made, and why others may not.
class Candidates {
public:
    Candidates(const PlannedFit& planned, const Survey& survey, const SuggestOptions& options,
               const Progress& progress)
        : m_planned(planned),
          m_survey(survey),
          m_options(options),
          m_progress(progress),
          m_tensions(tension_rates(planned.model(), planned.iterate())) {
        add_cells();
        if (const Eigen::VectorXd& mass = net().data().mass; mass.size() > 0 && mass.any()) {
            add_frequencies();
            add_sags();
        } else {
            left_out.emplace_back("frequencies and sags: the net has no mass (mass [kg/m])");
        }
        add_targets();
        if (net().sliding_nodes().empty()) {
            add_loads();
        } else {
            left_out.emplace_back(
                "forces, frequencies and sags of edges that slide, and loads, "
                "under which cables slide on: taut cannot predict them");
        }
    }

    std::vector<Candidate> all;
    std::vector<std::string> left_out;

private:
    [[nodiscard]] const CableNet& net() const { return m_planned.net(); }
    [[nodiscard]] const Points& form() const { return m_planned.iterate().form; }

    template <typename Add>
    void for_taut_cables(const Add& add) {
        const std::vector<bool> slides = edges_that_slide(net());
        for (int e = 0; e < net().edge_count(); ++e) {
            if (m_planned.tensions()(e) > 0.0 && !m_planned.is_measured(e) && !net().is_strut(e) &&
                !slides[e]) {
                add(e, m_planned.tensions()(e));
            }
        }
    }
    template <typename Add>
    void for_struts(const Add& add) {
        for (int e = 0; e < net().edge_count(); ++e) {
            if (net().is_strut(e) && !m_planned.is_measured(e)) {
                add(e, m_planned.tensions()(e));
            }
        }
    }

    void add_force(SuggestedMeasurement what, const ForceMeasurement& force) {
        const int common = m_planned.model().common.count();
        Observations observed = nothing_observed(m_planned.fit_net(), 1.0, common);
        observe_force(force, m_planned.knowledge().uncertain, observed);
        what.edge = force.edge;
        Candidate one{
            .what = what,
            .rates = m_tensions.row(force.edge),
            .noise = Eigen::MatrixXd::Constant(1, 1, 1.0 / observed.tension_weights(force.edge))};
        const Eigen::Index first = one.rates.cols() - common;
        for (int k = 0; k < common; ++k) {
            if (const double bias = observed.tension_bias(force.edge, k); bias != 0.0) {
                one.rates.coeffRef(0, first + k) += bias;
            }
        }
        all.push_back(std::move(one));
    }

    void add_cells() {
        const auto add = [&](int e, double tension) {
            constexpr double part = 0.02;
            const double std_dev = part * std::abs(tension);
            add_force({.kind = MeasurementKind::load_cell, .expected = tension, .std_dev = std_dev},
                      {.edge = e, .tension = tension, .std_dev = std_dev});
        };
        for_taut_cables(add);
        for_struts(add);
    }

    void add_frequencies() {
        int refused = 0;
        for_taut_cables([&](int e, double tension) {
            const auto [s, t] = net().edges()[e];
            const double length = (form().col(s) - form().col(t)).norm();
            const double frequency = expected_frequency(net(), e, length, tension).value_or(0.0);
            const double std_dev = m_options.frequency_std * frequency;
            try {
                add_force(
                    {.kind = MeasurementKind::frequency, .expected = frequency, .std_dev = std_dev},
                    tension_by_frequency(net(), form(),
                                         {.edge = e, .frequency = frequency, .std_dev = std_dev},
                                         m_options.free_length_std));
            } catch (const std::invalid_argument&) {  // its own check says whether it is a string
                ++refused;
            }
        });
        leave_out("frequencies", refused, "no strings: without mass, too short, or sagging");
    }

    void add_sags() {
        int refused = 0;
        const double noise = m_survey.rms_noise_std();
        for_taut_cables([&](int e, double tension) {
            const auto [s, t] = net().edges()[e];
            const Eigen::Vector3d chord = form().col(t) - form().col(s);
            const Eigen::Vector3d direction = chord.normalized();
            const Eigen::Vector3d across = -Eigen::Vector3d::UnitZ() + direction.z() * direction;
            std::vector<SagPoint> points;
            double middle = 0.0;
            for (const double x : {0.25, 0.5, 0.75}) {
                const double sag = net().data().mass(e) * gravity * chord.squaredNorm() * x *
                                   (1.0 - x) / (2.0 * tension);
                middle = std::max(middle, sag * across.norm());
                points.push_back({.edge = e,
                                  .position = form().col(s) + x * chord + sag * across,
                                  .std_dev = noise});
            }
            try {
                add_force({.kind = MeasurementKind::sag, .expected = middle, .std_dev = noise},
                          tensions_by_sag(net(), form(), points).front());
            } catch (const std::invalid_argument&) {  // its own check says whether it is seen
                ++refused;
            }
        });
        leave_out("sags", refused,
                  fmt::format("not seen with a standard deviation of {:.3g} mm", 1e3 * noise));
    }

    void leave_out(std::string_view what, int count, std::string_view why) {
        if (count > 0) {
            left_out.push_back(fmt::format("{} of {} edges: {}", what, count, why));
        }
    }

    void add_targets() {
        const double noise = m_survey.rms_noise_std();
        for (const int node : m_survey.missing) {
            Candidate one{.what = {.kind = MeasurementKind::target, .node = node, .std_dev = noise},
                          .rates = {3, m_tensions.cols()},
                          .noise = noise * noise * Eigen::Matrix3d::Identity()};
            for (int i = 0; i < 3; ++i) {
                one.rates.insert(i, 3 * node + i) = 1.0;
            }
            all.push_back(std::move(one));
        }
    }

    void add_loads() {
        if (m_survey.surveyed.empty()) {
            return;
        }
        const double load = m_options.load > 0.0
                                ? m_options.load
                                : 0.05 * mean_weights(net()).dot(m_planned.tensions());
        const std::vector<int> nodes = nodes_to_load(m_planned);
        std::vector<std::optional<LoadResponse>> responses(nodes.size());
        parallel_for(size_t{0}, nodes.size(), [&](size_t k) {
            m_progress.throw_if_stopped();
            responses[k] = response_to_load(m_planned, nodes[k], load, m_survey);
        });
        int refused = 0;
        for (size_t k = 0; k < nodes.size(); ++k) {
            if (responses[k]) {
                all.push_back(
                    {.what = {.kind = MeasurementKind::load, .node = nodes[k], .expected = load},
                     .rates = {},
                     .noise = std::move(responses[k]->noise),
                     .load_rates = std::move(responses[k]->rates)});
            } else {
                ++refused;
            }
        }
        if (refused > 0) {
            left_out.push_back(
                fmt::format("a load of {:g} N at {} of {} nodes: cables would go slack or be "
                            "overloaded (more than twice the highest designed tension, or the "
                            "breaking load)",
                            load, refused, nodes.size()));
        }
    }

    const PlannedFit& m_planned;
    const Survey& m_survey;
    const SuggestOptions& m_options;
    const Progress& m_progress;
    Rates m_tensions;
};

/// The sought numbers g = G z, and what is asked of their variances.
struct Sought {
    Rates rates;    ///< G
    bool is_worst;  ///< the largest, not their mean

    [[nodiscard]] double std_dev(const Eigen::VectorXd& variances) const {
        return std::sqrt(std::max(0.0, is_worst ? variances.maxCoeff() : variances.mean()));
    }
};

Sought sought(const PlannedFit& planned, SoughtQuantity quantity) {
    const Rates tensions = tension_rates(planned.model(), planned.iterate());
    const CableNet& net = planned.net();
    if (quantity == SoughtQuantity::mean_tension) {
        const Eigen::RowVectorXd mean = mean_weights(net).transpose();
        return {.rates = Eigen::RowVectorXd(mean * tensions).sparseView(), .is_worst = false};
    }
    if (quantity == SoughtQuantity::worst_tension) {
        return {.rates = tensions, .is_worst = true};
    }
    Sought result{.rates = {3 * net.free_node_count(), tensions.cols()}, .is_worst = false};
    for (int i = 0; i < net.free_node_count(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            result.rates.insert(3 * i + axis, 3 * net.free_nodes()[i] + axis) = 1.0;
        }
    }
    return result;
}

/// (suggestion): of z given the measurements so far.
class Update {
public:
    Update(Eigen::MatrixXd covariance, const Sought& numbers)
        : m_covariance(std::move(covariance)), m_sought(numbers) {
        set_sought();
    }

    [[nodiscard]] const Eigen::MatrixXd& covariance() const { return m_covariance; }
    [[nodiscard]] double std_dev() const { return m_sought.std_dev(m_variances); }
    [[nodiscard]] double std_with(const Candidate& one) const {
        Eigen::MatrixXd explained = one.is_load()
                                        ? Eigen::MatrixXd(one.with_all * m_sought.rates.transpose())
                                        : Eigen::MatrixXd(one.rates * m_with_sought);
        one.factor(m_covariance).matrixL().solveInPlace(explained);
        return m_sought.std_dev(m_variances -
                                Eigen::VectorXd(explained.colwise().squaredNorm().transpose()));
    }
    /// @return E, by which the covariance has lost E'E
    Eigen::MatrixXd add(const Candidate& one) {
        Eigen::MatrixXd explained =
            one.is_load() ? one.with_all : Eigen::MatrixXd(one.rates * m_covariance);
        one.factor(m_covariance).matrixL().solveInPlace(explained);
        m_covariance -= gram(explained);
        set_sought();
        return explained;
    }

private:
    void set_sought() {
        m_with_sought = m_covariance * m_sought.rates.transpose();
        const Eigen::MatrixXd all = m_sought.rates * m_with_sought;
        m_variances = all.diagonal();
    }

    Eigen::MatrixXd m_covariance;
    const Sought& m_sought;
    Eigen::MatrixXd m_with_sought;  ///< C G'
    Eigen::VectorXd m_variances;    ///< of the sought numbers
};

/// An edge has one force measurement, a node one target, a net one load: what is not known of
/// stiffnesses is the same under another.
bool exclude_each_other(const SuggestedMeasurement& a, const SuggestedMeasurement& b) {
    if (a.kind == MeasurementKind::load) {
        return a.kind == b.kind;
    }
    return a.edge >= 0 ? a.edge == b.edge : a.node == b.node && a.kind == b.kind;
}

}  // namespace

std::string_view to_string(MeasurementKind kind) {
    return word_for(kinds, kind);
}

MeasurementKind parse_measurement_kind(std::string_view text) {
    return value_of(kinds, "a kind of measurement", text);
}

std::string_view to_string(SoughtQuantity quantity) {
    return word_for(quantities, quantity);
}

SoughtQuantity parse_sought_quantity(std::string_view text) {
    return value_of(quantities, "what is sought", text);
}

MeasurementSuggestions suggested_measurements(const CableNet& net, const Points& form,
                                              const Survey& survey, const LengthPrior& prior,
                                              const Forces& forces,
                                              const std::vector<UncertainParameter>& uncertain,
                                              const SuggestOptions& options,
                                              const Progress& progress) {
    check(options);
    if (survey.is_exact()) {
        throw std::invalid_argument(
            "measurements are suggested for a survey with noise (standard deviations): give it");
    }
    constexpr int most_unknowns = 3'000;  // a load then takes some 0.1 GB
    const int unknowns = 3 * net.node_count() + net.edge_count();
    if (unknowns > most_unknowns) {
        throw std::invalid_argument(
            fmt::format("measurements are suggested for nets of at most {} coordinates and "
                        "lengths: this one has {}",
                        most_unknowns, unknowns));
    }
    const PlannedFit planned(
        net, form, survey, prior, forces,
        options.assume_site
            ? with_site_assumptions(net, uncertain, {.by_cells = true, .by_loads = true})
            : uncertain);
    Candidates candidates(planned, survey, options, progress);
    if (!(mean_weights(net).dot(planned.tensions()) > 0.0)) {
        throw std::invalid_argument(
            "measurements are suggested for nets with cables in tension: this one has none");
    }
    const Sought numbers = sought(planned, options.quantity);
    Update update(planned.joint_covariance(options.assume_site), numbers);
    MeasurementSuggestions result{.quantity = options.quantity,
                                  .mean_tension = mean_weights(net).dot(planned.tensions()),
                                  .std_dev = update.std_dev(),
                                  .steps = {},
                                  .left_out = std::move(candidates.left_out)};
    const auto cost_of = [&](const Candidate& one) {
        const auto found = options.costs.find(one.what.kind);
        return found == options.costs.end() ? 1.0 : found->second;
    };
    for (Candidate& one : candidates.all) {
        progress.throw_if_stopped();
        one.start(update.covariance());
    }
    constexpr double least_gain = 0.01;
    double total_cost = 0.0;
    while (std::ssize(result.steps) < options.most && !candidates.all.empty()) {
        std::vector<double> left(candidates.all.size());
        parallel_for(size_t{0}, left.size(), [&](size_t k) {
            progress.throw_if_stopped();
            left[k] = update.std_with(candidates.all[k]);
        });
        std::optional<size_t> best;
        double best_worth = 0.0;
        for (size_t k = 0; k < left.size(); ++k) {
            const double gain = std::log(update.std_dev() / left[k]);
            const double worth = gain / cost_of(candidates.all[k]);
            if (gain > least_gain && worth > best_worth) {
                best = k;
                best_worth = worth;
            }
        }
        if (!best) {
            break;
        }
        const Candidate taken = std::move(candidates.all[*best]);
        const Eigen::MatrixXd explained = update.add(taken);
        total_cost += cost_of(taken);
        SuggestedMeasurement step = taken.what;
        step.remaining_std = update.std_dev();
        step.total_cost = total_cost;
        result.steps.push_back(step);
        std::erase_if(candidates.all, [&](const Candidate& one) {
            return exclude_each_other(taken.what, one.what);
        });
        for (Candidate& one : candidates.all) {
            one.update(explained);
        }
    }
    return result;
}

}  // namespace taut
