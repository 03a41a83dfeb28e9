// SPDX-License-Identifier: MIT
#include "host/exports/map_json.hpp"

#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"

namespace echomap::exports {
namespace {

using MapJson = nlohmann::ordered_json;

constexpr const char* kFrame =
    "map: x ahead of the robot at its start, y to its left, headings counter-clockwise from x";

/// A micrometre, a microradian or a microsecond.
double to_millionths(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

MapJson json_of(const Eigen::Vector2d& point_m) {
  return MapJson::array({to_millionths(point_m.x()), to_millionths(point_m.y())});
}

MapJson json_of(const geometry::Pose2& pose) {
  return {{"x_m", to_millionths(pose.x_m())},
          {"y_m", to_millionths(pose.y_m())},
          {"heading_rad", to_millionths(pose.heading_rad())}};
}

MapJson json_of(const geometry::Polygon& ring_m) {
  MapJson ring = MapJson::array();
  for (const Eigen::Vector2d& corner_m : ring_m) {
    ring.push_back(json_of(corner_m));
  }
  return ring;
}

MapJson json_of(const std::optional<mapping::PolygonMap>& outline) {
  if (!outline) {
    return nullptr;
  }
  MapJson holes = MapJson::array();
  for (const geometry::Polygon& hole_m : outline->holes_m()) {
    holes.push_back(json_of(hole_m));
  }
  return {{"corners_m", json_of(outline->outline_m())},
          {"holes_m", std::move(holes)},
          {"area_m2", to_millionths(outline->area_m2())}};
}

MapJson walls_of(const mapping::SonarFeatures& features) {
  MapJson walls = MapJson::array();
  for (const geometry::Segment& wall : features.walls) {
    walls.push_back({{"from_m", json_of(wall.from_m)}, {"to_m", json_of(wall.to_m)}});
  }
  return walls;
}

MapJson obstacles_of(const mapping::SonarFeatures& features) {
  MapJson obstacles = MapJson::array();
  for (const mapping::FittedCircle& circle : features.circles) {
    obstacles.push_back(
        {{"center_m", json_of(circle.center_m)}, {"radius_m", to_millionths(circle.radius_m)}});
  }
  return obstacles;
}

MapJson stops_of(const std::vector<mapping::Scan>& scans) {
  MapJson stops = MapJson::array();
  for (const mapping::Scan& scan : scans) {
    if (!scan.empty()) {
      MapJson stop = json_of(scan.front().T_map_robot);
      stop["readings"] = scan.size();
      stops.push_back(std::move(stop));
    }
  }
  return stops;
}

/// The top row first.
std::vector<MapJson> cell_rows(const mapping::OccupancyGrid& grid,
                               const mapping::CellBounds& bounds) {
  std::vector<MapJson> rows;
  rows.reserve(static_cast<std::size_t>(bounds.rows()));
  for (std::int32_t y = bounds.max.y; y >= bounds.min.y; --y) {
    MapJson row = MapJson::array();
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      const std::optional<double> probability = grid.probability({x, y});
      row.push_back(probability ? MapJson(std::round(*probability * 1e3) / 1e3) : MapJson());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<MapJson> pose_rows(const std::vector<pipeline::StampedPose>& trajectory) {
  std::vector<MapJson> rows;
  rows.reserve(trajectory.size());
  for (const auto& [stamp, pose] : trajectory) {
    const std::chrono::duration<double> since_start = stamp.time_since_epoch();
    rows.push_back(MapJson::array({to_millionths(since_start.count()),
                                   to_millionths(pose.x_m()),
                                   to_millionths(pose.y_m()),
                                   to_millionths(pose.heading_rad())}));
  }
  return rows;
}

/// An object with a key a line, and the rows of long values a line each.
class JsonLines {
 public:
  void add(const char* key, const MapJson& value) {
    begin(key);
    text_ += value.dump();
  }
  void add_rows(const char* key, const std::vector<MapJson>& rows) {
    begin(key);
    text_ += '[';
    for (const MapJson& row : rows) {
      text_ += text_.back() == '[' ? "\n    " : ",\n    ";
      text_ += row.dump();
    }
    text_ += rows.empty() ? "]" : "\n  ]";
  }
  std::string finish() { return std::move(text_) + "\n}\n"; }

 private:
  void begin(const char* key) {
    text_ += text_.empty() ? "{\n  \"" : ",\n  \"";
    text_.append(key).append("\": ");
  }

  std::string text_;
};

void add_grid(const mapping::OccupancyGrid& grid, JsonLines& lines) {
  const mapping::CellBounds bounds =
      grid.bounds().empty() ? mapping::CellBounds{{0, 0}, {0, 0}} : grid.bounds();
  lines.add("resolution_m", grid.resolution_m());
  lines.add("origin_m",
            json_of(Eigen::Vector2d(bounds.min.x * grid.resolution_m(),
                                    bounds.min.y * grid.resolution_m())));
  lines.add("rows", bounds.rows());
  lines.add("columns", bounds.columns());
  lines.add_rows("cells", cell_rows(grid, bounds));
}

}  // namespace

void write_map_json(const std::filesystem::path& path,
                    const pipeline::Snapshot& snapshot,
                    const std::optional<mapping::PolygonMap>& outline) {
  const auto& trajectory = *snapshot.trajectory;
  JsonLines lines;
  lines.add("format", "echomap-map");
  lines.add("version", kMapJsonVersion);
  lines.add("frame", kFrame);
  lines.add("units", {{"length", "m"}, {"angle", "rad"}, {"time", "s of the robot's clock"}});
  add_grid(*snapshot.grid, lines);
  lines.add("outline", json_of(outline));
  lines.add("walls", walls_of(*snapshot.features));
  lines.add("obstacles", obstacles_of(*snapshot.features));
  lines.add("start", trajectory.empty() ? MapJson() : json_of(trajectory.front().T_map_robot));
  lines.add("robot", json_of(snapshot.latest.T_map_robot));
  lines.add("stops", stops_of(*snapshot.scans));
  lines.add("free_area_m2",
            to_millionths(mapping::newly_free_area_m2(mapping::OccupancyGrid(), *snapshot.grid)));
  lines.add("trajectory_columns", {"t_s", "x_m", "y_m", "heading_rad"});
  lines.add_rows("trajectory", pose_rows(trajectory));
  files::write_text_file(path, lines.finish());
}

}  // namespace echomap::exports
