// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against files that are no HDF5, or were cut short by a full disk or a broken download: an
// error, and never a crash.

#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>

#include "files/digest.hpp"
#include "support/errors.hpp"
#include "support/examples.hpp"
#include "support/scratch.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/model_h5.hpp"

namespace taut {
namespace {

using test::input_error_of;
using testing::HasSubstr;

class DamagedH5 : public testing::Test {
protected:
    DamagedH5() {
        const NetFile net = test::example_net();
        const DataSet data = test::example_data(net.net);
        write_data_set(m_data, data, net);
        write_model(m_model, test::example_model(net.net, data), net);
    }

    [[nodiscard]] bool reads_data_set(const std::string& bytes) const {
        test::put_bytes(m_damaged, bytes);
        return test::succeeds_or_refuses([this] { return read_data_set(m_damaged); });
    }

    [[nodiscard]] bool reads_model(const std::string& bytes) const {
        test::put_bytes(m_damaged, bytes);
        return test::succeeds_or_refuses([this] { return read_model(m_damaged); });
    }

    test::ScratchDirectory m_scratch;
    std::filesystem::path m_data = m_scratch / "data.h5";
    std::filesystem::path m_model = m_scratch / "model.h5";
    std::filesystem::path m_damaged = m_scratch / "damaged.h5";
};

TEST_F(DamagedH5, IsRefusedWhenCutShortAnywhere) {
    constexpr size_t cuts = 40;
    for (size_t k = 0; k < cuts; ++k) {
        const std::string data = test::bytes_of(m_data);
        const std::string model = test::bytes_of(m_model);
        EXPECT_FALSE(reads_data_set(data.substr(0, k * data.size() / cuts))) << k;
        EXPECT_FALSE(reads_model(model.substr(0, k * model.size() / cuts))) << k;
        EXPECT_FALSE(reads_data_set(data.substr(0, k))) << k;
        EXPECT_FALSE(reads_data_set(data.substr(0, data.size() - 1 - k))) << k;
        EXPECT_FALSE(reads_model(model.substr(0, model.size() - 1 - k))) << k;
    }
}

TEST_F(DamagedH5, IsRefusedWhereAPieceHasAnotherSizeThanItMustHave) {
    // A node of the B-tree of pieces begins with TREE, type 1 and level 0; behind the number of its
    // entries and two siblings stands the size of the first piece (HDF5 file format, III.A.1.).
    constexpr size_t size_at = 24;
    const std::string data = test::bytes_of(m_data);
    const std::string content = data.substr(0, data.rfind("\ndigest "));
    const std::string start("TREE\1\0", 6);
    int count = 0;
    for (size_t node = content.find(start); node != std::string::npos;
         node = content.find(start, node + 1), ++count) {
        for (const std::uint32_t size : {1U, 3U, 4U, 5U, 0xFFU, 0xFFFFFFFFU}) {
            std::string bytes = content;
            std::memcpy(bytes.data() + node + size_at, &size, sizeof size);
            test::put_bytes(m_damaged, bytes + digest_line(bytes));
            EXPECT_THAT(input_error_of([&] { return read_data_set(m_damaged); }),
                        HasSubstr("is damaged: the piece at [0"))
                << size;
        }
    }
    EXPECT_GT(count, 3);
}

TEST_F(DamagedH5, IsNamedAsWhatItIs) {
    for (const std::string bytes :
         {"", "id,x,y,z\n1,2,3,4\n", "{\"format\": \"taut-net\"}", "\x89HDF"}) {
        test::put_bytes(m_damaged, bytes);
        EXPECT_EQ(input_error_of([&] { return read_data_set(m_damaged); }),
                  m_damaged.string() + ": is no HDF5 file, expected a taut-data-set");
    }

    EXPECT_EQ(input_error_of([] { return read_data_set("/dev/zero"); }),
              "/dev/zero: is a device or pipe, expected a file");
    EXPECT_THAT(input_error_of([&] { return read_data_set(m_scratch / "none.h5"); }),
                HasSubstr("none.h5: cannot be read: No such file or directory"));
    EXPECT_EQ(input_error_of([&] { return read_model(m_data); }),
              m_data.string() + ":format: is 'taut-data-set', expected 'taut-model'");
}

TEST_F(DamagedH5, PrintsNothingNorDoesTheProgramThatReadIt) {
    std::string bytes = test::bytes_of(m_data);
    bytes[100] ^= 1;  // in the header of the root
    test::put_bytes(m_damaged, bytes);
    const auto read_and_exit = [this] {
        std::exit(test::succeeds_or_refuses([this] { return read_data_set(m_damaged); }) ? 1 : 0);
    };
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // a process of its own, not a fork of this
    EXPECT_EXIT(read_and_exit(), testing::ExitedWithCode(0), testing::Eq(""));
}

}  // namespace
}  // namespace taut
