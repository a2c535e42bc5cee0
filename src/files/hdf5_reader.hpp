// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "files/hdf5.hpp"

namespace taut::hdf5 {

/// Reads what Writer wrote, and trusts nothing: an object is read only where it stands in the file
/// itself, has the type and shape that were expected, is no larger than the file and is stored in
/// pieces of the size that they must have; and where the file has a digest, nothing is read unless
/// it is that of the content. All members throw InputError naming the file and the object.
class Reader {
public:
    /// @param format that the file should have, "taut-model": for messages
    Reader(const std::filesystem::path& path, const std::string& format);

    [[nodiscard]] const std::string& file_name() const { return m_file_name; }
    /// Whether the file has a digest, which then is that of its content. Files of taut 0.2.0 and
    /// before have none.
    [[nodiscard]] bool has_digest() const { return m_has_digest; }
    [[noreturn]] void fail(const std::string& object, const std::string& what) const;

    /// Attributes of the root.
    [[nodiscard]] bool has_attribute(const std::string& name) const;
    [[nodiscard]] std::string text_attribute(const std::string& name) const;
    [[nodiscard]] std::uint64_t number_attribute(const std::string& name) const;

    /// Members of a group.
    [[nodiscard]] int group_size(const std::string& name) const;
    /// Rows of a dataset [n, columns].
    [[nodiscard]] Eigen::Index row_count(const std::string& name, Eigen::Index columns) const;

    [[nodiscard]] std::string text(const std::string& name) const;
    /// A finite number.
    [[nodiscard]] double number(const std::string& name) const;
    /// [size], finite.
    [[nodiscard]] Eigen::VectorXd vector(const std::string& name, Eigen::Index size) const;
    /// [cols, rows] as a matrix of rows x cols, finite.
    [[nodiscard]] Eigen::MatrixXd matrix(const std::string& name, Eigen::Index rows,
                                         Eigen::Index cols) const;
    /// [size], each of lowest to highest.
    [[nodiscard]] std::vector<int> integers(const std::string& name, Eigen::Index size, int lowest,
                                            int highest) const;

private:
    using Shape = std::vector<std::uint64_t>;
    [[nodiscard]] Handle open_attribute(const std::string& name, H5T_class_t type_class) const;
    void require_inside(const std::string& name) const;
    [[nodiscard]] Handle open_dataset(const std::string& name, H5T_class_t type_class) const;
    [[nodiscard]] Shape shape_of(const Handle& dataset, const std::string& name) const;
    void require_shape(const Handle& dataset, const std::string& name, const Shape& shape) const;
    void require_pieces(const Handle& dataset, const std::string& name, const Shape& shape) const;
    void read(const Handle& dataset, const std::string& name, hid_t type, void* data) const;
    /// @param shape in the file, @param rows, cols of the result, which hold as many
    [[nodiscard]] Eigen::MatrixXd numbers(const std::string& name, const Shape& shape,
                                          Eigen::Index rows, Eigen::Index cols) const;

    std::string m_file_name;
    bool m_has_digest = false;
    std::uint64_t m_file_size = 0;
    Handle m_file;
};

}  // namespace taut::hdf5
