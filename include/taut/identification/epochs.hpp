// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/identification/identify.hpp"
#include "taut/survey/turned_net.hpp"

namespace taut {

/// One survey of several of the same net.
struct Epoch {
    Survey survey;                   ///< not an exact one; of the net as it stood then
    std::vector<EdgeTurned> turned;  ///< since the survey before; of the first: none
    /// Known loads that hung on the net at this survey alone, besides its own (3 x n); 3 x 0: none.
    /// How far the form gives way shows the stiffness [N].
    Points loads = Points(3, 0);

    /// Whether known loads hung on the net.
    [[nodiscard]] bool is_loaded() const { return !loads.isZero(0.0); }
};

/// Of which survey the result is: the last without loads of its own.
/// @throws std::invalid_argument where there is none, and where anything was turned after it
[[nodiscard]] TAUT_CORE_EXPORT int reported_epoch(std::span<const Epoch> epochs);

/// An error of one survey of several.
class TAUT_CORE_EXPORT EpochError : public SurveyError {
public:
    /// @param epoch the survey, from 0
    EpochError(int epoch, const std::string& what) : SurveyError(0, what), m_epoch(epoch) {}
    [[nodiscard]] int epoch() const { return m_epoch; }  ///< from 0

private:
    int m_epoch;
};

/// More interior edges are refused: the common evidence is a full matrix of all lengths.
inline constexpr int most_edges_of_epochs = 3000;

/// Identifies lengths from all surveys at once, by maximum a posteriori. Lengths of interior edges
/// are the same in all surveys. Those of adjustable edges were changed by what was turned, with its
/// standard deviation. Frame, noise and temperature are each survey's own; a creep is a walk from
/// zero at the first. Each survey is fitted with the evidence of the others until they agree.
/// Lengths that changed in between are detected and set free, and so are adjustable ones that
/// differ from the design at the beginning. docs/theory.md, "Epochs".
///
/// @param net as designed, before anything was turned
/// @param epochs at least two, in the order of the surveys, with their noise
/// @param options forces and draws are of the survey reported; no model
/// @param progress gets the stages "comparing surveys" and "identification"
/// @return result for the net at reported_epoch(), turned_net(net, result.turned); `epochs` has
///   each survey
/// @throws std::invalid_argument as identify(), check_turned(), for fewer than two epochs, more
///   interior edges than most_edges_of_epochs, a method that is not map, covariance_of, loads of
///   the first survey or that are not finite, and as reported_epoch()
/// @throws std::runtime_error where the net as turned and loaded finds no equilibrium
/// @throws EpochError where identify() throws SurveyError; for an exact survey, and one given
///   twice
/// @throws Interrupted where a stop was requested
[[nodiscard]] TAUT_CORE_EXPORT Identification identify_epochs(const CableNet& net,
                                                              std::span<const Epoch> epochs,
                                                              const IdentifyOptions& options = {},
                                                              const Progress& progress = {});

}  // namespace taut
