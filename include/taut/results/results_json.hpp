// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/export/io.hpp"
#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/study/study.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Date and command of a result; an empty field is left out of the file.
struct RunRecord {
    std::string date;     ///< "2026-11-21 06:30 UTC"
    std::string command;  ///< the command line
};

/// results.json of a study: format "taut-study", version 2; all numbers in SI units.
[[nodiscard]] TAUT_IO_EXPORT std::string study_to_json(const Study& study,
                                                       const RunRecord& run = {});

/// result.json of an identification: format "taut-identification", version 2; all numbers in SI
/// units.
/// @param net, survey of the identification, not checked
[[nodiscard]] TAUT_IO_EXPORT std::string identification_to_json(
    const CableNet& net, const Survey& survey, const Identification& identification,
    const RunRecord& run = {});

}  // namespace taut
