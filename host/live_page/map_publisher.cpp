// SPDX-License-Identifier: MIT
#include "host/live_page/map_publisher.hpp"

#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/geometry/angle.hpp"
#include "host/live_page/message_encoding.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/mapping/room_outline.hpp"

namespace echomap::live_page {
namespace {

using mapping::GridTile;
using nlohmann::ordered_json;

/// Of a path, points nearer than this are left out.
constexpr double kPointsApartM = 0.03;

std::int32_t tile_of(std::int32_t cell) { return cell >> mapping::kTileBits; }

ordered_json pair_of(const Eigen::Vector2d& point_m) { return {point_m.x(), point_m.y()}; }

ordered_json walls_of(const mapping::SonarFeatures& features) {
  auto walls = ordered_json::array();
  for (const geometry::Segment& wall : features.walls) {
    walls.push_back({pair_of(wall.from_m), pair_of(wall.to_m)});
  }
  return walls;
}

ordered_json cylinders_of(const mapping::SonarFeatures& features) {
  auto cylinders = ordered_json::array();
  for (const mapping::FittedCircle& circle : features.circles) {
    cylinders.push_back({{"at", pair_of(circle.center_m)}, {"radius_m", circle.radius_m}});
  }
  return cylinders;
}

ordered_json outline_of(const pipeline::Snapshot& snapshot) {
  auto points = ordered_json::array();
  const auto outline =
      mapping::room_outline(mapping::rasterize(*snapshot.grid), *snapshot.features);
  if (outline) {
    for (const Eigen::Vector2d& vertex_m : outline->outline_m()) {
      points.push_back(pair_of(vertex_m));
    }
  }
  return points;
}

ordered_json sweep_of(const mapping::Scan& scan) {
  if (scan.empty()) {
    return nullptr;
  }
  const geometry::Pose2& from = scan.front().T_map_sonar;
  auto bearings = ordered_json::array();
  auto ranges = ordered_json::array();
  for (const mapping::PlacedReading& reading : scan) {
    bearings.push_back(reading.T_map_sonar.heading_rad());
    ranges.push_back(reading.range_m ? ordered_json(*reading.range_m) : ordered_json());
  }
  return {{"origin", {from.x_m(), from.y_m(), from.heading_rad()}},
          {"bearings", bearings},
          {"ranges_m", ranges}};
}

}  // namespace

void MapPublisher::look_at(double time_s, const pipeline::Snapshot& snapshot) {
  const bool is_new = snapshot.grid != grid_ || snapshot.grid->revision() != revision_;
  const bool is_stop = snapshot.last_scan != last_scan_;
  if (!is_new && !is_stop) {
    return;
  }
  grid_ = snapshot.grid;
  last_scan_ = snapshot.last_scan;
  look_at(time_s, *snapshot.grid);
  if (is_stop) {
    add_trail(time_s, snapshot);
    add_room(time_s, snapshot);
  }
}

void MapPublisher::look_at(double time_s, const mapping::OccupancyGrid& grid) {
  revision_ = grid.revision();
  ++changes_;
  add_tiles(time_s, grid);
}

void MapPublisher::begin_new_map(double time_s) {
  sent_.clear();
  grid_.reset();
  last_scan_.reset();
  history_->add(new_map_message(time_s));
}

/// The grid of a stop is made anew, with evidence in other tiles or none: those that were sent and
/// are gone are sent empty.
void MapPublisher::add_tiles(double time_s, const mapping::OccupancyGrid& grid) {
  static const GridTile kEmpty;
  const mapping::CellBounds& bounds = grid.bounds();
  if (!bounds.empty()) {
    for (std::int32_t y = tile_of(bounds.min.y); y <= tile_of(bounds.max.y); ++y) {
      for (std::int32_t x = tile_of(bounds.min.x); x <= tile_of(bounds.max.x); ++x) {
        if (grid.find_tile({x, y}) != nullptr) {
          sent_.try_emplace({x, y}, nullptr);
        }
      }
    }
  }
  for (auto& [place, sent] : sent_) {
    const geometry::CellIndex tile{place.first, place.second};
    const GridTile* found = grid.find_tile(tile);
    const GridTile& cells = found != nullptr ? *found : kEmpty;
    if (!sent || sent->cells != cells.cells) {
      sent = std::make_unique<GridTile>(cells);
      history_->add(tile_message(time_s, tile, cells));
    }
  }
}

void MapPublisher::add_trail(double time_s, const pipeline::Snapshot& snapshot) {
  std::vector<Eigen::Vector2d> points_m;
  for (const pipeline::StampedPose& pose : *snapshot.trajectory) {
    const Eigen::Vector2d& here_m = pose.T_map_robot.position_m();
    if (points_m.empty() || (points_m.back() - here_m).norm() >= kPointsApartM) {
      points_m.push_back(here_m);
    }
  }
  history_->add(trail_message(time_s, points_m));
}

void MapPublisher::add_room(double time_s, const pipeline::Snapshot& snapshot) {
  ordered_json room{{"walls", walls_of(*snapshot.features)},
                    {"outline", outline_of(snapshot)},
                    {"cylinders", cylinders_of(*snapshot.features)},
                    {"sweep", snapshot.last_scan ? sweep_of(*snapshot.last_scan) : nullptr}};
  history_->add(json_message(MessageKind::kRoom, time_s, room));
}

}  // namespace echomap::live_page
