// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "host/datasets/companion_file.hpp"
#include "host/datasets/mrclam_log.hpp"
#include "host/localization/peer_sighting.hpp"
#include "host/localization/pose_ekf.hpp"
#include "tests/benchmarks/landmark_runs.hpp"
#include "tests/benchmarks/true_path.hpp"
#include "tests/support/log_files.hpp"

namespace echomap::bench {

namespace {

using geometry::Pose2;
using localization::EkfOutcome;
using localization::PoseEkf;

constexpr std::int64_t kRobots = 5;
/// The log's odometry is what was commanded. The robots follow it that much later and less far:
/// measured by the true paths of all five, then chosen, as all below, for the error on this set.
constexpr double kCommandLeadS = 0.2;
constexpr double kDriveShare = 0.92;
constexpr double kTurnShare = 0.88;
/// Noise of sightings, about that of their residuals against the true paths; ranges count less, as
/// pictures in a row err alike.
constexpr double kRangeStdM = 0.02;
constexpr double kRangeStdShare = 0.1;
constexpr double kBearingStdRad = 0.007;
/// A picture is stamped when it has been read.
constexpr double kPictureAgeS = 0.05;
/// Two robots that see each other tell so no more often: pictures in a row err alike.
constexpr double kPeerEveryS = 0.25;

using Landmarks = std::map<std::int64_t, Eigen::Vector2d>;

Landmarks read_landmarks(const std::filesystem::path& path) {
  Landmarks landmarks;
  datasets::CompanionLines lines(path);
  while (auto fields = lines.next()) {
    const std::int64_t id = fields->integer("the landmark");
    const double x_m = fields->number("x");
    const double y_m = fields->number("y");
    landmarks[id] = {x_m, y_m};
  }
  return landmarks;
}

PoseEkf started_filter(const Pose2& T_map_robot) {
  localization::PoseEkfParams params;
  params.motion.turn_by_turn = 0.04;
  params.motion.turn_by_drive_rad2_per_m2 = 0.03;
  params.motion.drive_by_drive = 0.02;
  return PoseEkf({T_map_robot, 1e-4 * Eigen::Matrix3d::Identity()}, params);
}

/// One robot of the team and what is known of it.
class Robot {
 public:
  void add_truth(double stamp_s, const Pose2& T_map_robot) { truth_.add(stamp_s, T_map_robot); }

  void move(double stamp_s, const Pose2& T_last_now) {
    T_odom_robot_ = T_odom_robot_ * Pose2(kDriveShare * T_last_now.x_m(),
                                          kDriveShare * T_last_now.y_m(),
                                          kTurnShare * T_last_now.heading_rad());
    const auto truth = truth_.at(stamp_s);
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
  TruePath truth_;
  std::optional<PoseEkf> filter_;
  Pose2 T_odom_robot_;
  Pose2 T_map_odom_;
  std::map<std::int64_t, double> last_peer_s_;
  FollowTally tally_;
};

using Team = std::map<std::int64_t, Robot>;

/// Something that a robot did or saw.
struct Event {
  double stamp_s = 0.0;
  std::int64_t robot = 0;
  std::variant<datasets::OdometryStep, datasets::LandmarkSighting> record;
};

/// Odometry and sightings of one robot; its truth goes to itself.
void read_robot(const std::filesystem::path& folder,
                std::int64_t number,
                Robot& robot,
                std::vector<Event>& events) {
  const auto log =
      datasets::open_mrclam_log(folder / ("Robot" + std::to_string(number) + "_Odometry.dat.gz"));
  // One picture shows several barcodes: the first has its stamp.
  double picture_s = 0.0;
  while (auto record = log->next()) {
    const auto stamp_s = datasets::stamp_s(*record);
    if (const auto* given = std::get_if<datasets::GivenPose>(&*record)) {
      if (stamp_s) {
        robot.add_truth(*stamp_s, given->T_map_robot);
      }
    } else if (const auto* seen = std::get_if<datasets::LandmarkSighting>(&*record)) {
      picture_s = stamp_s.value_or(picture_s);
      events.push_back({picture_s - kPictureAgeS, number, *seen});
    } else if (const auto* step = std::get_if<datasets::OdometryStep>(&*record); step && stamp_s) {
      events.push_back({*stamp_s + kCommandLeadS, number, *step});
    }
  }
}

/// A sighting of one robot by another is told to both.
void meet(const localization::PeerSighting& sighting, Robot& observer, Robot& peer) {
  const auto looks = observer.filter().belief();
  const auto is_seen = peer.filter().belief();
  observer.filter().update(localization::peer_as_landmark(sighting, looks, is_seen));
  peer.filter().update(localization::peer_as_fix(sighting, looks, is_seen));
}

void see(const Event& event,
         const datasets::LandmarkSighting& seen,
         const Landmarks& landmarks,
         bool as_team,
         Team& team) {
  Robot& robot = team[event.robot];
  const double range_std_m = std::hypot(kRangeStdM, kRangeStdShare * seen.range_m);
  const auto landmark = landmarks.find(seen.id);
  if (landmark != landmarks.end()) {
    robot.filter().update(localization::LandmarkObservation{event.stamp_s,
                                                            landmark->second,
                                                            {},
                                                            seen.range_m,
                                                            seen.bearing_rad,
                                                            range_std_m,
                                                            kBearingStdRad});
  } else if (as_team && seen.id <= kRobots && team[seen.id].started() &&
             robot.is_due(seen.id, event.stamp_s)) {
    meet({event.stamp_s, seen.range_m, seen.bearing_rad, range_std_m, kBearingStdRad},
         robot,
         team[seen.id]);
  }
}

}  // namespace

std::vector<FollowScore> follow_mrclam(const std::filesystem::path& folder, bool as_team) {
  const Landmarks landmarks = read_landmarks(folder / "Landmark_Groundtruth.dat.gz");
  Team team;
  std::vector<Event> events;
  for (std::int64_t number = 1; number <= kRobots; ++number) {
    read_robot(folder, number, team[number], events);
  }
  std::stable_sort(events.begin(), events.end(), [](const Event& left, const Event& right) {
    return left.stamp_s < right.stamp_s;
  });
  for (const Event& event : events) {
    if (const auto* step = std::get_if<datasets::OdometryStep>(&event.record)) {
      team[event.robot].move(event.stamp_s, step->T_last_now);
    } else if (team[event.robot].started()) {
      see(event, std::get<datasets::LandmarkSighting>(event.record), landmarks, as_team, team);
    }
  }
  std::vector<FollowScore> scores;
  for (const auto& [number, robot] : team) {
    scores.push_back(robot.score());
  }
  return scores;
}

}  // namespace echomap::bench
