// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/draws_h5.hpp"

#include <fmt/core.h>

#include <array>
#include <stdexcept>

#include "files/hdf5_reader.hpp"
#include "files/hdf5_writer.hpp"
#include "files/message.hpp"

namespace taut {
namespace {

struct PerturbationField {
    const char* attribute;  ///< of the file, "uncertain" where it holds the matrix
    const char* data_set;
    Eigen::MatrixXd ModelPerturbations::* matrix;
    const char* unit;
    double largest;  ///< larger values are errors of the file
};

constexpr std::array perturbation_fields{
    PerturbationField{"stiffness", "stiffness_perturbation", &ModelPerturbations::stiffness, "1",
                      3.0},
    PerturbationField{"thermal", "thermal_perturbation", &ModelPerturbations::thermal, "1", 0.5},
    PerturbationField{"supports", "support_perturbation", &ModelPerturbations::supports, "m", 1e3},
    PerturbationField{"loads", "load_perturbation", &ModelPerturbations::loads, "N", 1e9}};

Eigen::Index rows_of(const CableNet& net, const PerturbationField& field) {
    if (field.matrix == &ModelPerturbations::supports) {
        return std::ssize(net.supports()) * 3;
    }
    return field.matrix == &ModelPerturbations::loads ? Eigen::Index{3} * net.free_node_count()
                                                      : net.edge_count();
}

}  // namespace

bool keeps_draws() {
    return true;
}

std::string draws_bytes(const CableNet& net, const Identification& identification) {
    if (!identification.draws) {
        throw std::invalid_argument(
            "the identification has no posterior samples, expected at least one");
    }
    const PosteriorDraws& draws = *identification.draws;
    hdf5::Writer writer;
    writer.attribute("format", "taut-draws");
    writer.attribute("version", 2);
    writer.attribute("net_fingerprint", net.fingerprint());
    writer.attribute("prior", to_string(identification.length_prior));
    writer.attribute("seed", draws.seed);
    writer.attribute("how", draws.method);
    writer.attribute("reason", draws.reason);
    writer.integers("edge", net.interior_edges());
    writer.integers("node", net.free_nodes());
    writer.matrix("length_deviation", draws.length_deviations, "m");
    if (draws.adjustable_deviations.cols() > 0) {
        writer.attribute("adjustable", "uncertain");
        writer.integers("adjustable_edge", net.adjustable_edges());
        writer.matrix("adjustable_deviation", draws.adjustable_deviations, "m");
    }
    for (const PerturbationField& field : perturbation_fields) {
        if (const Eigen::MatrixXd& matrix = draws.perturbations.*field.matrix; matrix.size() > 0) {
            writer.attribute(field.attribute, "uncertain");
            writer.matrix(field.data_set, matrix, field.unit);
        }
    }
    writer.matrix("form", draws.forms, "m");
    writer.matrix("tension", draws.tensions, "N");
    return std::string(writer.finish().view());
}

PosteriorDraws read_draws(const CableNet& net, const std::filesystem::path& path) {
    const hdf5::Reader reader(path, "taut-draws");
    if (reader.text_attribute("format") != "taut-draws") {
        reader.fail("format", "is not taut-draws");
    }
    const std::uint64_t version = reader.number_attribute("version");
    if (version != 1 && version != 2) {
        reader.fail("version",
                    fmt::format("is {}, expected 1 or 2, which this taut knows", version));
    }
    if (const std::string found = reader.text_attribute("net_fingerprint");
        found != net.fingerprint()) {
        reader.fail("net_fingerprint", fmt::format("is {}, expected {}: samples of another net",
                                                   quote(found), net.fingerprint()));
    }
    PosteriorDraws draws;
    const Eigen::Index edges = net.interior_edge_count();
    const Eigen::Index count = reader.row_count("length_deviation", edges);
    draws.length_deviations = reader.matrix("length_deviation", edges, count);
    const Eigen::VectorXd nominal = net.unstressed_lengths()(net.interior_edges());
    if (count > 0 && !((draws.length_deviations.colwise() + nominal).minCoeff() > 0.0)) {
        reader.fail("length_deviation", "makes the length of an edge negative or 0");
    }
    if (reader.has_attribute("adjustable")) {
        draws.adjustable_deviations =
            reader.matrix("adjustable_deviation",
                          static_cast<Eigen::Index>(net.adjustable_edges().size()), count);
    }
    for (const PerturbationField& field : perturbation_fields) {
        if (reader.has_attribute(field.attribute)) {
            Eigen::MatrixXd& matrix = draws.perturbations.*field.matrix;
            matrix = reader.matrix(field.data_set, rows_of(net, field), count);
            if (!(matrix.cwiseAbs().maxCoeff() <= field.largest)) {
                reader.fail(field.data_set, fmt::format("holds a value above {:g} {}, which is no "
                                                        "uncertainty of a net",
                                                        field.largest, field.unit));
            }
        }
    }
    draws.forms = reader.matrix("form", Eigen::Index{3} * net.free_node_count(), count);
    draws.tensions = reader.matrix("tension", net.edge_count(), count);
    draws.seed = reader.number_attribute("seed");
    draws.method = reader.text_attribute("how");
    draws.reason = reader.text_attribute(version == 1 ? "doubt" : "reason");
    return draws;
}

}  // namespace taut
