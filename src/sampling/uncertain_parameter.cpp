// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/sampling/uncertain_parameter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "sampling/uncertain_widths.hpp"
#include "taut/net/units.hpp"

namespace taut {
namespace {

using Kind = UncertainParameter::Kind;

struct Named {
    std::string_view name;
    Kind kind;
    std::string_view unit;
    bool has_groups;
};

constexpr std::array parameter_names{
    Named{"stiffness", Kind::stiffness, "1", true},
    Named{"stiffness-each", Kind::stiffness_each, "1", true},
    Named{"temperature", Kind::temperature, "K", true},
    Named{"supports", Kind::supports, "m", false},
    Named{"adjustable", Kind::adjustable, "m", false},
    Named{"loads", Kind::loads, "1", false},
    Named{"loads", Kind::loads_each, "N", false},
    Named{"forces", Kind::forces, "1", false},
    Named{"mass", Kind::mass, "1", false},
    Named{"test-loads", Kind::test_loads, "1", false},
    Named{"support-stiffness", Kind::support_stiffness, "1", false},
    Named{"creep", Kind::creep, "1", true},
    Named{"slip", Kind::slip, "m", false}};

constexpr std::string_view with_groups = "stiffness, stiffness-each, temperature and creep";

constexpr std::string_view parameter_examples =
    "stiffness:5%, stiffness-each:3%, temperature:10K, supports:1mm, adjustable:0.5mm, loads:20N, "
    "loads:10%, forces:1%, mass:3%, test-loads:1%, support-stiffness:10%, creep:0.01% or slip:50mm";

const Named& named(Kind kind) {
    return *std::ranges::find(parameter_names, kind, &Named::kind);
}

/// @throws std::invalid_argument where the text is not of the kind's unit
double parse_width(Kind kind, std::string_view text) {
    const std::string_view unit = named(kind).unit;
    return unit == "K"   ? parse_temperature(text)
           : unit == "m" ? parse_length(text)
           : unit == "N" ? parse_force(text)
                         : parse_part(text);
}

std::string width_text(const UncertainParameter& parameter) {
    const std::string_view unit = parameter.unit();
    return unit == "m"   ? format_length(parameter.std_dev)
           : unit == "1" ? fmt::format("{:.12g}%", 1e2 * parameter.std_dev)
                         : fmt::format("{:.12g}{}", parameter.std_dev, unit);
}

/// @param text for the message
/// @throws std::invalid_argument for a width that is not positive, or too large
void check_width(const UncertainParameter& parameter, std::string_view text) {
    // Of a frame hardly more may be known than the order of magnitude.
    const double widest_part = parameter.kind == Kind::support_stiffness ? 0.7 : 0.3;
    if (!(parameter.std_dev > 0.0) || !std::isfinite(parameter.std_dev)) {
        throw std::invalid_argument(
            fmt::format("the uncertain parameter '{}' has no positive width, expected {}", text,
                        parameter_examples));
    }
    if (parameter.unit() == "1" && parameter.std_dev >= widest_part) {
        throw std::invalid_argument(
            fmt::format("the uncertain parameter '{}' has a width of {:g} % or more, expected less",
                        text, 1e2 * widest_part));
    }
}

[[noreturn]] void refuse(const UncertainParameter& parameter, std::string_view problem) {
    throw std::invalid_argument(
        fmt::format("the uncertain parameter '{}' {}", to_string(parameter), problem));
}

/// Unstressed length of the shortest edge at a sliding node [m].
double shortest_sliding(const CableNet& net) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const SlidingNode& at : net.sliding_nodes()) {
        shortest = std::min(
            {shortest, net.unstressed_lengths()(at.before), net.unstressed_lengths()(at.after)});
    }
    return shortest;
}

void check_one(const CableNet& net, const UncertainParameter& parameter) {
    constexpr double widest_part = 1.0 / 3.0;
    constexpr double most_strain = 0.01;
    check_width(parameter, to_string(parameter));
    if (!parameter.group.empty() && !named(parameter.kind).has_groups) {
        refuse(parameter, fmt::format("takes no group: only {} do", with_groups));
    }
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    if (!parameter.group.empty() && !net.data().groups.contains(parameter.group)) {
        std::string groups;
        for (const auto& [name, edges] : net.data().groups) {
            groups += groups.empty() ? name : ", " + name;
        }
        refuse(parameter,
               groups.empty()
                   ? "has a group, but the net has no groups"
                   : fmt::format("has a group that the net does not have, expected one of {}",
                                 groups));
    }
    switch (parameter.kind) {
        case Kind::temperature: {
            const std::vector<int> edges = edges_of(net, parameter);
            const Eigen::VectorXd& expansion = net.data().expansion;
            if (expansion.size() == 0 || (expansion(edges).array() == 0.0).all()) {
                refuse(parameter,
                       "needs edges with a thermal expansion, but the net has no expansion [1/K]");
            }
            if (expansion(edges).cwiseAbs().maxCoeff() * parameter.std_dev > most_strain) {
                refuse(parameter, "strains edges by more than 1 %, expected less");
            }
            break;
        }
        case Kind::adjustable:
            if (net.adjustable_edges().empty()) {
                refuse(parameter, "needs adjustable edges, but the net has none");
            }
            if (parameter.std_dev > widest_part * lengths(net.adjustable_edges()).minCoeff()) {
                refuse(parameter, "is wider than a third of the shortest adjustable edge");
            }
            break;
        case Kind::supports:
            if (parameter.std_dev > widest_part * lengths.minCoeff()) {
                refuse(parameter, "is wider than a third of the shortest edge");
            }
            break;
        case Kind::loads:
            if (net.loads().isZero(0.0)) {
                refuse(parameter,
                       "is a part of the loads, but the net has none: give loads:20N, in newtons");
            }
            break;
        case Kind::loads_each: {
            // No net bears loads that large.
            const double strongest = net.axial_stiffness().maxCoeff();
            if (parameter.std_dev > widest_part * strongest) {
                refuse(parameter, "is wider than a third of the largest axial stiffness");
            }
            break;
        }
        case Kind::mass:
            if (net.data().mass.size() == 0 || net.data().mass.isZero(0.0)) {
                refuse(parameter, "needs edges with a mass, but the net has no mass [kg/m]");
            }
            break;
        case Kind::creep:
            if (parameter.std_dev > most_creep) {
                refuse(parameter, "strains edges by more than 1 %, expected less");
            }
            break;
        case Kind::support_stiffness:
            if (net.elastic_supports().empty()) {
                refuse(parameter, "needs elastic supports, but the net has none");
            }
            break;
        case Kind::slip:
            if (net.sliding_nodes().empty()) {
                refuse(parameter, "needs a run that slides, but the net has none");
            }
            if (parameter.std_dev > widest_part * shortest_sliding(net)) {
                refuse(parameter, "is wider than a third of the shortest edge that slides");
            }
            break;
        case Kind::stiffness:
        case Kind::stiffness_each:
        case Kind::forces:
        case Kind::test_loads:
            break;
    }
}

}  // namespace

std::string_view to_string(UncertainParameter::Kind kind) {
    return named(kind).name;
}

std::string_view UncertainParameter::unit() const {
    return named(kind).unit;
}

std::string to_string(const UncertainParameter& parameter) {
    return fmt::format("{}:{}{}{}", to_string(parameter.kind), width_text(parameter),
                       parameter.group.empty() ? "" : "@", parameter.group);
}

std::string to_string(const std::vector<UncertainParameter>& uncertain) {
    std::string text;
    for (const UncertainParameter& parameter : uncertain) {
        text += (text.empty() ? "" : ", ") + to_string(parameter);
    }
    return text.empty() ? "none" : text;
}

UncertainParameter parse_uncertain_parameter(std::string_view text) {
    const size_t colon = text.find(':');
    const std::string_view name = text.substr(0, colon);
    const size_t at = text.find('@');
    const bool has_width =
        colon != std::string_view::npos && (at == std::string_view::npos || at > colon);
    const auto* found = std::ranges::find(parameter_names, name, &Named::name);
    if (found == parameter_names.end() || !has_width) {
        throw std::invalid_argument(
            found == parameter_names.end()
                ? fmt::format("'{}' is no uncertain parameter: expected {}", text,
                              parameter_examples)
                : fmt::format("'{}' has no width: expected {}", text, parameter_examples));
    }
    const std::string_view width =
        text.substr(colon + 1, at == std::string_view::npos ? at : at - colon - 1);
    UncertainParameter parameter{.kind = found->kind};
    if (parameter.kind == Kind::loads && !width.ends_with('%')) {
        parameter.kind = Kind::loads_each;
    }
    try {
        parameter.std_dev = parse_width(parameter.kind, width);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(
            fmt::format("the uncertain parameter '{}': {}", text, error.what()));
    }
    check_width(parameter, text);
    if (at != std::string_view::npos) {
        parameter.group = text.substr(at + 1);
        if (!found->has_groups || parameter.group.empty()) {
            throw std::invalid_argument(fmt::format(
                "the uncertain parameter '{}' {}", text,
                found->has_groups ? std::string("has no group after @")
                                  : fmt::format("takes no group: only {} do", with_groups)));
        }
    }
    return parameter;
}

void check_uncertain_parameters(const CableNet& net,
                                const std::vector<UncertainParameter>& uncertain) {
    for (auto one = uncertain.begin(); one != uncertain.end(); ++one) {
        check_one(net, *one);
        const bool is_double =
            std::any_of(uncertain.begin(), one, [&](const UncertainParameter& other) {
                return other.kind == one->kind && other.group == one->group;
            });
        if (is_double) {
            refuse(*one, "is given twice");
        }
    }
}

void check_for_one_survey(const CableNet& net, const std::vector<UncertainParameter>& uncertain) {
    check_uncertain_parameters(net, uncertain);
    const auto creep = std::ranges::find(uncertain, Kind::creep, &UncertainParameter::kind);
    if (creep != uncertain.end()) {
        refuse(*creep, "is what edges gain from one survey to the next, expected a second survey");
    }
}

std::vector<UncertainParameter> with_site_assumptions(const CableNet& net,
                                                      std::vector<UncertainParameter> given,
                                                      KnownForces forces) {
    constexpr double common_stiffness = 0.05;
    constexpr double stiffness_of_each = 0.02;
    constexpr double temperature = 5.0;  // [K]
    constexpr double turned = 0.5e-3;    // [m]
    constexpr double moved = 1e-3;       // [m]
    constexpr double most_of_length = 0.1;
    constexpr double of_cells = 0.01;
    constexpr double of_loads = 0.05;
    constexpr double of_mass = 0.03;
    constexpr double of_test_loads = 0.02;
    constexpr double of_supports = 0.25;
    const std::vector<UncertainParameter> before = given;
    const auto assume = [&](Kind kind, double std_dev) {
        const auto is_same = [kind](const UncertainParameter& one) {
            return to_string(kind) == to_string(one.kind);
        };
        if (std_dev > 0.0 && std::ranges::none_of(before, is_same)) {
            given.push_back({.kind = kind, .std_dev = std_dev});
        }
    };
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    assume(Kind::stiffness, common_stiffness);
    assume(Kind::stiffness_each, stiffness_of_each);
    const Eigen::VectorXd& expansion = net.data().expansion;
    assume(Kind::temperature,
           expansion.size() > 0 && expansion.maxCoeff() > 0.0 ? temperature : 0.0);
    if (!net.adjustable_edges().empty()) {
        assume(Kind::adjustable,
               std::min(turned, most_of_length * lengths(net.adjustable_edges()).minCoeff()));
    }
    assume(Kind::supports, std::min(moved, most_of_length * lengths.minCoeff()));
    assume(Kind::support_stiffness, net.elastic_supports().empty() ? 0.0 : of_supports);
    assume(Kind::loads, net.data().loads.isZero(0.0) || net.loads().isZero(0.0) ? 0.0 : of_loads);
    assume(Kind::forces, forces.by_cells ? of_cells : 0.0);
    const Eigen::VectorXd& mass = net.data().mass;
    assume(Kind::mass, mass.size() > 0 && !mass.isZero(0.0) ? of_mass : 0.0);
    assume(Kind::test_loads, forces.by_loads ? of_test_loads : 0.0);
    return with_slips(net, std::move(given));
}

std::vector<UncertainParameter> with_slips(const CableNet& net,
                                           std::vector<UncertainParameter> given) {
    constexpr double any = 0.1;  // more than a cable slides [m]
    constexpr double most_of_length = 0.1;
    if (!net.sliding_nodes().empty() && std_of(given, Kind::slip) == 0.0) {
        given.push_back(
            {.kind = Kind::slip, .std_dev = std::min(any, most_of_length * shortest_sliding(net))});
    }
    return given;
}

std::vector<int> edges_of(const CableNet& net, const UncertainParameter& parameter) {
    if (!parameter.group.empty()) {
        std::vector<int> edges = net.data().groups.at(parameter.group);
        std::ranges::sort(edges);
        return edges;
    }
    std::vector<int> all(net.edge_count());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

double std_of(const std::vector<UncertainParameter>& uncertain, UncertainParameter::Kind kind) {
    const auto found = std::ranges::find(uncertain, kind, &UncertainParameter::kind);
    return found == uncertain.end() ? 0.0 : found->std_dev;
}

Eigen::VectorXd own_stiffness_stds(const CableNet& net,
                                   const std::vector<UncertainParameter>& uncertain) {
    Eigen::VectorXd variances = Eigen::VectorXd::Zero(net.edge_count());
    for (const UncertainParameter& parameter : uncertain) {
        if (parameter.kind == Kind::stiffness_each) {
            variances(edges_of(net, parameter)).array() += parameter.std_dev * parameter.std_dev;
        }
    }
    return variances.cwiseSqrt();
}

}  // namespace taut
