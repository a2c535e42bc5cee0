// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against HDF5 files that are foreign, damaged or made to harm: each must give one clear
// error, and none a crash, an allocation above the file's size or an object that breaks its rules.

#include <gmock/gmock.h>

#include <random>

#include "files/hdf5.hpp"
#include "support/errors.hpp"
#include "support/examples.hpp"
#include "support/scratch.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/model_h5.hpp"

namespace taut {
namespace {

using hdf5::Handle;
using test::input_error_of;
using testing::StartsWith;

/// A data set and a model, written once for all tests.
const std::pair<std::string, std::string>& good_files() {
    static const auto files = [] {
        const test::ScratchDirectory scratch;
        const NetFile net = test::example_net();
        const DataSet data = test::example_data(net.net);
        write_data_set(scratch / "data.h5", data, net);
        write_model(scratch / "model.h5", test::example_model(net.net, data, {}), net);
        return std::pair{test::bytes_of(scratch / "data.h5"), test::bytes_of(scratch / "model.h5")};
    }();
    return files;
}

/// Changes a file through HDF5.
using Change = std::function<void(hid_t file)>;

Change remove(const char* name) {
    return [=](hid_t file) { ASSERT_GE(H5Ldelete(file, name, H5P_DEFAULT), 0); };
}

/// @param data null leaves it unwritten
Change replace(
    const char* name, std::vector<hsize_t> shape, hid_t type, const void* data,
    Change set_properties = [](hid_t) {}) {
    return [=](hid_t file) {
        remove(name)(file);
        const Handle space(
            shape.empty() ? H5Screate(H5S_SCALAR)
                          : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
            H5Sclose);
        const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        set_properties(properties.get());
        const Handle dataset(
            H5Dcreate2(file, name, type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
            H5Dclose);
        ASSERT_TRUE(dataset.valid()) << name;
        if (data != nullptr) {
            ASSERT_GE(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), 0);
        }
    };
}

Change replace_numbers(const char* name, std::vector<hsize_t> shape, double value) {
    return [=](hid_t file) {
        size_t count = 1;
        for (const hsize_t size : shape) {
            count *= size;
        }
        const std::vector<double> values(count, value);
        replace(name, shape, H5T_NATIVE_DOUBLE, values.data())(file);
    };
}

/// The first spectrum as one of so many directions.
Change with_rank(hsize_t rank, double tail_mean, double tail_largest) {
    return [=](hid_t file) {
        replace_numbers("spectra/0/eigenvalues", {rank}, 1.0)(file);
        replace_numbers("spectra/0/eigenvectors", {rank, 30}, 0.0)(file);
        replace_numbers("spectra/0/tail_mean", {}, tail_mean)(file);
        replace_numbers("spectra/0/tail_largest", {}, tail_largest)(file);
    };
}

Change replace_integers(const char* name, size_t count, int value) {
    return [=](hid_t file) {
        const std::vector<int> values(count, value);
        replace(name, {count}, H5T_NATIVE_INT, values.data())(file);
    };
}

Change replace_attribute(const char* name, hid_t type, const void* value) {
    return [=](hid_t file) {
        ASSERT_GE(H5Adelete(file, name), 0);
        if (value != nullptr) {
            const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
            const Handle attribute(
                H5Acreate2(file, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
            ASSERT_GE(H5Awrite(attribute.get(), type, value), 0);
        }
    };
}

/// Text of a fixed length, as taut writes it.
template <typename Use>
Change with_text(std::string text, Use use) {
    return [=](hid_t file) {
        const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(type.get(), text.size());
        H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
        use(type.get(), text.c_str())(file);
    };
}

Change set_text_attribute(const char* name, const std::string& text) {
    return with_text(
        text, [=](hid_t type, const char* value) { return replace_attribute(name, type, value); });
}

Change set_net(const std::string& text) {
    return with_text(text,
                     [](hid_t type, const char* value) { return replace("net", {}, type, value); });
}

/// Reads a data set or a model for its errors.
std::string refusal_of(const std::string& path, bool is_model) {
    return input_error_of([&] {
        return is_model ? read_model(path).net.unknown_keys : read_data_set(path).net.unknown_keys;
    });
}

/// A change, and the object in the file and what is wrong with it.
struct BadFile {
    Change change;
    std::string message;
};

void expect_refused(bool is_model, const std::vector<BadFile>& files) {
    const test::ScratchDirectory scratch;
    const std::string path = (scratch / "file.h5").string();
    for (const BadFile& bad : files) {
        SCOPED_TRACE(bad.message);
        test::put_bytes(path, is_model ? good_files().second : good_files().first);
        {
            const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
            bad.change(file.get());
            // As of a file of taut 0.2.0: else the digest would be all that is looked at.
            H5Adelete(file.get(), "digest");
        }
        EXPECT_THAT(refusal_of(path, is_model), StartsWith(path + ":" + bad.message));
    }
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::uint64_t three = 3;
const hsize_t huge = 1'000'000'000'000;

TEST(BadDataSetH5, IsRefusedNamingTheObject) {
    expect_refused(
        false,
        {{replace_attribute("format", 0, nullptr), "format: is missing, expected an attribute"},
         {set_text_attribute("format", std::string(5000, 'x')),
          "format: cannot be read, expected text of at most 4096 bytes"},
         {replace_attribute("version", H5T_NATIVE_UINT64, &three),
          "version: is 3, expected 1 to 2, which this taut knows"},
         {remove("net"), "net: is missing"},
         {set_net("nodes"), "net:1:2: is no JSON"},
         {with_text("{}",
                    [](hid_t type, const char* text) { return replace("net", {1}, type, text); }),
          "net: has the shape [1], expected []"},
         {set_text_attribute("net_fingerprint", "0123"),
          "net_fingerprint: is '0123', expected '" + test::example_net().net.fingerprint()},
         {set_text_attribute("prior", "triangular:5mm"), "prior: 'triangular:5mm' is no prior"},
         {replace_integers("free_nodes", 6, 0), "free_nodes: is not the list"},
         {replace_numbers("nominal_form", {19}, 0.0),
          "nominal_form: has the shape [19], expected [18]"},
         {replace_numbers("nominal_form", {18}, nan),
          "nominal_form: holds a number that is not finite"},
         {remove("form_deviation"), "form_deviation: is missing"},
         {replace_numbers("form_deviation", {540}, 0.0),
          "form_deviation: has the shape [540], expected rows of 18"},
         {replace_numbers("form_deviation", {31, 18}, 0.0),
          "length_deviation: has the shape [30, 7], expected [31, 7]"},
         {replace("form_deviation", {huge, 18}, H5T_NATIVE_DOUBLE, nullptr),
          "form_deviation: has the shape [1000000000000, 18], more than the file can hold"},
         {replace("form_deviation", {hsize_t{1} << 58U, 18}, H5T_NATIVE_DOUBLE, nullptr,
                  [](hid_t properties) {
                      const std::array<hsize_t, 2> chunk{1, 18};
                      H5Pset_chunk(properties, 2, chunk.data());
                  }),
          "form_deviation: is stored compressed or elsewhere"},
         {replace("form_deviation", {30, 18}, H5T_NATIVE_DOUBLE, nullptr),
          "form_deviation: was never written"},
         {replace(
              "form_deviation", {30, 18}, H5T_NATIVE_DOUBLE, nullptr,
              [](hid_t properties) { H5Pset_external(properties, "/dev/zero", 0, H5F_UNLIMITED); }),
          "form_deviation: is stored compressed or elsewhere"},
         {[](hid_t file) {
              remove("form_deviation")(file);
              H5Lcreate_external("/etc/passwd", "/x", file, "form_deviation", H5P_DEFAULT,
                                 H5P_DEFAULT);
          },
          "form_deviation: is a link, expected the object itself"},
         {replace_integers("status", 30, 4), "status: holds 4, expected 0 to 3"},
         {replace_integers("slack_edges", 30, 18), "slack_edges: holds 18, expected 0 to 17"}});
}

TEST(BadModelH5, IsRefusedNamingTheObject) {
    expect_refused(
        true,
        {{replace_numbers("training_inputs", {31, 18}, 0.0),
          "spectra/0/eigenvectors: has the shape [30, 30], expected rows of 31"},
         {replace_numbers("inverse_length_scale", {7}, 1.25),
          "inverse_length_scale: of process 0 is 1.25, expected "},
         {replace_numbers("signal_std", {7}, 0.0), "signal_std: of process 0 is not positive"},
         {replace_integers("fit_status", 7, 1), "spectrum: of process 0 is "},
         {replace_integers("spectrum", 7, -1),
          "spectrum: of process 0 is -1, but it is marked as fitted"},
         {replace_integers("spectrum", 7, 1000), "spectrum: holds 1000, expected -1 to "},
         {replace_numbers("form_prior/variances", {18}, -1.0),
          "form_prior/variances: holds a negative number"},
         {replace_numbers("form_prior/directions", {18, 18}, 1.0),
          "form_prior/directions: are not orthonormal"},
         {remove("spectra"), "spectra: is missing"},
         {[](hid_t file) {
              H5Lmove(file, "spectra/0", file, "spectra/first", H5P_DEFAULT, H5P_DEFAULT);
          },
          "spectra/0: is missing"},
         {replace_numbers("spectra/0/inverse_length_scale", {}, 0.0),
          "spectra/0/inverse_length_scale: is 0, expected a positive number"},
         {replace_numbers("spectra/0/eigenvalues", {30}, -1e-3),
          "spectra/0/eigenvalues: holds a negative number"},
         {replace_numbers("spectra/0/eigenvectors", {29, 30}, 0.0),
          "spectra/0/eigenvalues: has the shape [30], expected [29]"},
         {replace_numbers("spectra/0/eigenvectors", {31, 30}, 0.0),
          "spectra/0/eigenvectors: has 31 rows, expected 1 to 30"},
         {replace_numbers("spectra/0/tail_largest", {}, 1e-3),
          "spectra/0/tail_largest: is 0.001, expected 0: no direction is left out"},
         {with_rank(29, 0.0, 0.0), "spectra/0/tail_largest: is 0, expected a positive number"},
         {with_rank(29, -1e-3, 1e-3), "spectra/0/tail_mean: is negative"},
         {with_rank(29, 1e-2, 1e-3),
          "spectra/0/tail_largest: is 0.001, expected a positive number, not below tail_mean 0.01"},
         {replace_numbers("approximation_error", {7}, 1e-3),
          "approximation_error: of process 0 is 0.001, expected 0"}});
}

// Every byte is under the digest: whatever is flipped, nothing is read.
TEST(H5Damage, OfAnyByteIsNoticed) {
    const test::ScratchDirectory scratch;
    const std::string path = (scratch / "file.h5").string();
    std::mt19937 random(1);
    for (const bool is_model : {false, true}) {
        const std::string good = is_model ? good_files().second : good_files().first;
        for (int i = 0; i < 300; ++i) {
            std::string bad = good;
            const size_t at = random() % bad.size();
            bad[at] = static_cast<char>(bad[at] ^ (1 << random() % 8));
            test::put_bytes(path, bad);
            EXPECT_THAT(refusal_of(path, is_model), StartsWith(path))
                << "byte " << at << " of " << bad.size();
        }
        test::put_bytes(path, good);
        EXPECT_TRUE(is_model ? read_model(path).has_digest : read_data_set(path).has_digest);
    }
}

}  // namespace
}  // namespace taut
