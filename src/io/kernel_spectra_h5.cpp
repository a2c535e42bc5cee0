// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "io/kernel_spectra_h5.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/h5_head.hpp"

namespace taut {
namespace {

using gp::KernelSpectrum;

std::string name_of(size_t index) {
    return fmt::format("spectra/{}", index);
}

/// A number that contradicts the others: its name and what is wrong.
struct Contradiction {
    std::string name;
    std::string text;
};

/// What a spectrum leaves out of n directions bounds what prediction takes for certain.
std::optional<Contradiction> contradiction_of(const KernelSpectrum& spectrum) {
    if (spectrum.is_whole()) {
        for (const auto& [name, value] : {std::pair{"tail_mean", spectrum.tail_mean},
                                          std::pair{"tail_largest", spectrum.tail_largest}}) {
            if (value != 0.0) {
                return Contradiction{
                    name, fmt::format("is {}, expected 0: no direction is left out", value)};
            }
        }
        return std::nullopt;
    }
    if (spectrum.tail_mean < 0.0) {
        return Contradiction{"tail_mean", "is negative"};
    }
    if (!(spectrum.tail_largest > 0.0) || spectrum.tail_largest < spectrum.tail_mean) {
        return Contradiction{
            "tail_largest", fmt::format("is {}, expected a positive number, not below tail_mean {}",
                                        spectrum.tail_largest, spectrum.tail_mean)};
    }
    return std::nullopt;
}

/// How many directions a spectrum has.
Eigen::Index read_rank(const hdf5::Reader& reader, const std::string& eigenvectors, Eigen::Index n,
                       bool is_whole) {
    const Eigen::Index rank = reader.row_count(eigenvectors, n);
    if (rank < (is_whole ? n : 1) || rank > n) {
        reader.fail(eigenvectors,
                    fmt::format("has {} rows, expected {}{}", rank, is_whole ? "" : "1 to ", n));
    }
    return rank;
}

KernelSpectrum read_spectrum(const hdf5::Reader& reader, const std::string& name, Eigen::Index n,
                             bool is_whole) {
    const Eigen::Index r = read_rank(reader, name + "/eigenvectors", n, is_whole);
    KernelSpectrum spectrum{.inverse_length_scale = reader.number(name + "/inverse_length_scale"),
                            .eigenvalues = reader.vector(name + "/eigenvalues", r),
                            .eigenvectors = reader.matrix(name + "/eigenvectors", n, r)};
    if (!is_whole) {
        spectrum.tail_mean = reader.number(name + "/tail_mean");
        spectrum.tail_largest = reader.number(name + "/tail_largest");
    }
    if (!(spectrum.inverse_length_scale > 0.0)) {
        reader.fail(name + "/inverse_length_scale", fmt::format("is {}, expected a positive number",
                                                                spectrum.inverse_length_scale));
    }
    if (spectrum.eigenvalues.size() > 0 && spectrum.eigenvalues.minCoeff() < 0.0) {
        reader.fail(name + "/eigenvalues", "holds a negative number");
    }
    if (const auto found = contradiction_of(spectrum)) {
        reader.fail(fmt::format("{}/{}", name, found->name), found->text);
    }
    return spectrum;
}

}  // namespace

void check_spectrum(const KernelSpectrum& spectrum, Eigen::Index n) {
    const Eigen::Index r = std::max<Eigen::Index>(1, std::min(n, spectrum.eigenvectors.cols()));
    require_matrix("eigenvectors", spectrum.eigenvectors, n, r);
    require_matrix("eigenvalues", spectrum.eigenvalues, r, 1);
    require_matrix("tail_mean", Eigen::MatrixXd::Constant(1, 1, spectrum.tail_mean), 1, 1);
    require_matrix("tail_largest", Eigen::MatrixXd::Constant(1, 1, spectrum.tail_largest), 1, 1);
    if (const auto found = contradiction_of(spectrum)) {
        throw std::invalid_argument(fmt::format("{} {}", found->name, found->text));
    }
}

void write_spectra(hdf5::Writer& writer, const std::vector<KernelSpectrum>& spectra) {
    writer.group("spectra");
    for (size_t k = 0; k < spectra.size(); ++k) {
        const std::string name = name_of(k);
        const KernelSpectrum& spectrum = spectra[k];
        writer.group(name);
        writer.number(name + "/inverse_length_scale", spectrum.inverse_length_scale, "1/m");
        writer.vector(name + "/eigenvalues", spectrum.eigenvalues, "1");
        writer.matrix(name + "/eigenvectors", spectrum.eigenvectors, "1");
        writer.number(name + "/tail_mean", spectrum.tail_mean, "1");
        writer.number(name + "/tail_largest", spectrum.tail_largest, "1");
    }
}

std::vector<KernelSpectrum> read_spectra(const hdf5::Reader& reader, Eigen::Index n,
                                         bool are_whole) {
    std::vector<KernelSpectrum> spectra;
    const auto count = static_cast<size_t>(reader.group_size("spectra"));
    spectra.reserve(std::min<size_t>(count, 64));  // what a file claims may be more than it holds
    for (size_t k = 0; k < count; ++k) {
        spectra.push_back(read_spectrum(reader, name_of(k), n, are_whole));
    }
    return spectra;
}

}  // namespace taut
