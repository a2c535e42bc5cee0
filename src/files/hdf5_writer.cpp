// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/hdf5_writer.hpp"

#include <algorithm>

#include "files/digest.hpp"

namespace taut::hdf5 {
namespace {

/// Creation properties that store no times.
Handle timeless(hid_t property_class) {
    Handle properties = checked(H5Pcreate(property_class), H5Pclose);
    check(H5Pset_obj_track_times(properties.get(), 0));
    return properties;
}

/// Creation properties of a group, or of a file with its root: all links lie in the group's header.
Handle group_properties(hid_t property_class) {
    constexpr unsigned most_links = 256;
    Handle properties = timeless(property_class);
    check(H5Pset_link_phase_change(properties.get(), most_links, 0));
    return properties;
}

/// UTF-8 of a fixed length, so that it lies under the checksums of its object.
Handle text_type(const std::string& text) {
    Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_size(type.get(), std::max<size_t>(1, text.size())));
    check(H5Tset_cset(type.get(), H5T_CSET_UTF8));
    check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD));
    return type;
}

Handle make_space(const std::vector<hsize_t>& shape) {
    return checked(shape.empty()
                       ? H5Screate(H5S_SCALAR)
                       : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                   H5Sclose);
}

/// Under checksums, in pieces of whole rows.
void set_checksums(const Handle& properties, std::vector<hsize_t> shape, hid_t type) {
    constexpr hsize_t piece = hsize_t{1} << 22U;  // bytes
    hsize_t row = H5Tget_size(type);
    for (size_t k = 1; k < shape.size(); ++k) {
        row *= shape[k];
    }
    shape[0] = std::clamp<hsize_t>(piece / row, 1, shape[0]);
    check(H5Pset_chunk(properties.get(), static_cast<int>(shape.size()), shape.data()));
    check(H5Pset_fletcher32(properties.get()));
}

}  // namespace

Writer::Writer() : m_file(group_properties(H5P_FILE_CREATE)) {
    attribute(digest_attribute, "the last line of the file, of all before it");
}

void Writer::write_attribute(hid_t object, const std::string& name, const std::string& text) {
    const Handle type = text_type(text);
    const Handle space = make_space({});
    const Handle attribute =
        checked(H5Acreate2(object, name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
                H5Aclose);
    check(H5Awrite(attribute.get(), type.get(), text.c_str()));
}

void Writer::attribute(const std::string& name, const std::string& text) {
    write_attribute(m_file.get(), name, text);
}

void Writer::attribute(const std::string& name, std::uint64_t number) {
    const Handle space = make_space({});
    const Handle attribute = checked(H5Acreate2(m_file.get(), name.c_str(), H5T_STD_U64LE,
                                                space.get(), H5P_DEFAULT, H5P_DEFAULT),
                                     H5Aclose);
    check(H5Awrite(attribute.get(), H5T_NATIVE_UINT64, &number));
}

void Writer::group(const std::string& name) {
    const Handle properties = group_properties(H5P_GROUP_CREATE);
    checked(H5Gcreate2(m_file.get(), name.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
            H5Gclose);
}

Handle Writer::dataset(const std::string& name, const std::vector<hsize_t>& shape,
                       hid_t stored_type, hid_t memory_type, const void* data) {
    const Handle space = make_space(shape);
    const Handle properties = timeless(H5P_DATASET_CREATE);
    const bool has_values = std::ranges::find(shape, 0U) == shape.end();
    if (has_values && !shape.empty()) {
        set_checksums(properties, shape, stored_type);
    }
    Handle dataset = checked(H5Dcreate2(m_file.get(), name.c_str(), stored_type, space.get(),
                                        H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                             H5Dclose);
    if (has_values) {
        check(H5Dwrite(dataset.get(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    }
    return dataset;
}

void Writer::text(const std::string& name, const std::string& text) {
    const Handle type = text_type(text);
    dataset(name, {}, type.get(), type.get(), text.c_str());
}

void Writer::number(const std::string& name, double value, const std::string& units) {
    write_attribute(dataset(name, {}, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value).get(), "units",
                    units);
}

void Writer::vector(const std::string& name, const Eigen::VectorXd& values,
                    const std::string& units) {
    write_attribute(dataset(name, {static_cast<hsize_t>(values.size())}, H5T_IEEE_F64LE,
                            H5T_NATIVE_DOUBLE, values.data())
                        .get(),
                    "units", units);
}

void Writer::matrix(const std::string& name, const Eigen::MatrixXd& values,
                    const std::string& units) {
    write_attribute(
        dataset(name, {static_cast<hsize_t>(values.cols()), static_cast<hsize_t>(values.rows())},
                H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data())
            .get(),
        "units", units);
}

void Writer::integers(const std::string& name, const std::vector<int>& values) {
    write_attribute(
        dataset(name, {values.size()}, H5T_STD_I32LE, H5T_NATIVE_INT, values.data()).get(), "units",
        "1");
}

void Writer::codes(const std::string& name, const std::vector<std::uint8_t>& codes,
                   const std::string& meaning) {
    const Handle object =
        dataset(name, {codes.size()}, H5T_STD_U8LE, H5T_NATIVE_UINT8, codes.data());
    write_attribute(object.get(), "units", "1");
    write_attribute(object.get(), "meaning", meaning);
}

Image Writer::finish() {
    Image image = m_file.finish();
    image.append(digest_line(image.view()));
    return image;
}

}  // namespace taut::hdf5
