// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Results as dicts and attributes, one of each field: kinds as text, numbers of nodes and edges as
// arrays.
#pragma once

#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "fields.hpp"

namespace taut::python {

[[nodiscard]] inline std::string_view to_string(BoundaryOutlier::Kind kind) {
    return kind == BoundaryOutlier::Kind::support ? "support" : "adjustable_edge";
}
[[nodiscard]] inline std::string_view to_string(LimitBreach::Kind kind) {
    return kind == LimitBreach::Kind::reaction ? "reaction" : "tension";
}

template <class T>
nb::dict dict_of_fields(const T& value);

/// What Python gets of one field. Its type is in the stubs.
template <class T>
auto in_python_types(const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
        return value;
    } else if constexpr (std::is_enum_v<T>) {
        return std::string(to_string(value));
    } else if constexpr (std::is_same_v<T, LengthPrior> || std::is_same_v<T, UncertainParameter>) {
        return to_string(value);
    } else if constexpr (std::is_same_v<T, std::vector<int>> || std::is_same_v<T, Points> ||
                         std::is_same_v<T, Eigen::VectorXd> || std::is_same_v<T, Eigen::Vector3d>) {
        return array_of(value);
    } else if constexpr (std::is_same_v<T, Eigen::MatrixXd>) {
        return array_of_columns(value);
    } else if constexpr (std::is_same_v<T, Eigen::Matrix3d>) {
        return array_of_columns(value.transpose());
    } else {
        return dict_of_fields(value);
    }
}

template <class T>
    requires(!std::is_same_v<T, int>)
nb::list in_python_types(const std::vector<T>& values) {
    nb::list list;
    for (const T& value : values) {
        list.append(in_python_types(value));
    }
    return list;
}

template <class T>
auto in_python_types(const std::optional<T>& value) {
    return value ? std::optional(in_python_types(*value)) : std::nullopt;
}

/// The names of the fields of a struct, in their order.
template <class T>
std::vector<std::string> field_names() {
    std::vector<std::string> names;
    std::string_view rest = names_of(std::type_identity<T>());
    while (!rest.empty()) {
        const size_t end = std::min(rest.find(','), rest.size());
        names.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 2, rest.size()));
    }
    return names;
}

/// By the names of the fields.
template <class T>
nb::dict dict_of_fields(const T& value) {
    nb::dict dict;
    size_t i = 0;
    const std::vector<std::string> names = field_names<T>();
    const auto add = [&](const auto& field) {
        dict[nb::str(names[i++].c_str())] = in_python_types(field);
    };
    std::apply([&](const auto&... fields) { (add(fields), ...); }, fields_of(value));
    return dict;
}

/// Gives a class an attribute of each field that has a text here.
/// @param get the struct in an object of the class: a member, or std::identity
/// @param texts what each field is, with shape and unit, by its name
/// @throws std::logic_error for a name of no field
template <class T, class Of, class Get>
void bind_fields(nb::class_<Of>& of, Get get, std::map<std::string, const char*> texts) {
    const std::vector<std::string> names = field_names<T>();
    const auto bind = [&]<size_t I>(std::integral_constant<size_t, I>) {
        if (const auto text = texts.extract(names[I])) {
            of.def_prop_ro(
                names[I].c_str(),
                [get](const Of& self) {
                    return in_python_types(std::get<I>(fields_of(std::invoke(get, self))));
                },
                text.mapped());
        }
    };
    [&]<size_t... I>(std::index_sequence<I...>) {
        (bind(std::integral_constant<size_t, I>()), ...);
    }(std::make_index_sequence<std::tuple_size_v<decltype(fields_of(std::declval<T&>()))>>());
    if (!texts.empty()) {
        throw std::logic_error(fmt::format("{}: is no field", texts.begin()->first));
    }
}

template <class Edges>
[[nodiscard]] nb::list status_of_each(const Edges& edges) {
    nb::list list;
    for (const auto& edge : edges) {
        list.append(to_string(edge.status));
    }
    return list;
}

}  // namespace taut::python
