// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/data_set_h5.hpp"

#include <fmt/core.h>

#include <array>
#include <stdexcept>

#include "io/h5_head.hpp"
#include "taut/files/file.hpp"

namespace taut {
namespace {

const std::string data_set_format = "taut-data-set";
constexpr std::uint64_t data_set_version = 2;

/// The code of each in a file is its place in the enumeration, which is therefore fixed.
constexpr std::array equilibrium_statuses{
    EquilibriumStatus::converged, EquilibriumStatus::slack_mechanism,
    EquilibriumStatus::iteration_limit, EquilibriumStatus::unstable};

void check(const DataSet& data, const CableNet& net) {
    const Eigen::Index n = data.form_deviations.cols();
    require_matrix("form_deviations", data.form_deviations, 3 * net.free_node_count(), n);
    require_matrix("length_deviations", data.length_deviations, net.interior_edge_count(), n);
    const auto count = static_cast<size_t>(n);
    if (data.statuses.size() != count || data.slack_counts.size() != count) {
        throw std::invalid_argument(
            fmt::format("{} statuses and {} slack_counts, expected {} of each, one a sample",
                        data.statuses.size(), data.slack_counts.size(), n));
    }
}

hdf5::Image data_set_image(const DataSet& data, const NetFile& net) {
    check(data, net.net);
    hdf5::Writer writer;
    write_head(writer,
               {.format = data_set_format,
                .version = data_set_version,
                .net_fingerprint = data.net_fingerprint,
                .prior = data.prior,
                .seed = data.seed,
                .uncertain = data.uncertain,
                .nominal_form = data.nominal_form},
               net);
    writer.matrix("form_deviation", data.form_deviations, "m");
    writer.matrix("length_deviation", data.length_deviations, "m");
    std::vector<std::uint8_t> codes;
    codes.reserve(data.statuses.size());
    for (const EquilibriumStatus status : data.statuses) {
        codes.push_back(static_cast<std::uint8_t>(status));
    }
    writer.codes("status", codes, meaning_of_codes(equilibrium_statuses));
    writer.integers("slack_edges", data.slack_counts);
    return writer.finish();
}

}  // namespace

std::string data_set_bytes(const DataSet& data, const NetFile& net) {
    return std::string(data_set_image(data, net).view());
}

void write_data_set(const std::filesystem::path& path, const DataSet& data, const NetFile& net) {
    write_file(path, data_set_image(data, net).view());
}

StoredDataSet read_data_set(const std::filesystem::path& path) {
    const hdf5::Reader reader(path, data_set_format);
    auto [head, file] = read_head(reader, data_set_format, {1, data_set_version, 2});
    const CableNet& net = file.net;
    const Eigen::Index coordinates = 3 * net.free_node_count();
    const Eigen::Index n = reader.row_count("form_deviation", coordinates);
    DataSet data{
        .net_fingerprint = head.net_fingerprint,
        .prior = head.prior,
        .seed = head.seed,
        .uncertain = std::move(head.uncertain),
        .nominal_form = std::move(head.nominal_form),
        .form_deviations = reader.matrix("form_deviation", coordinates, n),
        .length_deviations = reader.matrix("length_deviation", net.interior_edge_count(), n),
        .statuses = {},
        .slack_counts = reader.integers("slack_edges", n, 0, net.edge_count())};
    constexpr double largest = 1e15;  // as of a net's coordinates [m]
    for (const auto& [name, values] : {std::pair("form_deviation", &data.form_deviations),
                                       std::pair("length_deviation", &data.length_deviations)}) {
        if (values->size() > 0 && values->cwiseAbs().maxCoeff() > largest) {
            reader.fail(name, fmt::format("holds {:g} m, expected no more than {:g} m",
                                          values->cwiseAbs().maxCoeff(), largest));
        }
    }
    const int highest = static_cast<int>(equilibrium_statuses.size()) - 1;
    const std::vector<int> codes = reader.integers("status", n, 0, highest);
    data.statuses.reserve(codes.size());
    for (const int code : codes) {
        data.statuses.push_back(static_cast<EquilibriumStatus>(code));
    }
    return {.data = std::move(data), .net = std::move(file), .has_digest = reader.has_digest()};
}

}  // namespace taut
