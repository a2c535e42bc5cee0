// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <climits>
#include <cstdint>
#include <utility>

namespace taut::python {
namespace {

using Doubles = nb::ndarray<const double, nb::c_contig, nb::device::cpu>;
using Integers = nb::ndarray<const std::int64_t, nb::c_contig, nb::device::cpu>;

std::string shape_text(const auto& array) {
    std::vector<size_t> shape;
    for (size_t i = 0; i < array.ndim(); ++i) {
        shape.push_back(array.shape(i));
    }
    return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

[[noreturn]] void refuse_shape(const auto& array, std::string_view name,
                               std::string_view expected) {
    throw nb::value_error(
        fmt::format("{}: got shape {}, expected {}", name, shape_text(array), expected).c_str());
}

/// numpy.asarray() would take what is masked for numbers.
void refuse_masked(nb::handle value, std::string_view name) {
    if (nb::hasattr(value, "mask") &&
        nb::cast<bool>(nb::module_::import_("numpy.ma").attr("is_masked")(value))) {
        throw nb::value_error(
            fmt::format("{}: has masked entries, expected a number everywhere", name).c_str());
    }
}

/// numpy.asarray(value), where that is numbers of the kinds named.
nb::object as_array(nb::handle value, std::string_view name, std::string_view kinds,
                    const char* expected) {
    refuse_masked(value, name);
    nb::object array;
    try {
        array = nb::module_::import_("numpy").attr("asarray")(value);
    } catch (nb::python_error& error) {
        if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) {
            throw;
        }
        throw nb::value_error(
            fmt::format("{}: got rows of different lengths, expected {}", name, expected).c_str());
    }
    const auto kind = nb::cast<std::string>(array.attr("dtype").attr("kind"));
    const bool is_empty = nb::cast<size_t>(array.attr("size")) == 0;
    if (!is_empty && kinds.find(kind) == std::string_view::npos) {
        throw nb::type_error(
            fmt::format("{}: got {}{}, expected {}", name,
                        nb::hasattr(value, "dtype") ? "dtype " : "",
                        nb::hasattr(value, "dtype")
                            ? nb::cast<std::string>(array.attr("dtype").attr("name"))
                            : nb::cast<std::string>(nb::str(value.type().attr("__name__"))),
                        expected)
                .c_str());
    }
    return array;
}

Integers integers(nb::handle value, std::string_view name) {
    const nb::object array = as_array(value, name, "iu", "whole numbers");
    return nb::cast<Integers>(nb::module_::import_("numpy").attr("asarray")(array, "int64", "C"));
}

int to_int(std::int64_t value, std::string_view name) {
    if (value < INT_MIN || value > INT_MAX) {
        throw nb::value_error(fmt::format("{}: got {}, which is no index", name, value).c_str());
    }
    return static_cast<int>(value);
}

/// The owner of an array that was moved to it.
template <class Data>
nb::capsule owner_of(Data data, const Data*& held) {
    auto* const moved = new Data(std::move(data));
    held = moved;
    return {moved, [](void* p) noexcept { delete static_cast<Data*>(p); }};
}

/// NumPy takes no null, also where there is nothing to read.
template <class Result, class Number>
Result view(const Number* data, std::initializer_list<size_t> shape, nb::handle owner) {
    static constexpr Number nothing{};
    return nb::cast<Result>(nb::cast(
        nb::ndarray<nb::numpy, const Number>(data == nullptr ? &nothing : data, shape, owner),
        nb::rv_policy::automatic));
}

}  // namespace

Doubles numbers(nb::handle value, std::string_view name) {
    refuse_masked(value, name);
    Doubles result;
    if (nb::try_cast(value, result, /*convert=*/false)) {
        return result;
    }
    const nb::object array = as_array(value, name, "iuf", "numbers");
    return nb::cast<Doubles>(nb::module_::import_("numpy").attr("asarray")(array, "float64", "C"));
}

Points points_argument(nb::handle value, std::string_view name, Eigen::Index count) {
    const Doubles array = numbers(value, name);
    const bool fits = array.ndim() == 2 && array.shape(1) == 3 &&
                      (count < 0 || std::cmp_equal(array.shape(0), count));
    if (!fits) {
        refuse_shape(array, name, count < 0 ? "(n, 3)" : fmt::format("({}, 3)", count));
    }
    return Eigen::Map<const Points>(array.data(), 3, static_cast<Eigen::Index>(array.shape(0)));
}

Eigen::Vector3d place_argument(nb::handle value, std::string_view name) {
    return vector_argument(value, name, 3);
}

Eigen::VectorXd vector_argument(nb::handle value, std::string_view name, Eigen::Index count) {
    const Doubles array = numbers(value, name);
    const bool fits = array.ndim() == 1 && (count < 0 || std::cmp_equal(array.shape(0), count));
    if (!fits) {
        refuse_shape(array, name, count < 0 ? "(n,)" : fmt::format("({},)", count));
    }
    return Eigen::Map<const Eigen::VectorXd>(array.data(),
                                             static_cast<Eigen::Index>(array.shape(0)));
}

Eigen::VectorXd vector_or_number(nb::handle value, std::string_view name, Eigen::Index count) {
    const Doubles array = numbers(value, name);
    if (array.ndim() == 0) {
        return Eigen::VectorXd::Constant(count, *array.data());
    }
    if (array.ndim() != 1 || !std::cmp_equal(array.shape(0), count)) {
        refuse_shape(array, name, fmt::format("({},) or one number", count));
    }
    return Eigen::Map<const Eigen::VectorXd>(array.data(), count);
}

Eigen::MatrixXd columns_argument(nb::handle value, std::string_view name) {
    const Doubles array = numbers(value, name);
    if (array.ndim() != 2) {
        refuse_shape(array, name, "(samples, dimensions)");
    }
    return Eigen::Map<const Eigen::MatrixXd>(array.data(),
                                             static_cast<Eigen::Index>(array.shape(1)),
                                             static_cast<Eigen::Index>(array.shape(0)));
}

std::vector<int> indices_argument(nb::handle value, std::string_view name) {
    const Integers array = integers(value, name);
    if (array.ndim() != 1) {
        refuse_shape(array, name, "(n,)");
    }
    std::vector<int> result(array.shape(0));
    for (size_t i = 0; i < result.size(); ++i) {
        result[i] = to_int(array.data()[i], name);
    }
    return result;
}

std::vector<Edge> edges_argument(nb::handle value, std::string_view name) {
    const Integers array = integers(value, name);
    if (array.ndim() != 2 || array.shape(1) != 2) {
        refuse_shape(array, name, "(m, 2)");
    }
    std::vector<Edge> result(array.shape(0));
    for (size_t i = 0; i < result.size(); ++i) {
        result[i] = {to_int(array.data()[2 * i], name), to_int(array.data()[2 * i + 1], name)};
    }
    return result;
}

Array view_of(const Points& points, nb::handle owner) {
    return view<Array>(points.data(), {static_cast<size_t>(points.cols()), 3}, owner);
}

Array view_of(const Eigen::VectorXd& values, nb::handle owner) {
    return view<Array>(values.data(), {static_cast<size_t>(values.size())}, owner);
}

Array rows_of_columns(const Eigen::MatrixXd& matrix, nb::handle owner) {
    return view<Array>(matrix.data(),
                       {static_cast<size_t>(matrix.cols()), static_cast<size_t>(matrix.rows())},
                       owner);
}

IndexArray view_of(const std::vector<int>& indices, nb::handle owner) {
    return view<IndexArray>(indices.data(), {indices.size()}, owner);
}

IndexArray view_of(const std::vector<Edge>& edges, nb::handle owner) {
    return view<IndexArray>(reinterpret_cast<const int*>(edges.data()), {edges.size(), 2}, owner);
}

Array array_of(Points points) {
    const Points* held = nullptr;
    const nb::capsule owner = owner_of(std::move(points), held);
    return view_of(*held, owner);
}

Array array_of(Eigen::VectorXd values) {
    const Eigen::VectorXd* held = nullptr;
    const nb::capsule owner = owner_of(std::move(values), held);
    return view_of(*held, owner);
}

Array array_of_columns(Eigen::MatrixXd matrix) {
    const Eigen::MatrixXd* held = nullptr;
    const nb::capsule owner = owner_of(std::move(matrix), held);
    return rows_of_columns(*held, owner);
}

Array array_of(const Eigen::Vector3d& place) {
    return array_of(Eigen::VectorXd(place));
}

IndexArray array_of(std::vector<int> indices) {
    const std::vector<int>* held = nullptr;
    const nb::capsule owner = owner_of(std::move(indices), held);
    return view_of(*held, owner);
}

}  // namespace taut::python
