// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a data set that comes back from its file as another one, and against outputs that
// cannot be told apart from a failed run's.

#include "taut/io/data_set_h5.hpp"

#include <gmock/gmock.h>

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

    void expect_refused(const std::string& what) const {
        try {
            write_data_set(m_path, m_data, m_net);
            ADD_FAILURE() << "expected std::invalid_argument";
        } catch (const std::invalid_argument& error) {
            EXPECT_THAT(error.what(), HasSubstr(what));
        }
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
    write_data_set(m_path, m_data, m_net);
    const StoredDataSet back = read_data_set(m_path);
    expect_same(back.data, m_data);
    EXPECT_EQ(net_to_json(back.net.net, back.net.unknown_keys),
              net_to_json(m_net.net, m_net.unknown_keys));
}

TEST_F(DataSetH5, ReadsBackADataSetWithoutSamples) {
    m_data = test::example_data(m_net.net, 0);
    write_data_set(m_path, m_data, m_net);
    expect_same(read_data_set(m_path).data, m_data);
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

TEST_F(DataSetH5, IsExtendedAfterReadingAsIfItHadNeverBeenWritten) {
    const Sampler sampler(m_net.net, m_data.prior, m_data.seed);
    write_data_set(m_path, m_data, m_net);
    DataSet back = read_data_set(m_path).data;
    sampler.extend(back, 40);
    expect_same(back, test::example_data(m_net.net, 40));
}

TEST_F(DataSetH5, RefusesToBeWrittenWithAnotherNetNamingBoth) {
    m_data.net_fingerprint = "0123456789abcdef";
    expect_refused("0123456789abcdef");
    expect_refused(m_net.net.fingerprint());
}

TEST_F(DataSetH5, RefusesToWriteAnotherNumberOfCoordinates) {
    m_data.form_deviations.conservativeResize(17, Eigen::NoChange);
    expect_refused("form_deviations has 17 x 30 entries, expected 18 x 30");
}

TEST_F(DataSetH5, RefusesToWriteAnotherNumberOfLengthDeviations) {
    m_data.length_deviations.conservativeResize(Eigen::NoChange, 29);
    expect_refused("length_deviations has 7 x 29 entries, expected 7 x 30");
}

TEST_F(DataSetH5, RefusesToWriteANominalFormOfAnotherSize) {
    m_data.nominal_form.conservativeResize(3);
    expect_refused("nominal_form has 3 x 1 entries, expected 18 x 1");
}

TEST_F(DataSetH5, RefusesToWriteFewerStatusesThanSamples) {
    m_data.statuses.pop_back();
    expect_refused("29 statuses");
}

TEST_F(DataSetH5, RefusesToWriteMoreSlackCountsThanSamples) {
    m_data.slack_counts.push_back(0);
    expect_refused("31 slack_counts");
}

TEST_F(DataSetH5, RefusesToWriteANumberThatItCouldNotReadAgain) {
    m_data.form_deviations(2, 1) = std::numeric_limits<double>::infinity();
    expect_refused("form_deviations holds a number that is not finite");
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
