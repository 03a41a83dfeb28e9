// SPDX-License-Identifier: MIT
#include "host/papers/epuck_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "hil_mock/world/noise.hpp"
#include "host/mapping/contact_mapper.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/models/occupied_sector.hpp"
#include "host/papers/epuck_ring.hpp"
#include "host/papers/room_floor.hpp"

namespace echomap::papers {

namespace {

using geometry::CellIndex;
using geometry::Pose2;

constexpr double kGridCellM = 0.001;
constexpr double kCentilogits = 100.0;

/// Beside the walls and round both blocks at 5 to 6 cm, and lanes through the rest.
const std::vector<Eigen::Vector2d> lap_points_m = {
    {0.05, 0.05}, {0.75, 0.05}, {0.75, 0.55}, {0.05, 0.55}, {0.05, 0.05}, {0.39, 0.05},
    {0.39, 0.26}, {0.63, 0.26}, {0.63, 0.05}, {0.69, 0.05}, {0.69, 0.34}, {0.44, 0.34},
    {0.44, 0.55}, {0.71, 0.55}, {0.71, 0.34}, {0.30, 0.34}, {0.30, 0.51}, {0.09, 0.51},
    {0.09, 0.42}, {0.38, 0.42}, {0.38, 0.20}, {0.16, 0.20}, {0.16, 0.53}, {0.23, 0.53},
    {0.23, 0.08}, {0.33, 0.08}, {0.33, 0.32}, {0.09, 0.32}, {0.09, 0.10}, {0.36, 0.10}};

using Triangle = std::array<Eigen::Vector2d, 3>;

/// What of a triangle lies on a line y = const: from x to x; the second is before the first where
/// nothing does.
std::pair<double, double> span_of(const Triangle& triangle, double y_m) {
  std::pair<double, double> span(std::numeric_limits<double>::max(),
                                 std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d& a_m = triangle[i];
    const Eigen::Vector2d& b_m = triangle[(i + 1) % 3];
    if ((a_m.y() <= y_m) != (b_m.y() <= y_m)) {
      const double x_m = a_m.x() + (y_m - a_m.y()) / (b_m.y() - a_m.y()) * (b_m.x() - a_m.x());
      span = {std::min(span.first, x_m), std::max(span.second, x_m)};
    }
  }
  return span;
}

/// Algorithm 2 of Mahmood and Ridao 2017: adds the inverse model's evidence, l - l_0, to each cell
/// of the sensor's field. Neighbours of the ring look 32 degrees apart, so that no two of its beams
/// hold one cell and line 5 of Algorithm 3 has nothing to choose.
class SectorGrid {
 public:
  explicit SectorGrid(const EpuckGridParams& params)
      : model_(model_params(params)), slope_(std::tan(0.5 * params.beam_width_rad)) {}

  void insert(const models::SensorReading& reading, const Pose2& T_world_sensor) {
    const double reach_m = model_.reach_m(reading);
    const Triangle around = {T_world_sensor.position_m(),
                             T_world_sensor * Eigen::Vector2d(reach_m, -slope_ * reach_m),
                             T_world_sensor * Eigen::Vector2d(reach_m, slope_ * reach_m)};
    const Pose2 T_sensor_world = T_world_sensor.inverse();
    const auto [low, high] = std::minmax({around[0].y(), around[1].y(), around[2].y()});
    const std::int32_t last_row = grid_.cell_at({0.0, high}).y;
    for (CellIndex cell = grid_.cell_at({0.0, low}); cell.y <= last_row; ++cell.y) {
      const auto [from_m, to_m] = span_of(around, grid_.center_m(cell).y());
      const std::int32_t last = grid_.cell_at({to_m, 0.0}).x;
      for (cell.x = grid_.cell_at({from_m, 0.0}).x; cell.x <= last; ++cell.x) {
        const Eigen::Vector2d seen_m = T_sensor_world * grid_.center_m(cell);
        const double log_odds = model_.evidence(reading, models::polar_point(seen_m));
        grid_.add(cell, static_cast<int>(std::lround(kCentilogits * log_odds)));
      }
    }
  }

  const mapping::OccupancyGrid& grid() const { return grid_; }

 private:
  static models::OccupiedSectorParams model_params(const EpuckGridParams& params) {
    models::OccupiedSectorParams model;
    model.thickness_m = params.thickness_m;
    model.beam_width_rad = params.beam_width_rad;
    model.max_range_m = kEpuckReachM;
    model.occupied_log_odds = params.occupied_log_odds;
    model.free_log_odds = params.free_log_odds;
    return model;
  }
  static mapping::OccupancyGridParams grid_params() {
    mapping::OccupancyGridParams params;
    params.resolution_m = kGridCellM;
    params.free_threshold = 0.45;
    params.occupied_threshold = 0.55;
    return params;
  }
  models::OccupiedSector model_;
  double slope_;
  mapping::OccupancyGrid grid_{grid_params()};
};

using Readings = std::vector<localization::RangeReading>;

/// Calls `visit` with every round of readings and where the camera saw the robot then.
template <typename Visitor>
void drive_laps(const world::FloorPlan& field,
                const EpuckGridParams& params,
                std::uint32_t seed,
                Visitor&& visit) {
  EpuckRing ring(field, seed);
  world::NoiseStream camera(seed, world::NoisePurpose::kBody);
  for (int lap = 0; lap < params.laps; ++lap) {
    for (const Pose2& T_world_robot : epuck_lap(PathSteps{}, camera.uniform())) {
      const double x_m = params.position_stddev_m * camera.normal();
      const double y_m = params.position_stddev_m * camera.normal();
      const double heading_rad = params.heading_stddev_rad * camera.normal();
      const Pose2 T_world_believed(T_world_robot.x_m() + x_m,
                                   T_world_robot.y_m() + y_m,
                                   T_world_robot.heading_rad() + heading_rad);
      visit(T_world_believed, ring.read(T_world_robot));
    }
  }
}

}  // namespace

const world::FloorPlan& epuck_field() {
  static const world::FloorPlan plan = bundled_room("epuck_field");
  return plan;
}

std::vector<Pose2> epuck_lap(const PathSteps& steps, double phase) {
  return drive_path(lap_points_m, steps, phase);
}

mapping::RasterMap map_epuck_field(const world::FloorPlan& field,
                                   const EpuckGridParams& params,
                                   std::uint32_t seed) {
  SectorGrid grid(params);
  drive_laps(field, params, seed, [&](const Pose2& T_world_robot, const Readings& readings) {
    for (const localization::RangeReading& reading : readings) {
      if (reading.range_m || params.silence_is_free) {
        grid.insert({reading.range_m}, T_world_robot * reading.T_robot_sensor);
      }
    }
  });
  return mapping::rasterize(grid.grid());
}

mapping::RasterMap map_epuck_contacts(const world::FloorPlan& field, std::uint32_t seed) {
  constexpr double kContactCellM = 0.01;
  mapping::ContactMapperParams params;
  params.body_radius_m = kEpuckRadiusM;
  params.infrared_reach_m = kEpuckReachM;
  params.T_robot_infrared = EpuckRing(field, seed).places();
  mapping::OccupancyGridParams grid;
  grid.resolution_m = kContactCellM;
  mapping::ContactMapper mapper(params, grid);
  drive_laps(field, {}, seed, [&](const Pose2& T_world_robot, const Readings& readings) {
    std::vector<std::optional<double>> range_m;
    for (const localization::RangeReading& reading : readings) {
      range_m.push_back(reading.range_m);
    }
    mapper.pass_over(T_world_robot);
    mapper.add_ranges(T_world_robot, range_m);
  });
  return mapping::rasterize(mapper.grid());
}

}  // namespace echomap::papers
