// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/hdf5_reader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "files/digest.hpp"
#include "files/message.hpp"
#include "files/open_file.hpp"
#include "numerics/memory_budget.hpp"
#include "taut/files/input_error.hpp"

namespace taut::hdf5 {
namespace {

std::string_view describe(H5T_class_t type_class) {
    switch (type_class) {
        case H5T_INTEGER:
            return "whole numbers";
        case H5T_FLOAT:
            return "floating point numbers";
        case H5T_STRING:
            return "text of a fixed length";
        default:
            return "another type";
    }
}

bool has_class(hid_t type, H5T_class_t type_class) {
    return H5Tget_class(type) == type_class && H5Tis_variable_str(type) <= 0;
}

/// Without the zero bytes that fill it up.
std::string without_padding(std::string text) {
    text.erase(std::min(text.size(), text.find('\0')));
    return text;
}

/// Nothing between the numbers and the file but Fletcher's checksums.
bool has_checksums_alone(const Handle& properties) {
    unsigned flags = 0;
    size_t values = 0;
    return H5Pget_nfilters(properties.get()) == 1 &&
           H5Pget_filter2(properties.get(), 0, &flags, &values, nullptr, 0, nullptr, nullptr) ==
               H5Z_FILTER_FLETCHER32;
}

/// Of Fletcher's checksum, behind each piece.
constexpr std::uint64_t checksum_size = 4;

Handle open(const std::filesystem::path& path, const std::string& format) {
    const std::string name = path.string();
    static_cast<void>(open_file(path));  // throws in the system's words where it cannot be opened
    silence_errors();
    if (H5Fis_hdf5(name.c_str()) <= 0) {
        throw InputError(name, "", fmt::format("is no HDF5 file, expected a {}", format));
    }
    Handle file(H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file.valid()) {
        throw InputError(name, "", "cannot be opened as HDF5: it is damaged or cut short");
    }
    return file;
}

}  // namespace

Reader::Reader(const std::filesystem::path& path, const std::string& format)
    : m_file_name(path.string()), m_has_digest(check_digest(path)), m_file(open(path, format)) {
    if (!m_has_digest && has_attribute(digest_attribute)) {
        fail("", "is damaged or cut short: its last line, the digest, is missing");
    }
    m_file_size = std::filesystem::file_size(path);
}

void Reader::fail(const std::string& object, const std::string& what) const {
    throw InputError(m_file_name, object, what);
}

Handle Reader::open_attribute(const std::string& name, H5T_class_t type_class) const {
    if (H5Aexists(m_file.get(), name.c_str()) <= 0) {
        fail(name, "is missing, expected an attribute of this name");
    }
    Handle attribute(H5Aopen(m_file.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(attribute.get()), H5Tclose);
    const Handle space(H5Aget_space(attribute.get()), H5Sclose);
    if (!attribute.valid() || !has_class(type.get(), type_class) ||
        H5Sget_simple_extent_type(space.get()) != H5S_SCALAR) {
        fail(name,
             fmt::format("is damaged, or no single value, expected {}", describe(type_class)));
    }
    return attribute;
}

bool Reader::has_attribute(const std::string& name) const {
    return H5Aexists(m_file.get(), name.c_str()) > 0;
}

std::string Reader::text_attribute(const std::string& name) const {
    constexpr size_t longest = 4096;
    const Handle attribute = open_attribute(name, H5T_STRING);
    const Handle type(H5Aget_type(attribute.get()), H5Tclose);
    std::string text(std::min(H5Tget_size(type.get()), longest + 1), '\0');
    if (text.size() > longest || H5Aread(attribute.get(), type.get(), text.data()) < 0) {
        fail(name, fmt::format("cannot be read, expected text of at most {} bytes", longest));
    }
    return without_padding(std::move(text));
}

std::uint64_t Reader::number_attribute(const std::string& name) const {
    const Handle attribute = open_attribute(name, H5T_INTEGER);
    std::uint64_t number = 0;
    if (H5Aread(attribute.get(), H5T_NATIVE_UINT64, &number) < 0) {
        fail(name, "cannot be read");
    }
    return number;
}

/// Every part of the name is in its group, and no link to elsewhere: another file, say.
void Reader::require_inside(const std::string& name) const {
    for (size_t end = name.find('/');; end = name.find('/', end + 1)) {
        const std::string part = name.substr(0, end);
        H5L_info_t link;
        if (H5Lexists(m_file.get(), part.c_str(), H5P_DEFAULT) <= 0) {
            fail(part, "is missing");
        }
        if (H5Lget_info(m_file.get(), part.c_str(), &link, H5P_DEFAULT) < 0 ||
            link.type != H5L_TYPE_HARD) {
            fail(part, "is a link, expected the object itself");
        }
        if (end == std::string::npos) {
            return;
        }
    }
}

int Reader::group_size(const std::string& name) const {
    require_inside(name);
    const Handle group(H5Gopen2(m_file.get(), name.c_str(), H5P_DEFAULT), H5Gclose);
    H5G_info_t info;
    if (!group.valid() || H5Gget_info(group.get(), &info) < 0) {
        fail(name, "is damaged or no group");
    }
    // A member takes far more than a byte of the file: a larger number is damage, or malice.
    if (info.nlinks > std::min<hsize_t>(m_file_size, std::numeric_limits<int>::max())) {
        fail(name, fmt::format("has {} members", info.nlinks));
    }
    return static_cast<int>(info.nlinks);
}

Handle Reader::open_dataset(const std::string& name, H5T_class_t type_class) const {
    require_inside(name);
    Handle dataset(H5Dopen2(m_file.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset.valid()) {
        fail(name, "is damaged or no dataset");
    }
    const Handle type(H5Dget_type(dataset.get()), H5Tclose);
    if (!has_class(type.get(), type_class)) {
        fail(name, fmt::format("is of another type, expected {}", describe(type_class)));
    }
    const Handle properties(H5Dget_create_plist(dataset.get()), H5Pclose);
    const H5D_layout_t layout = H5Pget_layout(properties.get());
    const bool is_in_one_piece = layout == H5D_CONTIGUOUS || layout == H5D_COMPACT;
    if (!(is_in_one_piece || (layout == H5D_CHUNKED && has_checksums_alone(properties))) ||
        H5Pget_external_count(properties.get()) != 0) {
        fail(name, "is stored compressed or elsewhere, expected its numbers in this file");
    }
    return dataset;
}

Reader::Shape Reader::shape_of(const Handle& dataset, const std::string& name) const {
    const Handle space(H5Dget_space(dataset.get()), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space.get());
    std::vector<hsize_t> sizes(std::max(rank, 0));
    if (rank < 0 || H5Sis_simple(space.get()) <= 0 ||
        H5Sget_simple_extent_type(space.get()) == H5S_NULL ||
        H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr) < 0) {
        fail(name, "has no shape");
    }
    const Handle type(H5Dget_type(dataset.get()), H5Tclose);
    std::uint64_t count = std::max<std::uint64_t>(1, H5Tget_size(type.get()));
    for (const hsize_t size : sizes) {
        count = size == 0 || count <= m_file_size / size ? count * size : m_file_size + 1;
    }
    if (count > m_file_size) {
        fail(name, fmt::format("has the shape {}, more than the file can hold", sizes));
    }
    H5D_space_status_t status = H5D_SPACE_STATUS_ERROR;
    H5Dget_space_status(dataset.get(), &status);
    // With checksums the pieces take other room than their numbers: HDF5 then knows no more.
    const Handle properties(H5Dget_create_plist(dataset.get()), H5Pclose);
    const bool is_in_pieces = H5Pget_layout(properties.get()) == H5D_CHUNKED;
    if (count != 0 && status != H5D_SPACE_STATUS_ALLOCATED &&
        !(is_in_pieces && status == H5D_SPACE_STATUS_PART_ALLOCATED)) {
        fail(name, "was never written");
    }
    return {sizes.begin(), sizes.end()};
}

/// That each piece takes the room in the file that it must. HDF5 takes the size that is stored for
/// granted, and reads and writes outside of its memory by a false one.
void Reader::require_pieces(const Handle& dataset, const std::string& name,
                            const Shape& shape) const {
    const Handle properties(H5Dget_create_plist(dataset.get()), H5Pclose);
    if (H5Pget_layout(properties.get()) != H5D_CHUNKED ||
        std::ranges::find(shape, 0U) != shape.end()) {
        return;
    }
    std::vector<hsize_t> piece(shape.size());
    const Handle type(H5Dget_type(dataset.get()), H5Tclose);
    std::uint64_t size = H5Tget_size(type.get());
    if (H5Pget_chunk(properties.get(), static_cast<int>(piece.size()), piece.data()) !=
        static_cast<int>(piece.size())) {
        fail(name, "is stored in pieces of another rank than its shape");
    }
    for (const hsize_t along : piece) {
        size = along == 0 || size > m_file_size / along ? m_file_size + 1 : size * along;
    }
    if (size > m_file_size) {
        fail(name, fmt::format("is stored in pieces of {}, more than the file can hold", piece));
    }
    std::vector<hsize_t> corner(shape.size(), 0);
    for (;;) {
        hsize_t stored = 0;
        if (H5Dget_chunk_storage_size(dataset.get(), corner.data(), &stored) < 0 ||
            stored != size + checksum_size) {
            fail(name, fmt::format("is damaged: the piece at {} takes {} bytes of the file, "
                                   "expected {}",
                                   corner, stored, size + checksum_size));
        }
        size_t k = shape.size();
        while (k > 0 && (corner[k - 1] += piece[k - 1]) >= shape[k - 1]) {
            corner[--k] = 0;
        }
        if (k == 0) {
            return;
        }
    }
}

void Reader::require_shape(const Handle& dataset, const std::string& name,
                           const Shape& shape) const {
    if (const Shape found = shape_of(dataset, name); found != shape) {
        fail(name, fmt::format("has the shape {}, expected {}", found, shape));
    }
    require_pieces(dataset, name, shape);
}

Eigen::Index Reader::row_count(const std::string& name, Eigen::Index columns) const {
    const Shape found = shape_of(open_dataset(name, H5T_FLOAT), name);
    if (found.size() != 2 || found[1] != static_cast<std::uint64_t>(columns)) {
        fail(name, fmt::format("has the shape {}, expected rows of {}", found, columns));
    }
    if (found[0] > std::numeric_limits<int>::max()) {
        fail(name, fmt::format("has {} rows, expected at most {}", found[0],
                               std::numeric_limits<int>::max()));
    }
    return static_cast<Eigen::Index>(found[0]);
}

std::string Reader::text(const std::string& name) const {
    const Handle dataset = open_dataset(name, H5T_STRING);
    require_shape(dataset, name, {});
    const Handle type(H5Dget_type(dataset.get()), H5Tclose);
    std::string text(H5Tget_size(type.get()), '\0');
    read(dataset, name, type.get(), text.data());
    return without_padding(std::move(text));
}

void Reader::read(const Handle& dataset, const std::string& name, hid_t type, void* data) const {
    if (H5Dread(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
        fail(name, "cannot be read: it is damaged");
    }
}

Eigen::MatrixXd Reader::numbers(const std::string& name, const Shape& shape, Eigen::Index rows,
                                Eigen::Index cols) const {
    const Handle dataset = open_dataset(name, H5T_FLOAT);
    require_shape(dataset, name, shape);
    const MemoryCharge charge =
        charge_numbers(static_cast<double>(rows) * static_cast<double>(cols));
    Eigen::MatrixXd values(rows, cols);
    if (values.size() > 0) {
        read(dataset, name, H5T_NATIVE_DOUBLE, values.data());
    }
    if (!values.allFinite()) {
        fail(name, "holds a number that is not finite");
    }
    return values;
}

double Reader::number(const std::string& name) const {
    return numbers(name, {}, 1, 1)(0);
}

Eigen::VectorXd Reader::vector(const std::string& name, Eigen::Index size) const {
    return numbers(name, {static_cast<std::uint64_t>(size)}, size, 1);
}

Eigen::MatrixXd Reader::matrix(const std::string& name, Eigen::Index rows,
                               Eigen::Index cols) const {
    return numbers(name, {static_cast<std::uint64_t>(cols), static_cast<std::uint64_t>(rows)}, rows,
                   cols);
}

std::vector<int> Reader::integers(const std::string& name, Eigen::Index size, int lowest,
                                  int highest) const {
    const Handle dataset = open_dataset(name, H5T_INTEGER);
    require_shape(dataset, name, {static_cast<std::uint64_t>(size)});
    std::vector<std::int64_t> values(size);
    if (size > 0) {
        read(dataset, name, H5T_NATIVE_INT64, values.data());
    }
    std::vector<int> result;
    result.reserve(values.size());
    for (const std::int64_t value : values) {
        if (value < lowest || value > highest) {
            fail(name, fmt::format("holds {}, expected {} to {}", value, lowest, highest));
        }
        result.push_back(static_cast<int>(value));
    }
    return result;
}

}  // namespace taut::hdf5
