// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "taut/error.hpp"
#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/frame.hpp"

namespace taut {

/// One surveyed point: a name and a place.
struct SurveyPoint {
    std::string id;            ///< a node's name or index; empty for a target without a name
    Eigen::Vector3d position;  ///< [m]
    int line = 0;              ///< of the file it came from, for messages; 0 if none
    std::optional<Eigen::Vector3d> noise_std;  ///< of each coordinate, if given [m]
    /// Of that noise, between x and y, x and z, y and z.
    Eigen::Vector3d noise_correlations = Eigen::Vector3d::Zero();
    /// Its name in the file where that is no node's: it is a target without a name, and this is for
    /// messages.
    std::string label;
    std::string code;  ///< what the file calls this kind of point; empty: nothing
};

/// Why a surveyed point was put on no node.
enum class UnmatchedReason {
    far_from_its_node,    ///< named, but further away than the net's mean edge length
    far_from_every_node,  ///< further than half the mean edge length from the nearest node
    between_nodes,        ///< not twice as near to the nearest node as to the next
    node_taken,           ///< its node is another point's, too
};

/// "far from its node", "far from every node", "between nodes", "node taken".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(UnmatchedReason reason);

/// A surveyed point that was put on no node.
struct UnmatchedPoint {
    SurveyPoint point;      ///< in the net's frame
    int nearest = 0;        ///< node: its own if it is named, else the nearest
    double distance = 0.0;  ///< to the nominal place of that node [m]
    UnmatchedReason reason = UnmatchedReason::far_from_every_node;  ///< why it is on none
    /// Node of another such point, where each of both is at the node of the other's name: their
    /// names are swapped; else -1.
    int swapped_with = -1;
};

/// A measured support, whose place is known without, too.
struct SurveyedSupport {
    int node = 0;               ///< index of a support
    Eigen::Vector3d position;   ///< [m]
    Eigen::Vector3d noise_std;  ///< of each coordinate [m]
    /// Of that noise, between x and y, x and z, y and z.
    Eigen::Vector3d noise_correlations = Eigen::Vector3d::Zero();
};

/// A surveyed point that was put on a node.
struct PlacedPoint {
    std::string name;       ///< in the file; empty for a target without a name
    int line = 0;           ///< of the file, for messages; 0 if none
    int node = 0;           ///< free, or a support
    double distance = 0.0;  ///< to the nominal place of the node [m]
    std::string code;       ///< of the point in the file
};

/// A survey brought to the nodes of a net: by match_to_nodes(), read_survey(), or by hand.
/// identify(), identify_epochs() and predicted_precision() refuse what check_survey() refuses; its
/// own functions do not check, and ask for a `surveyed` that names columns of `noise_std`.
struct TAUT_CORE_EXPORT Survey {
    Points form;  ///< 3 x n: surveyed where it was, nominal elsewhere [m]
    /// 3 x n, standard deviation of each coordinate, 0 for an exact one; ignored where no free node
    /// was surveyed. 3 x 0: all exact [m].
    Points noise_std;
    /// 3 x n, correlations of that noise at a node, between x and y, x and z, y and z; those of
    /// different nodes are independent. 3 x 0: none.
    Points noise_correlations;
    std::vector<int> surveyed;              ///< free nodes that were measured, ascending
    std::vector<int> missing;               ///< free nodes that were not, ascending
    std::vector<SurveyedSupport> supports;  ///< in ascending order; not in `form`
    /// Whether the frame of the coordinates is known by them alone: it is the net's but for a small
    /// motion.
    bool frame_is_unknown = false;
    std::vector<UnmatchedPoint> unmatched;  ///< in the order of the points
    std::optional<Registration> frame;      ///< empty where it was given in the net's
    std::vector<std::string> warnings;  ///< what is most likely given in another unit, a line each
    std::vector<PlacedPoint> placed;    ///< on which node each point is, supports included
    /// How many points lie clearly on other nodes than those that they name and were put there: all
    /// names are then ignored. 0: the names hold, or were not to be used.
    int contradicted_names = 0;
    std::vector<std::string> notes;  ///< how its file was understood, a line each
    bool has_own_noise = false;      ///< whether a point brought a noise of its own
    /// Standard deviation of the scale that all targets have in common, which is not in `noise_std`
    /// [-].
    double scale_std = 0.0;
    double rounding_std = 0.0;  ///< of its file's last digit, where `noise_std` holds it [m]

    /// Correlations of the noise at a node, 0 where there are none.
    /// @throws std::out_of_range for a node that `noise_correlations` does not have
    [[nodiscard]] Eigen::Vector3d correlations_of(int node) const;
    /// Makes these the correlations of the noise at a node; `form` must have its size by then.
    /// @throws std::out_of_range for another node
    void set_correlations(int node, const Eigen::Vector3d& correlations);
    /// Whether some surveyed coordinate has noise.
    [[nodiscard]] bool is_noisy() const { return largest_noise_std() > 0.0; }
    /// Whether no surveyed coordinate has noise.
    [[nodiscard]] bool is_exact() const { return !is_noisy(); }
    /// Whether every free node was surveyed.
    [[nodiscard]] bool is_whole() const { return missing.empty(); }
    /// Of the surveyed coordinates; 0 where none was surveyed [m].
    [[nodiscard]] double largest_noise_std() const;
    /// Root mean square over the surveyed coordinates; 0 where none was surveyed [m].
    [[nodiscard]] double rms_noise_std() const;
};

/// Whether a survey can be one of a net.
/// @throws SurveyError for a survey of another size than the net, a node that is not free, out of
///   order, comes twice or is neither surveyed nor missing, a support that is none, out of order or
///   comes twice, noise that is negative or not finite, correlations that no noise can have, a
///   position that is not finite or above 1e9 m, and where no node was surveyed
TAUT_CORE_EXPORT void check_survey(const CableNet& net, const Survey& survey);

/// With the standard deviations of all that was surveyed times a factor.
/// @throws std::invalid_argument for a factor that is not positive and finite
[[nodiscard]] TAUT_CORE_EXPORT Survey with_noise_times(Survey survey, double factor);

/// Refuses a survey that misses nodes.
/// @param expected what the survey should hold, for the message: "all for ..."
/// @throws SurveyError where a free node was not surveyed; names the first
TAUT_CORE_EXPORT void require_whole(const CableNet& net, const Survey& survey,
                                    std::string_view expected);

/// A rule of a survey that is broken, at a point of it.
class TAUT_CORE_EXPORT SurveyError : public std::invalid_argument, public Error {
public:
    [[nodiscard]] ErrorCode code() const noexcept override { return ErrorCode::survey; }  ///< Error
    /// @param line of the file, or 0
    SurveyError(int line, const std::string& what) : std::invalid_argument(what), m_line(line) {}
    /// Line of the file, or 0 where it is the survey as a whole.
    [[nodiscard]] int line() const { return m_line; }

private:
    int m_line;
};

/// Puts surveyed points, in the net's frame, on its nodes. Named ones by their names
/// (CableNet::node_id). Targets without a name by their place: on the nearest node, where that is
/// clear (see UnmatchedReason), one to one. Points on supports are compared with their known
/// places, and do not enter `form`.
/// @param noise_std of the coordinates of points without their own [m]
/// @throws SurveyError for a name that is not a node's or comes twice, a position that is not
///   finite or above 1e9 m, and where the survey is not of this net, in its frame and in metres:
///   more than 5 % of the named free nodes further from their nominal place than the net's mean
///   edge length, a named support further than a tenth of that, less than half of the unnamed
///   targets on a node; beside points with the names of nodes, targets with a label do not count
///   for that
/// @throws std::invalid_argument for noise that is negative or not finite
[[nodiscard]] TAUT_CORE_EXPORT Survey match_to_nodes(const CableNet& net,
                                                     const std::vector<SurveyPoint>& points,
                                                     double noise_std = 0.0);

}  // namespace taut
