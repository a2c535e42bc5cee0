// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// One surveyed point: a name and a place in the frame of the net.
struct SurveyPoint {
    std::string id;            ///< a node's name or index
    Eigen::Vector3d position;  ///< [m]
    int line = 0;              ///< of the file it came from, for messages; 0 if none
};

/// A survey brought to the nodes of a net.
struct Survey {
    Points form;                ///< 3 x n: surveyed where it was, nominal elsewhere [m]
    std::vector<int> surveyed;  ///< free nodes that were measured, ascending
    std::vector<int> missing;   ///< free nodes that were not, ascending
};

/// A rule of a survey that is broken, at a point of it.
class SurveyError : public std::invalid_argument {
public:
    SurveyError(int line, const std::string& what) : std::invalid_argument(what), m_line(line) {}
    /// Line of the file, or 0 where it is the survey as a whole.
    [[nodiscard]] int line() const { return m_line; }

private:
    int m_line;
};

/// Matches surveyed points to the nodes of a net by their names (CableNet::node_id). Points on
/// supports are compared with the rigid frame, whose place is known.
/// @throws SurveyError for a name that is not a node's or comes twice, a position that is not
/// finite,
///   and where the survey is not of this net, in its frame and in metres: a free node further from
///   its nominal place than the net's mean edge length, or a support further than a tenth of that.
[[nodiscard]] Survey match_by_name(const CableNet& net, const std::vector<SurveyPoint>& points);

}  // namespace taut
