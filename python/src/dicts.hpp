// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Results as dicts of their fields: kinds as text, numbers of nodes and edges as arrays.
#pragma once

#include <nanobind/nanobind.h>

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "arrays.hpp"
#include "fields.hpp"

namespace taut::python {

template <class T>
nb::object dict_of_fields(const T& value);

/// Of one field.
template <class T>
nb::object as_dict_has_it(const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
        return nb::cast(value);
    } else if constexpr (std::is_enum_v<T>) {
        return nb::cast(std::string(to_string(value)));
    } else if constexpr (std::is_same_v<T, std::vector<int>> || std::is_same_v<T, Points> ||
                         std::is_same_v<T, Eigen::VectorXd> || std::is_same_v<T, Eigen::Vector3d>) {
        return array_of(value);
    } else if constexpr (std::is_same_v<T, Eigen::Matrix3d>) {
        return array_of_columns(value.transpose());
    } else {
        return dict_of_fields(value);
    }
}

template <class T>
nb::object as_dict_has_it(const std::optional<T>& value) {
    return value ? as_dict_has_it(*value) : nb::none();
}

template <class T>
    requires(!std::is_same_v<T, int>)
nb::object as_dict_has_it(const std::vector<T>& values) {
    nb::list list;
    for (const T& value : values) {
        list.append(as_dict_has_it(value));
    }
    return list;
}

/// By the names of the fields.
template <class T>
nb::object dict_of_fields(const T& value) {
    nb::dict dict;
    std::string_view names = names_of(std::type_identity<T>());
    const auto add = [&](const auto& field) {
        const size_t end = names.find(',');
        dict[nb::str(names.data(), std::min(end, names.size()))] = as_dict_has_it(field);
        names.remove_prefix(end == names.npos ? names.size() : end + 2);
    };
    std::apply([&](const auto&... fields) { (add(fields), ...); }, fields_of(value));
    return dict;
}

}  // namespace taut::python
