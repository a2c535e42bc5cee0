// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Results as pickle, copy and multiprocessing take them: tuples of their fields, in which numbers
// and arrays keep every bit. Nets are those of the package, which pickle by themselves.
#pragma once

#include <fmt/core.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/tuple.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "fields.hpp"
#include "taut/version.hpp"

namespace taut::python {

/// How the state of a type is made and read.
template <class T>
struct State;

template <class T>
using FieldsOf = decltype(fields_of(std::declval<T&>()));

/// A tuple of its fields.
template <class T>
struct State {
    static nb::object of(const T& value) {
        return std::apply(
            [](const auto&... fields) -> nb::object {
                return nb::make_tuple(State<std::remove_cvref_t<decltype(fields)>>::of(fields)...);
            },
            fields_of(value));
    }
    static T read(nb::handle state) {
        static constexpr size_t count = std::tuple_size_v<FieldsOf<T>>;
        const auto fields = nb::cast<nb::tuple>(state);
        if (fields.size() != count) {
            throw nb::value_error("state: is not one of this class");
        }
        return [&]<size_t... I>(std::index_sequence<I...>) {
            return T{State<std::remove_cvref_t<std::tuple_element_t<I, FieldsOf<T>>>>::read(
                fields[I])...};
        }(std::make_index_sequence<count>());
    }
};

/// Numbers, text and nets are their own state.
template <class T>
    requires(std::is_arithmetic_v<T> || std::is_same_v<T, std::string> ||
             std::is_same_v<T, CableNet>)
struct State<T> {
    static nb::object of(const T& value) { return nb::cast(value); }
    static T read(nb::handle state) { return nb::cast<T>(state); }
};

template <class T>
    requires std::is_enum_v<T>
struct State<T> {
    static nb::object of(T value) { return nb::cast(static_cast<int>(value)); }
    static T read(nb::handle state) { return static_cast<T>(nb::cast<int>(state)); }
};

/// An array, in which each column is a row.
template <class T>
    requires std::is_base_of_v<Eigen::MatrixBase<T>, T>
struct State<T> {
    static nb::object of(const T& value) { return array_of_columns(Eigen::MatrixXd(value)); }
    static T read(nb::handle state) {
        Eigen::MatrixXd matrix = columns_argument(state, "state");
        if ((T::RowsAtCompileTime != Eigen::Dynamic && matrix.rows() != T::RowsAtCompileTime) ||
            (T::ColsAtCompileTime != Eigen::Dynamic && matrix.cols() != T::ColsAtCompileTime)) {
            throw nb::value_error("state: holds an array of another shape");
        }
        return T(std::move(matrix));
    }
};

/// Three corners of a triangle.
template <>
struct State<std::array<int, 3>> {
    static nb::object of(const std::array<int, 3>& corners) {
        return nb::make_tuple(corners[0], corners[1], corners[2]);
    }
    static std::array<int, 3> read(nb::handle state) {
        const auto [first, second, third] = nb::cast<std::tuple<int, int, int>>(state);
        return {first, second, third};
    }
};

template <class T>
struct State<std::optional<T>> {
    static nb::object of(const std::optional<T>& value) {
        return value ? State<T>::of(*value) : nb::none();
    }
    static std::optional<T> read(nb::handle state) {
        return state.is_none() ? std::nullopt : std::optional<T>(State<T>::read(state));
    }
};

template <class T>
struct State<std::vector<T>> {
    static nb::object of(const std::vector<T>& values) {
        nb::list list;
        for (const T& value : values) {
            list.append(State<T>::of(value));
        }
        return list;
    }
    static std::vector<T> read(nb::handle state) {
        std::vector<T> values;
        for (const nb::handle one : nb::cast<nb::list>(state)) {
            values.push_back(State<T>::read(one));
        }
        return values;
    }
};

/// Makes a class pickle and copy by its fields. The state of another version is refused: its fields
/// may be others.
template <class T>
void make_picklable(nb::class_<T>& of) {
    of.def("__getstate__", [](const T& self) {
        return nb::make_tuple(std::string(version()), State<T>::of(self));
    });
    of.def("__setstate__", [](T& self, const nb::tuple& state) {
        if (state.size() != 2) {
            throw nb::value_error("state: is not one of this class");
        }
        try {
            const auto made_by = nb::cast<std::string>(state[0]);
            if (made_by != version()) {
                throw nb::value_error(fmt::format("pickled by taut {}, this is {}: keep what is to "
                                                  "last by save() or to_dict()",
                                                  made_by, version())
                                          .c_str());
            }
            new (&self) T(State<T>::read(state[1]));
        } catch (const nb::cast_error&) {
            throw nb::value_error("state: is not one of this class");
        }
    });
}

}  // namespace taut::python
