// SPDX-License-Identifier: MIT
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Cholesky>

#include "host/models/cut_step_spread.hpp"
#include "host/slam/ekf_slam_filter.hpp"
#include "tests/benchmarks/ekf_slam_runs.hpp"
#include "tests/benchmarks/landmark_map_error.hpp"
#include "tests/benchmarks/mrclam_events.hpp"
#include "tests/benchmarks/true_path.hpp"

namespace echomap::bench {

namespace {

using geometry::Pose2;

/// Two robots that see each other tell so no more often: pictures in a row err alike.
constexpr double kPeerEveryS = 0.25;
constexpr double kStartVariance = 1e-4;
/// Sightings are taken for less sure than where landmarks are known: here an error that stays, as
/// that of a barcode seen aslant, goes into the map and is not seen as one.
constexpr double kRangeStddevFactor = 2.0;
constexpr double kBearingStddevFactor = 3.0;

/// Some robots of a set in one filter.
class Team {
 public:
  Team(const MrclamSet& set,
       const std::vector<std::int64_t>& numbers,
       const slam::EkfSlamFilterParams& params)
      : set_(&set), filter_(starts(set, numbers), params) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      members_[numbers[i]].index = i;
    }
  }

  void take(const MrclamEvent& event) {
    const auto member = members_.find(event.robot);
    if (member == members_.end()) {
      return;
    }
    if (const auto* step = std::get_if<datasets::OdometryStep>(&event.record)) {
      move(event, step->T_last_now, member->second);
    } else if (member->second.is_started) {
      see(event, std::get<datasets::LandmarkSighting>(event.record), member->second);
    }
  }

  LandmarkSlamScore score() const {
    LandmarkSlamScore score;
    for (const auto& [number, member] : members_) {
      score.robots.push_back(member.tally.score(member.gated));
    }
    std::vector<PlacePair> pairs;
    for (const auto& [id, landmark] : indices_) {
      const Eigen::Vector2d truth_m = set_->landmarks_m.at(id);
      pairs.emplace_back(filter_.landmarks()[landmark].value, truth_m);
      const Eigen::Vector2d off_m = pairs.back().first - truth_m;
      score.landmark_nees += off_m.dot(filter_.landmark_covariance(landmark).llt().solve(off_m)) /
                             static_cast<double>(indices_.size());
    }
    score.landmark_m = rms_m(pairs, {});
    score.aligned_landmark_m = rms_m(pairs, laid_onto(pairs));
    score.landmarks = pairs.size();
    return score;
  }

 private:
  struct Member {
    std::size_t index = 0;
    bool is_started = false;
    Pose2 T_map_dead_reckoned;
    std::map<std::int64_t, double> last_peer_s;
    std::size_t gated = 0;
    FollowTally tally;
  };

  /// The true pose of each robot at the end of its first step of which it is known.
  static std::vector<localization::PoseGaussian> starts(const MrclamSet& set,
                                                        const std::vector<std::int64_t>& numbers) {
    std::map<std::int64_t, Pose2> first;
    for (const MrclamEvent& event : set.events) {
      const auto truth = set.truths.at(event.robot).at(event.stamp_s);
      if (truth && std::holds_alternative<datasets::OdometryStep>(event.record)) {
        first.try_emplace(event.robot, *truth);
      }
    }
    std::vector<localization::PoseGaussian> starts;
    for (const std::int64_t number : numbers) {
      starts.push_back({first.at(number), kStartVariance * Eigen::Matrix3d::Identity()});
    }
    return starts;
  }

  void move(const MrclamEvent& event, const Pose2& T_last_now, Member& member) {
    const auto truth = set_->truths.at(event.robot).at(event.stamp_s);
    if (!member.is_started && truth) {
      member.is_started = true;
      member.T_map_dead_reckoned = *truth;
    } else if (member.is_started) {
      const models::OdometryStep step = models::odometry_step({}, T_last_now);
      filter_.move(member.index, T_last_now, step, models::cut_step_spread(motion_, step, {}));
      member.T_map_dead_reckoned = member.T_map_dead_reckoned * T_last_now;
    }
    if (member.is_started && truth) {
      member.tally.count(filter_.belief(member.index), *truth, member.T_map_dead_reckoned, true);
    }
  }

  void see(const MrclamEvent& event, const datasets::LandmarkSighting& seen, Member& member) {
    slam::LandmarkSighting sighting;
    sighting.value = {seen.range_m, seen.bearing_rad};
    const Eigen::Vector2d sd(kRangeStddevFactor * mrclam_range_stddev_m(seen.range_m),
                             kBearingStddevFactor * kMrclamBearingStddevRad);
    sighting.noise = sd.cwiseAbs2().asDiagonal();
    sighting.robot = member.index;
    if (seen.id <= kMrclamRobots) {
      see_peer(event, sighting, seen.id, member);
      return;
    }
    const auto known = indices_.find(seen.id);
    if (known == indices_.end()) {
      indices_[seen.id] = filter_.add(sighting);
      return;
    }
    take(filter_.linearized(sighting, known->second), member);
  }

  void see_peer(const MrclamEvent& event,
                const slam::LandmarkSighting& sighting,
                std::int64_t number,
                Member& member) {
    const auto peer = members_.find(number);
    const auto last_s = member.last_peer_s.find(number);
    const bool is_due =
        last_s == member.last_peer_s.end() || event.stamp_s - last_s->second >= kPeerEveryS;
    if (peer == members_.end() || !peer->second.is_started || !is_due) {
      return;
    }
    member.last_peer_s[number] = event.stamp_s;
    take(filter_.linearized_peer(sighting, peer->second.index), member);
  }

  void take(const std::optional<slam::LinearSighting>& linear, Member& member) {
    if (linear && filter_.squared_distance(*linear) <= kGate) {
      filter_.update({&*linear, 1});
    } else {
      ++member.gated;
    }
  }

  const MrclamSet* set_;
  models::OdometryMotion motion_{mrclam_motion()};
  slam::EkfSlamFilter filter_;
  std::map<std::int64_t, Member> members_;
  std::map<std::int64_t, std::size_t> indices_;
};

LandmarkSlamScore run(const std::filesystem::path& folder,
                      const std::vector<std::int64_t>& numbers,
                      const slam::EkfSlamFilterParams& params) {
  const MrclamSet set = read_mrclam(folder);
  Team team(set, numbers, params);
  for (const MrclamEvent& event : set.events) {
    team.take(event);
  }
  return team.score();
}

}  // namespace

LandmarkSlamScore slam_mrclam_team(const std::filesystem::path& folder,
                                   const slam::EkfSlamFilterParams& params) {
  return run(folder, {1, 2, 3, 4, 5}, params);
}

LandmarkSlamScore slam_mrclam_robot(const std::filesystem::path& folder,
                                    std::int64_t robot,
                                    const slam::EkfSlamFilterParams& params) {
  return run(folder, {robot}, params);
}

}  // namespace echomap::bench
