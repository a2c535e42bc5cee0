// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "files/hdf5_reader.hpp"
#include "files/hdf5_writer.hpp"
#include "taut/gp/spectrum.hpp"

namespace taut {

/// That sizes agree with n training inputs, every number is finite, and the tail does not
/// contradict the rest.
/// @throws std::invalid_argument
void check_spectrum(const gp::KernelSpectrum& spectrum, Eigen::Index n);

/// The group "spectra" of a model's file: write_model().
void write_spectra(hdf5::Writer& writer, const std::vector<gp::KernelSpectrum>& spectra);

/// The same, read.
/// @param n training inputs
/// @param are_whole as in files that hold no tails
/// @throws InputError
[[nodiscard]] std::vector<gp::KernelSpectrum> read_spectra(const hdf5::Reader& reader,
                                                           Eigen::Index n, bool are_whole);

}  // namespace taut
