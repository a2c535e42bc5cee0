// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against files that only taut can read: h5py alone must find every number where the headers
// say it lies.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "support/examples.hpp"
#include "support/scratch.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/io/model_h5.hpp"

namespace taut {
namespace {

using nlohmann::json;

/// What h5py finds in the file; nothing where h5py is not installed.
std::optional<json> read_with_h5py(const std::filesystem::path& path) {
    const std::string command = fmt::format("/usr/bin/python3 '{}/read_with_h5py.py' '{}'",
                                            TAUT_IO_TEST_DIR, path.string());
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) {
        return std::nullopt;
    }
    std::string output;
    std::array<char, 4096> buffer{};
    while (const size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        output.append(buffer.data(), count);
    }
    constexpr int no_h5py = 77;
    const int status = WEXITSTATUS(pclose(pipe));
    if (status == no_h5py) {
        return std::nullopt;
    }
    EXPECT_EQ(status, 0);
    return json::parse(output);
}

void expect_attributes(const json& found, const std::string& format, int version, size_t count,
                       const NetFile& net) {
    EXPECT_EQ(found["attributes"]["format"], format);
    EXPECT_EQ(found["attributes"]["version"], version);
    EXPECT_EQ(found["attributes"]["prior"], "uniform:3mm");
    EXPECT_EQ(found["attributes"]["seed"], 7);
    EXPECT_EQ(found["attributes"]["net_fingerprint"], net.net.fingerprint());
    EXPECT_EQ(found["attributes"].size(), count);
    const std::string text = found["datasets"]["net"]["values"][0];
    EXPECT_EQ(parse_net(text, "net").net.fingerprint(), net.net.fingerprint());
    EXPECT_EQ(found["datasets"]["free_nodes"]["values"], net.net.free_nodes());
    EXPECT_EQ(found["datasets"]["interior_edges"]["values"], net.net.interior_edges());
}

/// @param columns of ours are the rows of the file
void expect_numbers(const json& found, const std::string& name, const Eigen::MatrixXd& expected,
                    const std::string& units) {
    SCOPED_TRACE(name);
    const json& dataset = found["datasets"][name];
    ASSERT_FALSE(dataset.is_null());
    EXPECT_EQ(dataset["type"], "float64");
    EXPECT_EQ(dataset["attributes"]["units"], units);
    size_t k = 0;
    for (Eigen::Index row = 0; row < expected.cols(); ++row) {
        for (Eigen::Index column = 0; column < expected.rows(); ++column) {
            ASSERT_EQ(dataset["values"][k++].get<double>(), expected(column, row));
        }
    }
    EXPECT_EQ(dataset["values"].size(), k);
}

TEST(H5py, FindsEveryNumberOfADataSet) {
    const test::ScratchDirectory scratch;
    const NetFile net = test::example_net();
    DataSet data = test::example_data(net.net);
    data.statuses[4] = EquilibriumStatus::iteration_limit;
    data.slack_counts[4] = 3;
    write_data_set(scratch / "data.h5", data, net);
    const auto found = read_with_h5py(scratch / "data.h5");
    if (!found) {
        GTEST_SKIP() << "python3-h5py is not installed";
    }
    expect_attributes(*found, "taut-data-set", 2, 6, net);
    expect_numbers(*found, "nominal_form", data.nominal_form, "m");
    expect_numbers(*found, "form_deviation", data.form_deviations, "m");
    expect_numbers(*found, "length_deviation", data.length_deviations, "m");
    const json& datasets = (*found)["datasets"];
    EXPECT_EQ(datasets["nominal_form"]["shape"], json({18}));
    EXPECT_EQ(datasets["form_deviation"]["shape"], json({30, 18}));
    EXPECT_EQ(datasets["length_deviation"]["shape"], json({30, 7}));
    EXPECT_EQ(datasets["net"]["shape"], json::array());
    EXPECT_EQ(datasets["status"]["type"], "uint8");
    EXPECT_EQ(datasets["status"]["values"][4], 2);
    EXPECT_EQ(datasets["status"]["values"][5], 0);
    EXPECT_EQ(datasets["status"]["attributes"]["meaning"],
              "0: converged, 1: slack mechanism, 2: iteration limit, 3: unstable");
    EXPECT_EQ(datasets["slack_edges"]["type"], "int32");
    EXPECT_EQ(datasets["slack_edges"]["values"], data.slack_counts);
    EXPECT_EQ(datasets.size(), 8U);
}

TEST(H5py, FindsEveryNumberOfAModel) {
    const test::ScratchDirectory scratch;
    const NetFile net = test::example_net();
    const LengthModel model =
        test::example_model(net.net, test::example_data(net.net), {.mean = MeanFunction::zero});
    write_model(scratch / "model.h5", model, net);
    const auto found = read_with_h5py(scratch / "model.h5");
    if (!found) {
        GTEST_SKIP() << "python3-h5py is not installed";
    }
    expect_attributes(*found, "taut-model", 4, 9, net);
    EXPECT_EQ((*found)["attributes"]["mean_function"], "zero");
    EXPECT_EQ((*found)["attributes"]["kernel_metric"], "isotropic");
    expect_numbers(*found, "input_scales", model.input_scales, "1");
    expect_numbers(*found, "training_outputs", model.length_deviations, "m");
    expect_numbers(*found, "nominal_form", model.nominal_form, "m");
    expect_numbers(*found, "training_inputs", model.processes.inputs, "m");
    expect_numbers(*found, "weights", model.processes.weights, "m");
    const auto column = [&](const std::string& name, const std::string& units, auto of) {
        Eigen::VectorXd values(std::ssize(model.processes.processes));
        std::ranges::transform(model.processes.processes, values.begin(), of);
        expect_numbers(*found, name, values, units);
    };
    using gp::Process;
    column("inverse_length_scale", "1/m",
           [](const Process& p) { return p.hyperparameters.inverse_length_scale; });
    column("signal_std", "m", [](const Process& p) { return p.hyperparameters.signal_std; });
    column("noise_std", "m", [](const Process& p) { return p.hyperparameters.noise_std; });
    column("negative_log_likelihood", "1", &Process::negative_log_likelihood);
    column("leave_one_out_rmse", "m", &Process::leave_one_out_rmse);
    column("approximation_error", "m", &Process::approximation_error);
    expect_numbers(*found, "form_prior/mean", model.form_prior.mean, "m");
    expect_numbers(*found, "form_prior/variances", model.form_prior.variances, "m2");
    expect_numbers(*found, "form_prior/directions", model.form_prior.directions.transpose(), "1");
    for (size_t k = 0; k < model.processes.spectra.size(); ++k) {
        const std::string group = fmt::format("spectra/{}", k);
        const gp::KernelSpectrum& spectrum = model.processes.spectra[k];
        const auto number = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
        expect_numbers(*found, group + "/inverse_length_scale",
                       number(spectrum.inverse_length_scale), "1/m");
        expect_numbers(*found, group + "/eigenvalues", spectrum.eigenvalues, "1");
        expect_numbers(*found, group + "/eigenvectors", spectrum.eigenvectors, "1");
        expect_numbers(*found, group + "/tail_mean", number(spectrum.tail_mean), "1");
        expect_numbers(*found, group + "/tail_largest", number(spectrum.tail_largest), "1");
    }
    const json& datasets = (*found)["datasets"];
    EXPECT_EQ(datasets["training_inputs"]["shape"], json({30, 18}));
    EXPECT_EQ(datasets["weights"]["shape"], json({7, 30}));
    EXPECT_EQ(datasets["spectra/0/inverse_length_scale"]["shape"], json::array());
    EXPECT_EQ(datasets["fit_status"]["attributes"]["meaning"],
              "0: fitted, 1: constant output, 2: non-finite output");
    EXPECT_EQ(datasets["spectrum"]["values"][6], model.processes.processes[6].spectrum);
    EXPECT_EQ(datasets.size(), 19U + 5U * model.processes.spectra.size());
}

}  // namespace
}  // namespace taut
