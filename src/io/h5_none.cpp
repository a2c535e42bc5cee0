// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/hdf5_none.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/model_h5.hpp"

namespace taut {

std::string data_set_bytes(const DataSet& /*data*/, const NetFile& /*net*/) {
    hdf5::refuse_writing();
}

void write_data_set(const std::filesystem::path& /*path*/, const DataSet& /*data*/,
                    const NetFile& /*net*/) {
    hdf5::refuse_writing();
}

StoredDataSet read_data_set(const std::filesystem::path& path) {
    hdf5::refuse_reading(path);
}

std::string model_bytes(const LengthModel& /*model*/, const NetFile& /*net*/) {
    hdf5::refuse_writing();
}

void write_model(const std::filesystem::path& /*path*/, const LengthModel& /*model*/,
                 const NetFile& /*net*/) {
    hdf5::refuse_writing();
}

StoredModel read_model(const std::filesystem::path& path) {
    hdf5::refuse_reading(path);
}

}  // namespace taut
