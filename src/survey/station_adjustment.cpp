// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/station_adjustment.hpp"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "numerics/small_dense.hpp"
#include "survey/covariance.hpp"
#include "survey/polar_residual.hpp"

namespace taut {
namespace {

constexpr int most_steps = 30;
constexpr double small_step_of_poses = 1e-9;  ///< [m], [rad]

/// Two targets less far apart than this, seen from above, give no orientation [m].
constexpr double least_spread = 0.01;

void check_polar_observation(const PolarObservation& observation, size_t stations) {
    const auto is_positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (observation.station < 0 || observation.station >= static_cast<int>(stations)) {
        throw SurveyError(observation.line, fmt::format("is of station {}, expected 0 to {}",
                                                        observation.station, stations - 1));
    }
    if (!std::isfinite(observation.direction) || !std::isfinite(observation.zenith) ||
        !std::isfinite(observation.target_height)) {
        throw SurveyError(observation.line, "has an observation that is not finite");
    }
    if (!is_positive(observation.distance)) {
        throw SurveyError(observation.line, fmt::format("has the distance {}, expected more than 0",
                                                        observation.distance));
    }
    if (!is_positive(observation.angle_std) || !is_positive(observation.distance_std)) {
        throw SurveyError(observation.line,
                          fmt::format("has the standard deviations {} rad and {} m, expected more "
                                      "than 0",
                                      observation.angle_std, observation.distance_std));
    }
}

/// Observations, targets by number, and the poses and places found so far.
class StationBlock {
public:
    explicit StationBlock(const PolarSurvey& survey)
        : m_stations(survey.stations),
          m_observations(survey.observations),
          m_poses(survey.stations.size()),
          m_seen_from(survey.stations.size()) {
        std::map<std::string, int> number_of;
        for (const PolarObservation& observation : m_observations) {
            check_polar_observation(observation, m_stations.size());
            const auto [found, is_new] =
                number_of.emplace(observation.target, static_cast<int>(m_first.size()));
            if (is_new) {
                m_first.push_back(&observation);
            }
            m_target_of.push_back(found->second);
            m_seen_from[observation.station].insert(found->second);
        }
        for (size_t s = 0; s < m_stations.size(); ++s) {
            if (m_seen_from[s].empty()) {
                throw SurveyError(m_stations[s].line, fmt::format("station '{}' has no observation",
                                                                  m_stations[s].name));
            }
        }
        if (m_stations.empty()) {
            throw SurveyError(0, "holds no station");
        }
        m_places.setZero(3, target_count());
        const auto most = std::ranges::max_element(
            m_seen_from, {}, [](const std::set<int>& seen) { return seen.size(); });
        m_datum = static_cast<int>(most - m_seen_from.begin());
    }

    /// Places stations one after the other, each by the targets placed before it.
    void approximate() {
        std::vector<bool> is_placed(m_stations.size(), false);
        std::vector<bool> is_known(target_count(), false);
        place_targets(m_datum, is_known);
        is_placed[m_datum] = true;
        for (size_t count = 1; count < m_stations.size(); ++count) {
            const int next = best_tied(is_placed, is_known);
            place_station(next, is_known);
            place_targets(next, is_known);
            is_placed[next] = true;
        }
    }

    /// Gauss-Newton steps until they are too small to matter; then the inverse of the last normal
    /// matrix holds the covariances.
    void adjust() {
        for (int k = 0; k < most_steps; ++k) {
            if (step() < small_step_of_poses) {
                return;
            }
        }
        throw SurveyError(0,
                          "has observations of several stations that do not converge to places of "
                          "stations and targets: does each target have the same name from all "
                          "stations?");
    }

    [[nodiscard]] StationAdjustment result() const;

private:
    using PoseBlock = Eigen::Matrix<double, 3, 4>;

    /// What is left of the normal equations of a target.
    struct TargetBlock {
        Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
        Eigen::Vector3d g = Eigen::Vector3d::Zero();
        std::map<int, PoseBlock> with_pose;  ///< by station
    };

    [[nodiscard]] int target_count() const { return static_cast<int>(m_first.size()); }
    /// Index of the first unknown of a station's pose; -1 for the datum.
    [[nodiscard]] Eigen::Index at(int station) const {
        return station == m_datum ? -1 : 4 * (station - (station > m_datum ? 1 : 0));
    }
    [[nodiscard]] Eigen::Index pose_size() const { return 4 * (std::ssize(m_stations) - 1); }

    [[nodiscard]] int best_tied(const std::vector<bool>& is_placed,
                                const std::vector<bool>& is_known) const;
    void place_station(int station, const std::vector<bool>& is_known);
    void place_targets(int station, std::vector<bool>& is_known);
    double step();
    [[nodiscard]] Eigen::Matrix3Xd by_poses(int target) const;
    [[nodiscard]] Eigen::Matrix<double, 3, 7> common_modes(int target) const;
    [[nodiscard]] std::pair<Eigen::MatrixXd, Eigen::RowVectorXd> common_modes_by_poses() const;

    const std::vector<PolarStation>& m_stations;
    const std::vector<PolarObservation>& m_observations;
    std::vector<StationPose> m_poses;
    std::vector<const PolarObservation*> m_first;  ///< of each target
    std::vector<int> m_target_of;                  ///< of each observation
    std::vector<std::set<int>> m_seen_from;        ///< targets by station
    Points m_places;                               ///< of the targets
    int m_datum = 0;
    std::vector<TargetBlock> m_blocks;
    Eigen::MatrixXd m_pose_covariance;
};

/// The station that is not placed and sees most of the targets that are.
int StationBlock::best_tied(const std::vector<bool>& is_placed,
                            const std::vector<bool>& is_known) const {
    constexpr auto needed = 2;
    int best = -1;
    std::ptrdiff_t most = -1;
    for (size_t s = 0; s < m_stations.size(); ++s) {
        const auto common =
            std::ranges::count_if(m_seen_from[s], [&](int t) { return is_known[t]; });
        if (!is_placed[s] && common > most) {
            most = common;
            best = static_cast<int>(s);
        }
    }
    if (most < needed) {
        throw SurveyError(
            m_stations[best].line,
            fmt::format("station '{}' has {} targets in common with the other stations, expected "
                        "at least {}: it has no orientation",
                        m_stations[best].name, most, needed));
    }
    return best;
}

/// By the rotation about the vertical and the shift that bring what it sees nearest to known
/// targets.
void StationBlock::place_station(int station, const std::vector<bool>& is_known) {
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> pairs;  // seen, known
    Eigen::Vector3d seen_middle = Eigen::Vector3d::Zero();
    Eigen::Vector3d known_middle = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < m_observations.size(); ++i) {
        const PolarObservation& observation = m_observations[i];
        if (observation.station == station && is_known[m_target_of[i]]) {
            const Eigen::Vector3d height = observation.target_height * Eigen::Vector3d::UnitZ();
            pairs.emplace_back(sighted(observation) - height, m_places.col(m_target_of[i]));
            seen_middle += pairs.back().first;
            known_middle += pairs.back().second;
        }
    }
    seen_middle /= static_cast<double>(pairs.size());
    known_middle /= static_cast<double>(pairs.size());
    double along = 0.0;
    double across = 0.0;
    double spread = 0.0;
    for (const auto& [seen, known] : pairs) {
        const Eigen::Vector2d a = (seen - seen_middle).head<2>();
        const Eigen::Vector2d b = (known - known_middle).head<2>();
        along += a.dot(b);
        across += a.x() * b.y() - a.y() * b.x();
        spread = std::max({spread, a.norm(), b.norm()});
    }
    if (!(spread > 0.5 * least_spread)) {
        throw SurveyError(m_stations[station].line,
                          fmt::format("station '{}' has only targets in common with the other "
                                      "stations that are above each other, expected two {:.0f} mm "
                                      "apart as seen from above: it has no orientation",
                                      m_stations[station].name, 1e3 * least_spread));
    }
    StationPose& pose = m_poses[station];
    pose.orientation = std::atan2(across, along);
    pose.place = known_middle - rotation_of(pose) * seen_middle;
}

void StationBlock::place_targets(int station, std::vector<bool>& is_known) {
    const StationPose& pose = m_poses[station];
    for (size_t i = 0; i < m_observations.size(); ++i) {
        const PolarObservation& observation = m_observations[i];
        if (observation.station == station && !is_known[m_target_of[i]]) {
            m_places.col(m_target_of[i]) = pose.place + rotation_of(pose) * sighted(observation) -
                                           observation.target_height * Eigen::Vector3d::UnitZ();
            is_known[m_target_of[i]] = true;
        }
    }
}

/// Targets are eliminated first, each by its own 3 x 3 block: what is left is of the size of the
/// poses.
/// @return the largest change of a pose or place
double StationBlock::step() {
    const Eigen::Index size = pose_size();
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd right_side = Eigen::VectorXd::Zero(size);
    m_blocks.assign(target_count(), {});
    for (size_t i = 0; i < m_observations.size(); ++i) {
        const int station = m_observations[i].station;
        const int target = m_target_of[i];
        const PolarResidual e =
            polar_residual(m_observations[i], m_poses[station], m_places.col(target));
        TargetBlock& block = m_blocks[target];
        block.N += e.by_target.transpose() * e.by_target;
        block.g -= e.by_target.transpose() * e.value;
        if (const Eigen::Index k = at(station); k >= 0) {
            S.block<4, 4>(k, k) += e.by_pose.transpose() * e.by_pose;
            right_side.segment<4>(k) -= e.by_pose.transpose() * e.value;
            block.with_pose.try_emplace(station, PoseBlock::Zero()).first->second +=
                e.by_target.transpose() * e.by_pose;
        }
    }
    for (const TargetBlock& block : m_blocks) {
        const Eigen::LLT<Eigen::Matrix3d> own(block.N);
        for (const auto& [a, of_a] : block.with_pose) {
            right_side.segment<4>(at(a)) -= of_a.transpose() * own.solve(block.g);
            for (const auto& [b, of_b] : block.with_pose) {
                S.block<4, 4>(at(a), at(b)) -= of_a.transpose() * own.solve(of_b);
            }
        }
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(S);
    if (factor.info() != Eigen::Success) {
        throw SurveyError(
            0,
            "has stations whose places are not determined: they have too few targets in "
            "common");
    }
    const Eigen::VectorXd change = factor.solve(right_side);
    m_pose_covariance = factor.solve(Eigen::MatrixXd::Identity(size, size));
    double largest = size > 0 ? change.cwiseAbs().maxCoeff() : 0.0;
    for (size_t s = 0; s < m_stations.size(); ++s) {
        if (const Eigen::Index k = at(static_cast<int>(s)); k >= 0) {
            m_poses[s].place += change.segment<3>(k);
            m_poses[s].orientation += change(k + 3);
        }
    }
    for (int t = 0; t < target_count(); ++t) {
        Eigen::Vector3d g = m_blocks[t].g;
        for (const auto& [station, coupling] : m_blocks[t].with_pose) {
            g -= coupling * change.segment<4>(at(station));
        }
        const Eigen::Vector3d of_place = m_blocks[t].N.llt().solve(g);
        m_places.col(t) += of_place;
        largest = std::max(largest, of_place.cwiseAbs().maxCoeff());
    }
    return std::isfinite(largest) ? largest : small_step_of_poses;
}

/// How the place of a target follows the poses (3 x poses).
Eigen::Matrix3Xd StationBlock::by_poses(int target) const {
    Eigen::Matrix3Xd U = Eigen::Matrix3Xd::Zero(3, pose_size());
    const Eigen::Matrix3d own = m_blocks[target].N.inverse();
    for (const auto& [station, coupling] : m_blocks[target].with_pose) {
        U.middleCols<4>(at(station)) = -own * coupling;
    }
    return U;
}

/// How it follows small motions of all targets, three shifts and three rotations about their
/// middle, and their scale.
Eigen::Matrix<double, 3, 7> StationBlock::common_modes(int target) const {
    const Eigen::Vector3d arm = m_places.col(target) - m_places.rowwise().mean();
    Eigen::Matrix<double, 3, 7> H;
    H.leftCols<3>().setIdentity();
    H.middleCols<3>(3) << 0.0, arm.z(), -arm.y(),  //
        -arm.z(), 0.0, arm.x(),                    //
        arm.y(), -arm.x(), 0.0;
    H.col(6) = arm;
    return H;
}

/// The motion of all targets that is nearest to what each pose does to them (6 x poses), and the
/// scale where that is fitted with it (1 x poses), (pose-errors).
std::pair<Eigen::MatrixXd, Eigen::RowVectorXd> StationBlock::common_modes_by_poses() const {
    Eigen::Matrix<double, 7, 7> A = Eigen::Matrix<double, 7, 7>::Zero();
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(7, pose_size());
    for (int t = 0; t < target_count(); ++t) {
        const auto H = common_modes(t);
        A += H.transpose() * m_blocks[t].N * H;
        B += H.transpose() * m_blocks[t].N * by_poses(t);
    }
    // Of least norm, since A is singular where the targets lie on a line.
    return {minimum_norm_solution(A.topLeftCorner<6, 6>(), B.topRows<6>()),
            minimum_norm_solution(A, B).row(6)};
}

StationAdjustment StationBlock::result() const {
    StationAdjustment result{.points = {}, .poses = m_poses, .datum = m_datum};
    const auto [common_motion, common_scale] = common_modes_by_poses();
    if (pose_size() > 0) {
        result.scale_std =
            std::sqrt((common_scale * m_pose_covariance * common_scale.transpose()).value());
    }
    for (int t = 0; t < target_count(); ++t) {
        const Eigen::Matrix3Xd U =
            by_poses(t) - common_modes(t).leftCols<6>() * common_motion;  // (pose-errors)
        const PlaceNoise noise =
            noise_of(m_blocks[t].N.inverse() + U * m_pose_covariance * U.transpose());
        result.points.push_back({.id = m_first[t]->target,
                                 .position = m_places.col(t),
                                 .line = m_first[t]->line,
                                 .noise_std = noise.std_dev,
                                 .noise_correlations = noise.correlations});
    }
    const auto observed = 3 * std::ssize(m_observations);
    result.redundancy = static_cast<int>(observed - 3 * target_count() - pose_size());
    double squares = 0.0;
    for (size_t i = 0; i < m_observations.size(); ++i) {
        const Eigen::Vector3d e =
            polar_residual(m_observations[i], m_poses[m_observations[i].station],
                           m_places.col(m_target_of[i]))
                .value;
        squares += e.squaredNorm();
        if (const double largest = e.cwiseAbs().maxCoeff(); largest > result.worst_residual) {
            result.worst = static_cast<int>(i);
            result.worst_residual = largest;
        }
    }
    result.noise_ratio = result.redundancy > 0 ? std::sqrt(squares / result.redundancy) : 0.0;
    return result;
}

}  // namespace

PolarObservation in_first_face(PolarObservation observation) {
    if (observation.zenith > std::numbers::pi) {
        observation.zenith = std::max(0.0, 2.0 * std::numbers::pi - observation.zenith);
        observation.direction +=
            observation.direction < std::numbers::pi ? std::numbers::pi : -std::numbers::pi;
    }
    return observation;
}

StationAdjustment adjust_stations(const PolarSurvey& survey) {
    StationBlock block(survey);
    block.approximate();
    block.adjust();
    return block.result();
}

}  // namespace taut
