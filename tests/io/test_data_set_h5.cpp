// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a data set that comes back from its file as another one, and against outputs that
// cannot be distinguished from a failed run's.

#include "taut/io/data_set_h5.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "support/errors.hpp"
#include "support/examples.hpp"
#include "support/scratch.hpp"
#include "taut/files/file.hpp"

namespace taut {
namespace {

using test::bytes_of;
using test::same_bits;
using testing::HasSubstr;

void expect_same(const DataSet& a, const DataSet& b) {
    EXPECT_EQ(a.net_fingerprint, b.net_fingerprint);
    EXPECT_EQ(a.prior, b.prior);
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_TRUE(same_bits(a.nominal_form, b.nominal_form));
    EXPECT_TRUE(same_bits(a.form_deviations, b.form_deviations));
    EXPECT_TRUE(same_bits(a.length_deviations, b.length_deviations));
    EXPECT_EQ(a.statuses, b.statuses);
    EXPECT_EQ(a.slack_counts, b.slack_counts);
}

class DataSetH5 : public testing::Test {
protected:
    test::ScratchDirectory m_scratch;
    NetFile m_net = test::example_net();
    DataSet m_data = test::example_data(m_net.net);
    std::filesystem::path m_path = m_scratch / "data.h5";

    template <class Change>
    void expect_refused(const Change& change, const std::string& what) const {
        DataSet data = m_data;
        change(data);
        EXPECT_THAT([&] { write_data_set(m_path, data, m_net); },
                    testing::ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
        EXPECT_FALSE(std::filesystem::exists(m_path));
    }
};

TEST_F(DataSetH5, ReadsBackEverythingToTheLastBit) {
    m_data.seed = std::numeric_limits<std::uint64_t>::max();
    m_data.prior = {.kind = LengthPrior::Kind::bimodal, .scale = 1.0 / 300.0};
    m_data.statuses[3] = EquilibriumStatus::slack_mechanism;
    m_data.statuses[4] = EquilibriumStatus::iteration_limit;
    m_data.slack_counts[3] = 5;
    m_data.form_deviations(0, 0) = -0.0;
    m_data.form_deviations(1, 0) = std::numeric_limits<double>::denorm_min();
    for (const DataSet& data : {m_data, test::example_data(m_net.net, 0)}) {
        write_data_set(m_path, data, m_net);
        expect_same(read_data_set(m_path).data, data);
    }
    const StoredDataSet back = read_data_set(m_path);
    EXPECT_EQ(net_to_json(back.net.net, back.net.unknown_keys),
              net_to_json(m_net.net, m_net.unknown_keys));
}

TEST_F(DataSetH5, IsTheSameToTheByteWhenWrittenTwice) {
    write_data_set(m_path, m_data, m_net);
    const std::string bytes = bytes_of(m_path);
    // HDF5 stores times in seconds where it stores them.
    sleep(2);
    write_data_set(m_path, read_data_set(m_path).data, m_net);
    EXPECT_TRUE(bytes_of(m_path) == bytes);
    EXPECT_THAT(m_scratch.files(), testing::ElementsAre("data.h5"));
}

TEST_F(DataSetH5, RefusesToWriteWhatItCouldNotReadAgain) {
    expect_refused([](DataSet& d) { d.net_fingerprint = "0123456789abcdef"; }, "0123456789abcdef");
    expect_refused([](DataSet& d) { d.form_deviations.conservativeResize(17, Eigen::NoChange); },
                   "form_deviations has 17 x 30 entries, expected 18 x 30");
    expect_refused([](DataSet& d) { d.length_deviations.conservativeResize(Eigen::NoChange, 29); },
                   "length_deviations has 7 x 29 entries, expected 7 x 30");
    expect_refused([](DataSet& d) { d.nominal_form.conservativeResize(3); },
                   "nominal_form has 3 x 1 entries, expected 18 x 1");
    expect_refused([](DataSet& d) { d.statuses.pop_back(); }, "29 statuses");
    expect_refused([](DataSet& d) { d.slack_counts.push_back(0); }, "31 slack_counts");
    expect_refused([](DataSet& d) { d.form_deviations(2, 1) = HUGE_VAL; },
                   "form_deviations holds a number that is not finite");
}

TEST_F(DataSetH5, LeavesAnEarlierFileWhereItCannotBeWritten) {
    test::put_bytes(m_path, "before");
    EXPECT_THROW(write_data_set(m_scratch / "nowhere/data.h5", m_data, m_net), OutputError);
    m_data.net_fingerprint.clear();
    EXPECT_THROW(write_data_set(m_path, m_data, m_net), std::invalid_argument);
    EXPECT_EQ(bytes_of(m_path), "before");
    EXPECT_THAT(m_scratch.files(), testing::ElementsAre("data.h5"));
}

}  // namespace
}  // namespace taut
