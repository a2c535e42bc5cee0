// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

/// The common case in one header: read a net and a survey, identify, plan, write. All of it is in
/// taut::taut; each header by itself needs less.
#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/plan_turns.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/identify.hpp"
#include "taut/io/net_json.hpp"
#include "taut/io/read_survey.hpp"
#include "taut/results/plan_files.hpp"
#include "taut/results/results_json.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"
