// SPDX-License-Identifier: MIT
#include "hil_mock/world/floor_plan_file.hpp"

#include <utility>

#include "host/files/nearest_word.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

Material read_material(const files::TomlReader& table, Material fallback) {
  if (!table.has("material")) {
    return fallback;
  }
  const std::string name = table.text("material");
  if (name != "smooth" && name != "rough") {
    table.fail("material",
               "unknown material '" + name + "'" + files::suggestion(name, {"smooth", "rough"}));
  }
  return name == "rough" ? Material::kRough : Material::kSmooth;
}

/// The truth map has a cell for every centimetre within.
constexpr double kFarthestCornerM = 100.0;

Outline read_outline(const files::TomlReader& table) {
  Outline outline;
  for (const auto& [x_m, y_m] : table.points("corners_m")) {
    outline.corners_m.emplace_back(x_m, y_m);
  }
  if (const auto fault = polygon_fault(outline.corners_m)) {
    table.fail("corners_m", *fault);
  }
  for (const Eigen::Vector2d& corner_m : outline.corners_m) {
    if (corner_m.cwiseAbs().maxCoeff() > kFarthestCornerM) {
      table.fail("corners_m", "a corner is more than 100 m away; corners are in metres");
    }
  }
  const auto count = static_cast<std::int64_t>(outline.corners_m.size());
  const Material material = read_material(table, Material::kSmooth);
  outline.materials.assign(outline.corners_m.size(), material);
  for (const files::TomlReader& side : table.tables("side")) {
    const std::int64_t index = side.integer("index");
    if (index < 0 || index >= count) {
      side.fail("index", "sides are numbered 0 to " + std::to_string(count - 1));
    }
    outline.materials[static_cast<std::size_t>(index)] = read_material(side, material);
  }
  return outline;
}

geometry::Pose2 read_start(const files::TomlReader& start) {
  return {start.number("x_m"), start.number("y_m"), geometry::radians(start.number("heading_deg"))};
}

}  // namespace

FloorPlan read_floor_plan(const files::TomlReader& file) {
  const std::string name = file.text("name");
  Outline room = read_outline(file.table("room"));
  std::vector<Outline> obstacles;
  for (const files::TomlReader& table : file.tables("obstacle")) {
    table.text_or("name", "");
    Outline obstacle = read_outline(table);
    if (!contains(room.corners_m, obstacle.corners_m)) {
      table.fail("corners_m", "the obstacle is not inside of the room");
    }
    obstacles.push_back(std::move(obstacle));
  }
  const files::TomlReader start = file.table("start");
  const geometry::Pose2 T_world_start = read_start(start);
  file.reject_unknown_keys();
  try {
    return {name, std::move(room), std::move(obstacles), T_world_start};
  } catch (const std::invalid_argument& fault) {
    start.fail("x_m", fault.what());
  }
}

}  // namespace echomap::world
