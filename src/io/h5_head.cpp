// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "io/h5_head.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "files/message.hpp"

namespace taut {
namespace {

/// @return the version
std::uint64_t check_format(const hdf5::Reader& reader, const std::string& format,
                           const VersionRange& known) {
    const std::string found = reader.text_attribute("format");
    if (found != format) {
        reader.fail("format", fmt::format("is {}, expected '{}'", quote(found), format));
    }
    const std::uint64_t version = reader.number_attribute("version");
    if (version < known.oldest || version > known.newest) {
        reader.fail("version",
                    known.oldest == known.newest
                        ? fmt::format("is {}, expected {}, the only one that this taut knows",
                                      version, known.newest)
                        : fmt::format("is {}, expected {} to {}, which this taut knows", version,
                                      known.oldest, known.newest));
    }
    return version;
}

LengthPrior read_prior(const hdf5::Reader& reader, const std::string& name) {
    try {
        return parse_length_prior(reader.text_attribute(name));
    } catch (const std::invalid_argument& error) {
        reader.fail(name, error.what());
    }
}

std::string uncertain_text(const std::vector<UncertainParameter>& uncertain) {
    nlohmann::json list = nlohmann::json::array();
    for (const UncertainParameter& parameter : uncertain) {
        list.push_back(to_string(parameter));
    }
    return list.dump();
}

std::vector<UncertainParameter> read_uncertain(const hdf5::Reader& reader, const CableNet& net,
                                               const std::string& name) {
    std::vector<UncertainParameter> uncertain;
    if (!reader.has_attribute(name)) {
        return uncertain;
    }
    const auto list = nlohmann::json::parse(reader.text_attribute(name), nullptr, false);
    const auto is_text = [](const nlohmann::json& entry) { return entry.is_string(); };
    if (!list.is_array() || !std::ranges::all_of(list, is_text)) {
        reader.fail(name, R"(is no list of texts, as in ["stiffness:5%"])");
    }
    try {
        for (const auto& entry : list) {
            uncertain.push_back(parse_uncertain_parameter(entry.get_ref<const std::string&>()));
        }
        check_uncertain_parameters(net, uncertain);
    } catch (const std::invalid_argument& error) {
        reader.fail(name, error.what());
    }
    return uncertain;
}

void require_list(const hdf5::Reader& reader, const std::string& name,
                  const std::vector<int>& expected, int count) {
    if (reader.integers(name, static_cast<Eigen::Index>(expected.size()), 0, count - 1) !=
        expected) {
        reader.fail(name, "is not the list that follows from the net in the file");
    }
}

}  // namespace

void require_matrix(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                    Eigen::Index rows, Eigen::Index cols) {
    if (matrix.rows() != rows || matrix.cols() != cols) {
        throw std::invalid_argument(fmt::format("{} has {} x {} entries, expected {} x {}", name,
                                                matrix.rows(), matrix.cols(), rows, cols));
    }
    if (!matrix.allFinite()) {
        throw std::invalid_argument(name + " holds a number that is not finite");
    }
}

void write_head(hdf5::Writer& writer, const H5Head& head, const NetFile& file) {
    const CableNet& net = file.net;
    if (head.net_fingerprint != net.fingerprint()) {
        throw std::invalid_argument(fmt::format("a {} of the net {}, expected the net given, {}",
                                                head.format, head.net_fingerprint,
                                                net.fingerprint()));
    }
    require_matrix("nominal_form", head.nominal_form, 3 * net.free_node_count(), 1);
    writer.attribute("format", head.format);
    writer.attribute("version", head.version);
    writer.attribute("prior", to_string(head.prior));
    writer.attribute("seed", head.seed);
    if (!head.uncertain.empty()) {
        writer.attribute("uncertain", uncertain_text(head.uncertain));
    }
    writer.attribute("net_fingerprint", head.net_fingerprint);
    writer.text("net", net_to_json(net, file.unknown_keys));
    writer.integers("free_nodes", net.free_nodes());
    writer.integers("interior_edges", net.interior_edges());
    writer.vector("nominal_form", head.nominal_form, "m");
}

std::pair<H5Head, NetFile> read_head(const hdf5::Reader& reader, const std::string& format,
                                     const VersionRange& known) {
    const std::uint64_t version = check_format(reader, format, known);
    NetFile file = parse_net(reader.text("net"), reader.file_name() + ":net");
    const CableNet& net = file.net;
    const std::string fingerprint = reader.text_attribute("net_fingerprint");
    if (fingerprint != net.fingerprint()) {
        reader.fail("net_fingerprint",
                    fmt::format("is {}, expected {}, that of the net in the file",
                                quote(fingerprint), quote(net.fingerprint())));
    }
    require_list(reader, "free_nodes", net.free_nodes(), net.node_count());
    require_list(reader, "interior_edges", net.interior_edges(), net.edge_count());
    const bool is_older = version < known.renamed;
    H5Head head{.format = format,
                .version = version,
                .net_fingerprint = fingerprint,
                .prior = read_prior(reader, is_older ? "law" : "prior"),
                .seed = reader.number_attribute("seed"),
                .uncertain = read_uncertain(reader, net, is_older ? "unknowns" : "uncertain"),
                .nominal_form = reader.vector("nominal_form", 3 * net.free_node_count())};
    return {std::move(head), std::move(file)};
}

}  // namespace taut
