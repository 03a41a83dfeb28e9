// SPDX-License-Identifier: MIT
#include "tests/support/team_recording.hpp"

#include <cmath>
#include <deque>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>

#include "hil_mock/world/robot_world.hpp"
#include "host/exploration/frontier.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/slam/slam_methods.hpp"
#include "host/team_map/submap_recorder.hpp"
#include "tests/support/offline_exploration.hpp"
#include "tests/support/offline_robot.hpp"

namespace echomap::tests {

namespace {

using geometry::Pose2;

constexpr double kWayCellM = 0.1;
constexpr double kWayClearanceM = 0.12;
constexpr double kStartClearanceM = 0.2;
constexpr std::size_t kMaxStops = 60;

/// How far it is to go from a place to anywhere, in cells.
class WayField {
 public:
  explicit WayField(const world::FloorPlan& plan) {
    for (const Eigen::Vector2d& corner_m : plan.room_m()) {
      box_.extend(corner_m);
    }
    columns_ = static_cast<int>(std::ceil(box_.sizes().x() / kWayCellM));
    rows_ = static_cast<int>(std::ceil(box_.sizes().y() / kWayCellM));
    for (int i = 0; i < columns_ * rows_; ++i) {
      const Eigen::Vector2d center_m =
          box_.min() + kWayCellM * Eigen::Vector2d(i % columns_ + 0.5, i / columns_ + 0.5);
      is_free_.push_back(plan.is_free(center_m) && plan.clearance_m(center_m) >= kWayClearanceM);
    }
  }

  /// Infinite where there is no way.
  double path_m(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
    std::vector<double> way(is_free_.size(), std::numeric_limits<double>::infinity());
    std::deque<int> open{index(from_m)};
    way[static_cast<std::size_t>(open.front())] = 0.0;
    while (!open.empty()) {
      const int at = open.front();
      open.pop_front();
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int x = at % columns_ + dx;
          const int y = at / columns_ + dy;
          if (x < 0 || y < 0 || x >= columns_ || y >= rows_) {
            continue;
          }
          const auto next = static_cast<std::size_t>(y * columns_ + x);
          const double reached = way[static_cast<std::size_t>(at)] + kWayCellM * std::hypot(dx, dy);
          if (is_free_[next] && reached < way[next] - 1e-9) {
            way[next] = reached;
            open.push_back(static_cast<int>(next));
          }
        }
      }
    }
    return way[static_cast<std::size_t>(index(to_m))];
  }

  const Eigen::AlignedBox2d& box_m() const { return box_; }

 private:
  int index(const Eigen::Vector2d& point_m) const {
    const Eigen::Vector2d cell = (point_m - box_.min()) / kWayCellM;
    return static_cast<int>(cell.y()) * columns_ + static_cast<int>(cell.x());
  }

  Eigen::AlignedBox2d box_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<bool> is_free_;
};

/// Bytes of plain values, in one machine's order: a cache, not a format.
class CacheFile {
 public:
  explicit CacheFile(std::fstream& file) : file_(file) {}

  template <class Plain>
  void put(const Plain& plain) {
    file_.write(reinterpret_cast<const char*>(&plain), sizeof(plain));
  }
  template <class Plain>
  void get(Plain& plain) {
    file_.read(reinterpret_cast<char*>(&plain), sizeof(plain));
  }
  void put(const Pose2& pose) {
    put(pose.x_m());
    put(pose.y_m());
    put(pose.heading_rad());
  }
  void get(Pose2& pose) {
    double values[3];
    get(values);
    pose = Pose2(values[0], values[1], values[2]);
  }
  void put(const slam::StopReading& one) {
    put(one.mark.T_odom_robot);
    put(one.mark.path_m);
    put(one.mark.turn_rad);
    put(one.mark.turned_rad);
    put(one.mark.jumped_m);
    put(one.mark.jumped_rad);
    put(one.T_robot_sonar);
    put(one.range_m.value_or(-1.0));
  }
  void get(slam::StopReading& one) {
    get(one.mark.T_odom_robot);
    get(one.mark.path_m);
    get(one.mark.turn_rad);
    get(one.mark.turned_rad);
    get(one.mark.jumped_m);
    get(one.mark.jumped_rad);
    get(one.T_robot_sonar);
    double range_m = 0.0;
    get(range_m);
    one.range_m = range_m < 0.0 ? std::nullopt : std::optional(range_m);
  }
  void put(const team_map::SubmapContact& one) {
    put(one.T_odom_robot);
    put(one.left);
    put(one.right);
  }
  void get(team_map::SubmapContact& one) {
    get(one.T_odom_robot);
    get(one.left);
    get(one.right);
  }
  void put(const team_map::Submap& one) {
    put(one.index);
    put(one.begin_s);
    put(one.end_s);
    put(one.readings);
    put(one.T_odom_way);
    put(one.contacts);
  }
  void get(team_map::Submap& one) {
    get(one.index);
    get(one.begin_s);
    get(one.end_s);
    get(one.readings);
    get(one.T_odom_way);
    get(one.contacts);
  }
  void put(const RecordedStop& one) {
    put(one.end_s);
    put(one.T_map_submaps);
  }
  void get(RecordedStop& one) {
    get(one.end_s);
    get(one.T_map_submaps);
  }
  template <class Thing>
  void put(const std::vector<Thing>& things) {
    put(things.size());
    for (const Thing& thing : things) {
      put(thing);
    }
  }
  template <class Thing>
  void get(std::vector<Thing>& things) {
    std::size_t count = 0;
    get(count);
    things.resize(count);
    for (Thing& thing : things) {
      get(thing);
    }
  }

 private:
  std::fstream& file_;
};

void write(const TeamRecording& recording, const std::filesystem::path& path) {
  const std::filesystem::path partial = path.string() + ".part";
  {
    std::fstream file(partial, std::ios::out | std::ios::binary | std::ios::trunc);
    CacheFile cache(file);
    cache.put(recording.record.submaps);
    cache.put(recording.record.T_map_submaps);
    cache.put(recording.record.beam_half_angle_rad);
    cache.put(recording.record.body_radius_m);
    cache.put(recording.stops);
    cache.put(recording.T_world_start);
    cache.put(recording.T_world_submaps);
  }
  std::filesystem::rename(partial, path);
}

TeamRecording read(const std::filesystem::path& path) {
  TeamRecording recording;
  std::fstream file(path, std::ios::in | std::ios::binary);
  CacheFile cache(file);
  cache.get(recording.record.submaps);
  cache.get(recording.record.T_map_submaps);
  cache.get(recording.record.beam_half_angle_rad);
  cache.get(recording.record.body_radius_m);
  cache.get(recording.stops);
  cache.get(recording.T_world_start);
  cache.get(recording.T_world_submaps);
  return recording;
}

pipeline::RobotPipeline pipeline_for(const world::RobotParams& robot,
                                     const sensors::RobotGeometry& geometry) {
  mapping::SonarMapperParams sonar;
  sonar.surfaces.beam_half_angle_rad = robot.sonar.beam_half_angle_rad;
  mapping::ContactMapperParams contact;
  contact.body_radius_m = robot.body.radius_m;
  return pipeline::RobotPipeline(geometry, sonar, contact, slam::slam_by_name("multiscan").make());
}

exploration::Frontier frontier_for(const world::RobotParams& robot, std::size_t max_stops) {
  exploration::FrontierParams params;
  params.navigator.costs.robot_radius_m = robot.body.radius_m;
  params.max_stops = max_stops;
  return exploration::Frontier(params);
}

}  // namespace

team_map::RobotRecord TeamRecording::after(std::size_t stops_made) const {
  team_map::RobotRecord told = record;
  told.T_map_submaps =
      stops_made == 0 ? std::vector<Pose2>() : stops.at(stops_made - 1).T_map_submaps;
  told.submaps.resize(told.T_map_submaps.size());
  return told;
}

double TeamRecording::error_m(const geometry::Pose2& T_world_map,
                              const std::vector<geometry::Pose2>& T_map_submaps) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < T_map_submaps.size(); ++i) {
    sum += ((T_world_map * T_map_submaps[i]).position_m() - T_world_submaps[i].position_m())
               .squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(T_map_submaps.size()));
}

std::vector<Pose2> team_starts(const world::FloorPlan& plan,
                               std::size_t robots,
                               double path_m,
                               std::uint32_t seed) {
  constexpr int kTries = 100'000;
  const WayField field(plan);
  std::mt19937 random(seed);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Pose2> starts;
  for (int i = 0; i < kTries && starts.size() < robots; ++i) {
    if (i % 2000 == 1999) {
      starts.clear();  // The first ones leave no room for the others.
    }
    const double x_share = share();
    const double y_share = share();
    const double heading_rad = 2.0 * std::numbers::pi * share();
    const Eigen::Vector2d place_m =
        field.box_m().min() + Eigen::Vector2d(x_share, y_share).cwiseProduct(field.box_m().sizes());
    if (!plan.is_free(place_m) || plan.clearance_m(place_m) < kStartClearanceM) {
      continue;
    }
    bool is_apart = true;
    for (const Pose2& other : starts) {
      const double between_m = field.path_m(other.position_m(), place_m);
      is_apart = is_apart && between_m >= path_m && std::isfinite(between_m);
    }
    if (is_apart) {
      starts.emplace_back(place_m.x(), place_m.y(), heading_rad);
    }
  }
  if (starts.size() < robots) {
    throw std::runtime_error("no room for so many robots so far apart");
  }
  return starts;
}

TeamRecording record_offline(const world::FloorPlan& plan,
                             const world::RobotParams& robot,
                             const Pose2& T_world_start,
                             std::uint32_t seed,
                             std::size_t max_stops) {
  world::RobotWorld world(plan.starting_at(T_world_start), robot, seed);
  const auto geometry = assumed_geometry(robot);
  pipeline::RobotPipeline pipeline = pipeline_for(robot, geometry);
  team_map::SubmapRecorder recorder(geometry);
  pipeline::ObservationFork fork;
  fork.add(recorder);
  fork.add(pipeline);
  OfflineRobot offline_robot(world, geometry, fork);
  offline_robot.look_around_on_the_way();
  exploration::Frontier explorer = frontier_for(robot, max_stops);

  TeamRecording recording;
  recording.T_world_start = T_world_start;
  Pose2 T_world_stop;
  auto last = exploration::MotionResult::kReached;
  for (;;) {
    const auto motion = explorer.next(pipeline.snapshot(), last);
    if (std::holds_alternative<exploration::Finished>(motion)) {
      break;
    }
    const bool begins = std::holds_alternative<exploration::BeginScan>(motion);
    T_world_stop = begins ? world.T_world_robot() : T_world_stop;
    const std::size_t submaps = recorder.submaps().size();
    last = offline_robot.execute(motion);
    if (!std::holds_alternative<exploration::EndScan>(motion) ||
        recorder.submaps().size() == submaps) {
      continue;
    }
    const pipeline::Snapshot snapshot = pipeline.snapshot();
    if (snapshot.last_scan_fault != mapping::ScanFault::kNone) {
      recorder.drop_last();
      continue;
    }
    recording.T_world_submaps.push_back(T_world_stop);
    recording.stops.push_back({offline_robot.now_s(), team_map::T_map_submaps(snapshot)});
  }
  recording.record.submaps = recorder.submaps();
  recording.record.T_map_submaps = team_map::T_map_submaps(pipeline.snapshot());
  recording.record.beam_half_angle_rad = robot.sonar.beam_half_angle_rad;
  recording.record.body_radius_m = robot.body.radius_m;
  return recording;
}

std::vector<TeamRecording> team_recordings(const std::string& world,
                                           std::size_t robots,
                                           std::uint32_t seed,
                                           const std::filesystem::path& folder) {
  constexpr double kApartM = 2.0;
  const world::FloorPlan plan = bundled_room(world);
  const world::RobotParams robot = bundled_robot("uno_2wd");
  const std::vector<Pose2> starts = team_starts(plan, robots, kApartM, seed);
  std::filesystem::create_directories(folder);
  std::vector<TeamRecording> recordings;
  for (std::size_t i = 0; i < robots; ++i) {
    const std::string name = "robot" + std::to_string(i + 1);
    const std::filesystem::path path =
        folder / (world + "-" + std::to_string(robots) + "-" + std::to_string(seed) + "-" + name);
    if (!std::filesystem::exists(path)) {
      const auto own_seed = static_cast<std::uint32_t>(seed * 10 + i);
      write(record_offline(plan, robot, starts[i], own_seed, kMaxStops), path);
    }
    recordings.push_back(read(path));
    recordings.back().record.robot = name;
  }
  return recordings;
}

}  // namespace echomap::tests
