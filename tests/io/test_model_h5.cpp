// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a model that predicts something else after it was written and read.

#include "taut/io/model_h5.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <cmath>

#include "files/hdf5.hpp"
#include "support/examples.hpp"
#include "support/scratch.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/identification/result.hpp"
#include "taut/sampling/sampler.hpp"

namespace taut {
namespace {

using test::same_bits;
using testing::HasSubstr;

class ModelH5 : public testing::Test {
protected:
    test::ScratchDirectory m_scratch;
    NetFile m_net = test::example_net();
    DataSet m_data = test::example_data(m_net.net);
    std::filesystem::path m_path = m_scratch / "model.h5";

    /// What is written of a model, which is all of it: test_h5py.cpp.
    [[nodiscard]] std::string bytes_of(const LengthModel& model, const NetFile& net) const {
        write_model(m_scratch / "bytes.h5", model, net);
        return test::bytes_of(m_scratch / "bytes.h5");
    }
    /// A model that comes back from m_path is that which was written.
    void expect_read_back(const LengthModel& model, const NetFile& net) const {
        const LengthModel back = read_model(m_path).model;
        EXPECT_TRUE(bytes_of(back, net) == bytes_of(model, net));
        EXPECT_TRUE(same_bits(back.form_prior.inputs, model.form_prior.inputs));
    }
    void expect_kept(const LengthModel& model, const NetFile& net) const {
        write_model(m_path, model, net);
        expect_read_back(model, net);
    }

    [[nodiscard]] LengthModel low_rank_model() const {
        gp::FitSettings fit;
        fit.most_decomposed = 20;
        fit.rank = 12;
        return test::example_model(m_net.net, m_data, {.fit = fit});
    }

    void expect_refused(const LengthModel& model, const std::string& what) const {
        EXPECT_THAT([&] { write_model(m_path, model, m_net); },
                    testing::ThrowsMessage<std::invalid_argument>(HasSubstr(what)));
        EXPECT_FALSE(std::filesystem::exists(m_path));
    }
};

TEST_F(ModelH5, ReadsBackEverythingToTheLastBit) {
    const LengthModel model = test::example_model(m_net.net, m_data);
    expect_kept(model, m_net);
    const StoredModel back = read_model(m_path);
    EXPECT_EQ(net_to_json(back.net.net, back.net.unknown_keys),
              net_to_json(m_net.net, m_net.unknown_keys));
}

TEST_F(ModelH5, KeepsMeanFunctionAndKernel) {
    for (const KernelMetric metric : {KernelMetric::direction, KernelMetric::node}) {
        const LengthModel model = test::example_model(
            m_net.net, m_data, {.mean = MeanFunction::geometry, .metric = metric});
        ASSERT_GT(model.input_scales.maxCoeff(), 1.01 * model.input_scales.minCoeff());
        expect_kept(model, m_net);
    }
}

TEST_F(ModelH5, HasNoFormPriorOfALargeNet) {
    const NetFile large{.net = hypar(26, 40), .unknown_keys = "{}"};
    const DataSet data = draw_samples(Sampler(large.net, {}, 1), 3);
    const LengthModel model = train_model(large.net, data, {0, 1, 2});
    EXPECT_EQ(model.form_prior.mean.size(), 0);
    expect_kept(model, large);
}

TEST_F(ModelH5, MakesTheFormPriorOfAFileThatHasNone) {
    const LengthModel model = test::example_model(m_net.net, m_data, {});
    write_model(m_path, model, m_net);
    {  // as a file of taut 0.2.0
        const hdf5::Handle file(H5Fopen(m_path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
        ASSERT_GE(H5Ldelete(file.get(), "form_prior", H5P_DEFAULT), 0);
        ASSERT_GE(H5Ldelete(file.get(), "approximation_error", H5P_DEFAULT), 0);
        for (size_t k = 0; k < model.processes.spectra.size(); ++k) {
            for (const char* const name : {"tail_mean", "tail_largest"}) {
                const std::string path = fmt::format("spectra/{}/{}", k, name);
                ASSERT_GE(H5Ldelete(file.get(), path.c_str(), H5P_DEFAULT), 0);
            }
        }
        ASSERT_GE(H5Adelete(file.get(), "digest"), 0);
        ASSERT_GE(H5Arename(file.get(), "prior", "law"), 0);
        const hdf5::Handle version(H5Aopen(file.get(), "version", H5P_DEFAULT), H5Aclose);
        const std::uint64_t two = 2;
        ASSERT_GE(H5Awrite(version.get(), H5T_NATIVE_UINT64, &two), 0);
    }
    expect_read_back(model, m_net);
}

TEST_F(ModelH5, KeepsSpectraOfLowRankAndTheirErrors) {
    const LengthModel model = low_rank_model();
    ASSERT_EQ(model.processes.rank(), 12);
    ASSERT_GT(model.processes.processes[0].approximation_error, 0.0);
    expect_kept(model, m_net);
    const LengthModel back = read_model(m_path).model;
    const LengthEstimates before = estimate_lengths(m_net.net, model, m_data.form_deviations);
    const LengthEstimates after = estimate_lengths(m_net.net, back, m_data.form_deviations);
    EXPECT_TRUE(same_bits(before.mean, after.mean));
    EXPECT_TRUE(same_bits(before.std_dev, after.std_dev));
}

TEST_F(ModelH5, RefusesToWriteWhatItCouldNotReadAgain) {
    const LengthModel whole = test::example_model(m_net.net, m_data);
    const auto refused = [&](LengthModel model, const auto& change, const std::string& what) {
        change(model);
        expect_refused(model, what);
    };
    refused(whole, [](auto& m) { m.net_fingerprint = "0123456789abcdef"; }, "0123456789abcdef");
    refused(
        whole, [](auto& m) { m.processes.inputs.conservativeResize(17, Eigen::NoChange); },
        "inputs has 17 x 30 entries, expected 18 x 30");
    refused(
        whole, [](auto& m) { m.processes.weights.conservativeResize(29, Eigen::NoChange); },
        "weights has 29 x 7 entries, expected 30 x 7");
    refused(whole, [](auto& m) { m.processes.processes.pop_back(); }, "6 processes, expected 7");
    refused(
        whole, [](auto& m) { m.processes.spectra[0].eigenvalues.conservativeResize(5); },
        "eigenvalues has 5 x 1 entries, expected 30 x 1");
    refused(
        whole, [](auto& m) { m.processes.processes[3].negative_log_likelihood = std::nan(""); },
        "negative_log_likelihood holds a number that is not finite");
    refused(
        whole, [](auto& m) { m.processes.spectra[0].tail_largest = 1e-3; },
        "tail_largest is 0.001, expected 0: no direction is left out");
    refused(
        whole, [](auto& m) { m.processes.processes[0].approximation_error = 1e-3; },
        "approximation_error is 0.001, expected 0");
    refused(
        low_rank_model(), [](auto& m) { m.processes.spectra[0].tail_largest = 0.0; },
        "tail_largest is 0, expected a positive number");
}

TEST_F(ModelH5, KeepsProcessesThatCouldNotBeFitted) {
    for (const bool is_all : {false, true}) {
        m_data.length_deviations.middleRows(is_all ? 0 : 2, is_all ? 7 : 1).setConstant(0.001);
        const LengthModel model = test::example_model(m_net.net, m_data);
        ASSERT_EQ(model.processes.processes[2].status, gp::FitStatus::constant_output);
        ASSERT_EQ(model.processes.spectra.empty(), is_all);
        expect_kept(model, m_net);
    }
}

}  // namespace
}  // namespace taut
