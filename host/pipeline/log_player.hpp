// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "host/datasets/log_record.hpp"
#include "host/geometry/pose2.hpp"
#include "host/pipeline/observation_sink.hpp"

namespace echomap::pipeline {

/// Which of a log's poses count.
enum class PoseSource : std::uint8_t {
  kOdometry,  ///< What the robot believed, from where its log begins.
  kGiven,     ///< What the log gives as corrected or true; between two of them, odometry continues.
  /// Odometry that begins at the origin, for SLAM: coordinates of a country leave no digits for
  /// centimetres. A fix then gives the place of that origin in the log's frame.
  kOdometryFromOrigin,
};

/// What a log held, and what could not be used.
struct LogCounts {
  std::size_t records = 0;
  std::size_t odometry_poses = 0;
  std::size_t given_poses = 0;
  std::size_t poses_without_stamp = 0;
  std::size_t scans = 0;
  std::size_t beams = 0;
  std::size_t scans_without_pose = 0;      ///< Before the first given pose; not played.
  std::size_t bumps = 0;                   ///< Times that something was met.
  std::size_t sightings = 0;               ///< Of landmarks.
  std::size_t sightings_without_pose = 0;  ///< As of scans.
};

/// Plays the log of another robot, record by record, as observations: odometry, range scans,
/// contacts, landmarks, and fixes where the log's own poses count.
///
/// The stamps of odometry rise: a pose without one comes a millisecond after the one before it, and
/// one whose stamp does not rise a microsecond after. Odometry begins at the origin where the log
/// begins with something else.
class LogPlayer {
 public:
  /// `sink` has to live as long.
  explicit LogPlayer(ObservationSink& sink, PoseSource source = PoseSource::kOdometry)
      : sink_(&sink), source_(source) {}

  void play(const datasets::LogRecord& record);

  const LogCounts& counts() const { return counts_; }
  /// From the first stamp of the log to its last; empty where it has none.
  std::optional<double> duration_s() const;

 private:
  void take(const datasets::OdometryPose& pose);
  void take(const datasets::OdometryStep& step);
  void take(const datasets::WheelIncrement& wheels);
  void take(const datasets::Heading& heading) { heading_rad_ = heading.heading_rad; }
  void take(const datasets::GivenPose& pose);
  void take(const datasets::GivenPosition& /*has_no_heading*/) {}
  void take(const sensors::RangeScan& scan);
  void take(const datasets::Contact& contact);
  void take(const datasets::LandmarkSighting& sighting);

  void move_to(std::optional<double> stamp_s, const geometry::Pose2& T_odom_robot);
  void report_pose(std::optional<double> stamp_s);
  /// Whether an observation has a pose: by odometry it is at the origin before the log says more.
  bool is_placed(std::optional<double> stamp_s);

  ObservationSink* sink_;
  PoseSource source_;
  LogCounts counts_;
  geometry::Pose2 T_odom_robot_;
  geometry::Pose2 T_log_odom_;  ///< Where the log's odometry begins, if it is told from the origin.
  bool has_fix_ = false;
  std::optional<time::RobotTime> last_stamp_;  ///< Of the odometry that was told.
  /// The direction that a gyro gave last, and the one that the wheels' last increment ended with.
  std::optional<double> heading_rad_;
  std::optional<double> used_heading_rad_;
  datasets::Contact last_contact_;
  std::optional<double> first_stamp_s_;
  std::optional<double> latest_stamp_s_;
};

}  // namespace echomap::pipeline
