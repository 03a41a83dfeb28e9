// SPDX-License-Identifier: MIT
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "host/localization/peer_sighting.hpp"
#include "host/localization/pose_ekf.hpp"
#include "tests/benchmarks/landmark_runs.hpp"
#include "tests/benchmarks/mrclam_events.hpp"
#include "tests/benchmarks/true_path.hpp"

namespace echomap::bench {

namespace {

using geometry::Pose2;
using localization::EkfOutcome;
using localization::PoseEkf;

/// Two robots that see each other tell so no more often: pictures in a row err alike.
constexpr double kPeerEveryS = 0.25;

PoseEkf started_filter(const Pose2& T_map_robot) {
  localization::PoseEkfParams params;
  params.motion = mrclam_motion();
  return PoseEkf({T_map_robot, 1e-4 * Eigen::Matrix3d::Identity()}, params);
}

/// One robot of the team and what is known of it.
class Robot {
 public:
  void move(double stamp_s, const Pose2& T_last_now, const std::optional<Pose2>& truth) {
    T_odom_robot_ = T_odom_robot_ * T_last_now;
    if (!filter_ && truth) {
      filter_ = started_filter(*truth);
      T_map_odom_ = *truth * T_odom_robot_.inverse();
    }
    if (filter_ && filter_->move(stamp_s, T_odom_robot_) == EkfOutcome::kApplied && truth) {
      tally_.count(filter_->belief(), *truth, T_map_odom_ * T_odom_robot_, true);
    }
  }
  bool started() const { return filter_.has_value(); }
  PoseEkf& filter() { return *filter_; }
  /// Whether it is time to hear of that robot again.
  bool is_due(std::int64_t peer, double stamp_s) {
    double& last_s = last_peer_s_[peer];
    const bool due = stamp_s - last_s >= kPeerEveryS;
    last_s = due ? stamp_s : last_s;
    return due;
  }
  FollowScore score() const { return tally_.score(filter_->count(EkfOutcome::kGated)); }

 private:
  std::optional<PoseEkf> filter_;
  Pose2 T_odom_robot_;
  Pose2 T_map_odom_;
  std::map<std::int64_t, double> last_peer_s_;
  FollowTally tally_;
};

using Team = std::map<std::int64_t, Robot>;

/// A sighting of one robot by another is told to both.
void meet(const localization::PeerSighting& sighting, Robot& observer, Robot& peer) {
  const auto looks = observer.filter().belief();
  const auto is_seen = peer.filter().belief();
  observer.filter().update(localization::peer_as_landmark(sighting, looks, is_seen));
  peer.filter().update(localization::peer_as_fix(sighting, looks, is_seen));
}

void see(const MrclamEvent& event,
         const datasets::LandmarkSighting& seen,
         const std::map<std::int64_t, Eigen::Vector2d>& landmarks,
         bool as_team,
         Team& team) {
  Robot& robot = team[event.robot];
  const double range_stddev_m = mrclam_range_stddev_m(seen.range_m);
  const auto landmark = landmarks.find(seen.id);
  if (landmark != landmarks.end()) {
    robot.filter().update(localization::LandmarkObservation{event.stamp_s,
                                                            landmark->second,
                                                            {},
                                                            seen.range_m,
                                                            seen.bearing_rad,
                                                            range_stddev_m,
                                                            kMrclamBearingStddevRad});
  } else if (as_team && seen.id <= kMrclamRobots && team[seen.id].started() &&
             robot.is_due(seen.id, event.stamp_s)) {
    meet({event.stamp_s, seen.range_m, seen.bearing_rad, range_stddev_m, kMrclamBearingStddevRad},
         robot,
         team[seen.id]);
  }
}

}  // namespace

std::vector<FollowScore> follow_mrclam(const std::filesystem::path& folder, bool as_team) {
  const MrclamSet set = read_mrclam(folder);
  Team team;
  for (const MrclamEvent& event : set.events) {
    if (const auto* step = std::get_if<datasets::OdometryStep>(&event.record)) {
      const auto truth = set.truths.at(event.robot).at(event.stamp_s);
      team[event.robot].move(event.stamp_s, step->T_last_now, truth);
    } else if (team[event.robot].started()) {
      see(event,
          std::get<datasets::LandmarkSighting>(event.record),
          set.landmarks_m,
          as_team,
          team);
    }
  }
  std::vector<FollowScore> scores;
  for (const auto& [number, robot] : team) {
    scores.push_back(robot.score());
  }
  return scores;
}

}  // namespace echomap::bench
