// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "host/datasets/log_record.hpp"
#include "host/mapping/bump_insertion.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/point_cloud_map.hpp"
#include "host/mapping/ray_insertion.hpp"
#include "host/mapping/sonar_cone_mapper.hpp"
#include "host/pipeline/log_poses.hpp"
#include "host/pipeline/seen_landmark.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {

/// What is made of a log's ranges: cells of an occupancy grid, or the echoes as they are.
enum class MapKind : std::uint8_t { kGrid, kPoints };

/// How a log becomes a map.
struct LogMapperParams {
  PoseSource poses = PoseSource::kOdometry;
  MapKind map = MapKind::kGrid;
  mapping::OccupancyGridParams grid;
  mapping::RayInsertionParams rays;  ///< Of lasers. A beam without return says nothing.
  /// Of sonars; opening and range are those of the scan, the grid is that above.
  mapping::SonarConeMapperParams sonars;
  mapping::BumpParams bumps;
};

/// What a log held, and what could not be used.
struct LogCounts {
  std::size_t records = 0;
  std::size_t scans = 0;
  std::size_t beams = 0;
  std::size_t scans_without_pose = 0;  ///< Before the first given pose; not in the map.
  std::size_t poses_without_stamp = 0;
  std::size_t bumps = 0;      ///< Times that something was met, with a pose or without.
  std::size_t sightings = 0;  ///< Of landmarks.
  std::size_t sightings_without_pose = 0;  ///< As of scans.
};

/// Makes a map of a log, record by record. The map frame is that of the poses that count.
class LogMapper {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit LogMapper(const LogMapperParams& params = {});

  void add(const datasets::LogRecord& record);

  /// The trajectory has the log's own stamps; a pose without one is put a millisecond after the one
  /// before it, and one whose stamp does not rise is left out.
  Snapshot snapshot() const;
  const LogCounts& counts() const { return counts_; }
  const LogPoses& poses() const { return poses_; }
  /// Every sighting of a landmark that has a pose, in their order.
  const std::vector<SeenLandmark>& landmarks() const { return landmarks_; }
  /// From the first stamp of the log to its last; empty where it has none.
  std::optional<double> duration_s() const;

 private:
  void note_pose(std::optional<double> stamp_s);
  void use(const sensors::RangeScan& scan);
  /// A bump is where a switch closes; that it stays closed is no news.
  void use(const datasets::Contact& contact);
  void use(const datasets::LandmarkSighting& sighting);
  template <class Other>
  void use(const Other& /*is_no_observation*/) {}
  /// Begins the trajectory with an observation before which the log tells of no pose.
  void begin_trajectory(std::optional<double> stamp_s);
  void add_points(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan);
  void add_rays(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan);
  void add_readings(const geometry::Pose2& T_map_sensor, const sensors::RangeScan& scan);
  /// Made when a log first has cones like those of the scan.
  mapping::SonarConeMapper& sonar_of(const sensors::RangeScan& scan);
  /// What the lasers and the sonars say together.
  mapping::OccupancyGrid grid() const;

  LogMapperParams params_;
  LogPoses poses_;
  LogCounts counts_;
  std::optional<double> first_stamp_s_;
  std::optional<double> last_stamp_s_;
  std::vector<StampedPose> trajectory_;
  mapping::OccupancyGrid grid_;
  mapping::RayInserter rays_;
  std::vector<mapping::Ray> scan_rays_;
  /// By the opening of their cones, and whether they are of light.
  std::map<std::pair<double, bool>, mapping::SonarConeMapper> sonars_;
  std::vector<geometry::Pose2> scan_poses_;
  std::vector<mapping::MapPoint> points_;
  datasets::Contact last_contact_;
  std::vector<SeenLandmark> landmarks_;
};

}  // namespace echomap::pipeline
