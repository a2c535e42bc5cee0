// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// NumPy arrays in and out. In: copied, so that a change of the array during a call has no effect.
// Errors of shape and dtype name the argument. Out: read-only views of what an object holds, which
// keep it alive, or arrays that own what was moved into them. A form has a row for each node here,
// (n, 3), and a column for each node in C++: the same numbers in the same order.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <Eigen/Core>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut::python {

namespace nb = nanobind;

/// An argument that numpy.asarray() makes an array of; the functions below give its shape.
class ArrayLike : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(ArrayLike, nb::object, "numpy.typing.ArrayLike", is_any)
};

/// Read-only, of doubles.
class Array : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(Array, nb::object, "numpy.typing.NDArray[numpy.float64]", is_any)
};
/// Read-only, of indices.
class IndexArray : public nb::object {
    static bool is_any(nb::handle) { return true; }
    NB_OBJECT(IndexArray, nb::object, "numpy.typing.NDArray[numpy.int32]", is_any)
};

/// Whatever numpy.asarray() makes of an argument, where that is numbers: doubles, in C order.
/// @throws nb::type_error for what is no array of numbers, by the argument's name
[[nodiscard]] nb::ndarray<const double, nb::c_contig, nb::device::cpu> numbers(
    nb::handle value, std::string_view name);

/// (n, 3) as 3 x n.
/// @param count n; -1: any
/// @throws nb::value_error for another shape
[[nodiscard]] Points points_argument(nb::handle value, std::string_view name, Eigen::Index count);

/// (3,).
[[nodiscard]] Eigen::Vector3d place_argument(nb::handle value, std::string_view name);

/// (n,).
/// @param count n; -1: any
/// @throws nb::value_error for another shape
[[nodiscard]] Eigen::VectorXd vector_argument(nb::handle value, std::string_view name,
                                              Eigen::Index count);

/// (n,), or one number for all.
/// @throws nb::value_error for another shape
[[nodiscard]] Eigen::VectorXd vector_or_number(nb::handle value, std::string_view name,
                                               Eigen::Index count);

/// (k, d) as d x k: a sample is a row here, a column in C++.
/// @throws nb::value_error for another shape
[[nodiscard]] Eigen::MatrixXd columns_argument(nb::handle value, std::string_view name);

/// Whole numbers (n,), in any sequence.
/// @throws nb::type_error for what is no sequence of whole numbers, nb::value_error for one that
///   an int cannot hold
[[nodiscard]] std::vector<int> indices_argument(nb::handle value, std::string_view name);

/// Pairs of whole numbers (m, 2).
/// @throws as indices_argument()
[[nodiscard]] std::vector<Edge> edges_argument(nb::handle value, std::string_view name);

/// (n, 3) of what the owner holds.
[[nodiscard]] Array view_of(const Points& points, nb::handle owner);
/// (n,) of what the owner holds.
[[nodiscard]] Array view_of(const Eigen::VectorXd& values, nb::handle owner);
/// (k, d) of the d x k matrix that the owner holds: a column of that is a row here.
[[nodiscard]] Array rows_of_columns(const Eigen::MatrixXd& matrix, nb::handle owner);
/// (n,) of what the owner holds.
[[nodiscard]] IndexArray view_of(const std::vector<int>& indices, nb::handle owner);
/// (m, 2) of what the owner holds.
[[nodiscard]] IndexArray view_of(const std::vector<Edge>& edges, nb::handle owner);

/// Arrays that own their numbers, in the shapes above.
[[nodiscard]] Array array_of(Points points);
[[nodiscard]] Array array_of(Eigen::VectorXd values);
[[nodiscard]] Array array_of_columns(Eigen::MatrixXd matrix);
[[nodiscard]] Array array_of(const Eigen::Vector3d& place);
[[nodiscard]] IndexArray array_of(std::vector<int> indices);

/// A number of each element, (n,).
/// @param get a member, or a function of an element
template <class Range, class Get>
[[nodiscard]] Array array_of_each(const Range& range, Get get) {
    Eigen::VectorXd values(std::ssize(range));
    Eigen::Index i = 0;
    for (const auto& one : range) {
        values(i++) = std::invoke(get, one);
    }
    return array_of(std::move(values));
}

/// The edge of each element, (n,).
template <class Range>
[[nodiscard]] IndexArray edges_of_each(const Range& range) {
    std::vector<int> edges;
    for (const auto& one : range) {
        edges.push_back(one.edge);
    }
    return array_of(std::move(edges));
}

}  // namespace taut::python
