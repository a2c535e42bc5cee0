// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut::python {

/// What an identification found, with its net and survey.
struct Identified {
    CableNet net;
    Survey survey;
    Identification found;
};

}  // namespace taut::python
