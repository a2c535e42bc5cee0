// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "files/hdf5_reader.hpp"
#include "files/hdf5_writer.hpp"
#include "taut/io/net_json.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

/// What data sets and models have in common: both belong to one net, one prior and one seed.
namespace taut {

/// The head of a data set or model.
struct H5Head {
    std::string format;  ///< "taut-model"
    std::uint64_t version = 1;
    std::string net_fingerprint;
    LengthPrior prior;
    std::uint64_t seed = 1;
    std::vector<UncertainParameter> uncertain;  ///< an attribute, JSON text, where there are any
    Eigen::VectorXd nominal_form;               ///< 3 n_I [m]
};

/// @throws std::invalid_argument where the head does not fit the net
void write_head(hdf5::Writer& writer, const H5Head& head, const NetFile& file);

/// Versions of a format that can be read.
struct VersionRange {
    std::uint64_t oldest;
    std::uint64_t newest;
    std::uint64_t renamed;  ///< the first with the attributes "prior" and "uncertain"
};

/// The net inside, checked against the fingerprint and the lists of nodes and edges beside it.
/// @param format that the file should have
/// @throws InputError
[[nodiscard]] std::pair<H5Head, NetFile> read_head(const hdf5::Reader& reader,
                                                   const std::string& format,
                                                   const VersionRange& known);

/// "0: converged, 1: slack mechanism": the meaning of the codes of an enumeration.
template <typename Status, size_t N>
std::string meaning_of_codes(const std::array<Status, N>& all) {
    std::string meaning;
    for (const Status status : all) {
        meaning += (meaning.empty() ? "" : ", ") + std::to_string(static_cast<int>(status)) + ": " +
                   std::string(to_string(status));
    }
    return meaning;
}

/// Refuses to write what could not be read again.
/// @throws std::invalid_argument where the matrix is not rows x cols, or not finite
void require_matrix(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                    Eigen::Index rows, Eigen::Index cols);

}  // namespace taut
