// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Values as bytes, as they lie in memory: for processes of one program on machines of one kind,
/// not for files. A type that is more than its bytes has
///
///     template <typename Packing>
///     void pack(Packing& packing, Type& value) {
///         auto& [first, second] = value;  // does not compile if a member is missing
///         packing(first, second);
///     }
///
/// beside it, which serves both directions.
namespace taut {

template <typename T>
concept PlainBytes = std::is_trivially_copyable_v<T>;

/// Appends values one after the other.
class Packer {
public:
    template <typename... Values>
    void operator()(Values&... values) {
        (add(values), ...);
    }

    [[nodiscard]] std::string take() { return std::move(m_bytes); }

private:
    template <typename T>
    void add(T& value) {
        if constexpr (PlainBytes<T>) {
            add_all(&value, 1);
        } else {
            pack(*this, value);
        }
    }
    void add(std::string& text) {
        add_size(text.size());
        m_bytes += text;
    }
    template <typename T>
    void add(std::vector<T>& values) {
        add_size(values.size());
        for (T& value : values) {
            add(value);
        }
    }
    template <int Rows, int Columns>
    void add(Eigen::Matrix<double, Rows, Columns>& matrix) {
        add_size(matrix.rows());
        add_size(matrix.cols());
        add_all(matrix.data(), static_cast<size_t>(matrix.size()));
    }

    template <typename Size>
    void add_size(Size size) {
        const auto number = static_cast<std::uint64_t>(size);
        add_all(&number, 1);
    }
    template <PlainBytes T>
    void add_all(const T* values, size_t count) {
        m_bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
    }

    std::string m_bytes;
};

/// Reads values in the order in which they were packed.
class Unpacker {
public:
    /// @param bytes of a Packer; must outlive this object
    explicit Unpacker(const std::string& bytes) : m_rest(bytes) {}

    /// @throws std::runtime_error if bytes are missing, as between different programs
    template <typename... Values>
    void operator()(Values&... values) {
        (take(values), ...);
    }

private:
    template <typename T>
    void take(T& value) {
        if constexpr (PlainBytes<T>) {
            take_all(&value, 1);
        } else {
            pack(*this, value);
        }
    }
    void take(std::string& text) {
        text.resize(take_size(1));
        take_all(text.data(), text.size());
    }
    template <typename T>
    void take(std::vector<T>& values) {
        values.resize(take_size(1));  // every value takes at least one byte
        for (T& value : values) {
            take(value);
        }
    }
    template <int Rows, int Columns>
    void take(Eigen::Matrix<double, Rows, Columns>& matrix) {
        const size_t row_count = take_size(0);
        const size_t column_count = take_size(0);
        require_numbers(row_count, column_count);
        matrix.resize(static_cast<Eigen::Index>(row_count),
                      static_cast<Eigen::Index>(column_count));
        take_all(matrix.data(), static_cast<size_t>(matrix.size()));
    }

    /// @param bytes that each element takes at least
    size_t take_size(size_t bytes) {
        std::uint64_t size = 0;
        take_all(&size, 1);
        require(bytes * size);
        return size;
    }
    template <PlainBytes T>
    void take_all(T* values, size_t count) {
        require(count * sizeof(T));
        if (count > 0) {
            std::memcpy(static_cast<void*>(values), m_rest.data(), count * sizeof(T));
        }
        m_rest.remove_prefix(count * sizeof(T));
    }
    void require_numbers(size_t rows, size_t columns) const {
        const size_t numbers = m_rest.size() / sizeof(double);
        require(rows == 0 || columns <= numbers / rows ? 0 : m_rest.size() + 1);
    }
    void require(size_t bytes) const {
        if (m_rest.size() < bytes) {
            throw std::runtime_error(
                "a process sent less data than expected: do all processes run the same program?");
        }
    }

    std::string_view m_rest;
};

}  // namespace taut
