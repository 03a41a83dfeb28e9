// SPDX-License-Identifier: MIT
#include "hil_mock/world/floor_plan_file.hpp"

#include <utility>

#include "hil_mock/world/toml_values.hpp"
#include "host/files/nearest_word.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

Material read_material(const files::TomlReader& table, Material fallback) {
  if (!table.has("material")) {
    return fallback;
  }
  const std::string name = table.text("material");
  for (const Material material : {Material::kSmooth, Material::kRough, Material::kGlass}) {
    if (name == name_of(material)) {
      return material;
    }
  }
  table.fail(
      "material",
      "unknown material '" + name + "'" + files::suggestion(name, {"smooth", "rough", "glass"}));
}

Surface read_surface(const files::TomlReader& table, const Surface& fallback) {
  return {read_material(table, fallback.material),
          within(table, "reflectance", fallback.reflectance, 1.0)};
}

/// The truth map has a cell for every centimetre within.
constexpr double kMaxCornerM = 100.0;
/// Lead takes 125 of what caesium 137 sends out.
constexpr double kMaxAttenuationPerM = 1000.0;
/// More a second than any tube counts, and brighter than the sun.
constexpr double kMaxBackground = 1e5;
/// No run is longer.
constexpr double kLatestStartS = 1e9;

Polygon read_corners(const files::TomlReader& table) {
  Polygon corners_m;
  for (const auto& [x_m, y_m] : table.points("corners_m")) {
    corners_m.emplace_back(x_m, y_m);
  }
  if (const auto fault = geometry::polygon_fault(corners_m)) {
    table.fail("corners_m", *fault);
  }
  for (const Eigen::Vector2d& corner_m : corners_m) {
    if (corner_m.cwiseAbs().maxCoeff() > kMaxCornerM) {
      table.fail("corners_m", "a corner is more than 100 m away; corners are in metres");
    }
  }
  return corners_m;
}

Outline read_outline(const files::TomlReader& table) {
  Outline outline;
  outline.attenuation_per_m =
      within(table, "attenuation_per_m", outline.attenuation_per_m, kMaxAttenuationPerM);
  outline.corners_m = read_corners(table);
  const auto count = static_cast<std::int64_t>(outline.corners_m.size());
  const Surface surface = read_surface(table, {});
  outline.surfaces.assign(outline.corners_m.size(), surface);
  for (const files::TomlReader& side : table.tables("side")) {
    const std::int64_t index = side.integer("index");
    if (index < 0 || index >= count) {
      side.fail("index", "sides are numbered 0 to " + std::to_string(count - 1));
    }
    outline.surfaces[static_cast<std::size_t>(index)] = read_surface(side, surface);
  }
  return outline;
}

VirtualWall read_virtual_wall(const files::TomlReader& table) {
  VirtualWall beam;
  beam.origin_m = {table.number("x_m"), table.number("y_m")};
  beam.heading_rad = geometry::radians(table.number("heading_deg"));
  beam.length_m = positive(table, "length_m");
  beam.beam_half_angle_rad = geometry::radians(positive(table, "beam_half_angle_deg"));
  return beam;
}

PersonParams read_person(const files::TomlReader& table) {
  PersonParams person;
  table.text_or("name", "");
  for (const auto& [x_m, y_m] : table.points("path_m")) {
    person.path_m.emplace_back(x_m, y_m);
  }
  if (person.path_m.size() < 2) {
    table.fail("path_m", "a path takes two points or more");
  }
  for (const Eigen::Vector2d& point_m : person.path_m) {
    if (!(point_m.cwiseAbs().maxCoeff() <= kMaxCornerM)) {
      table.fail("path_m", "a point is more than 100 m away; points are in metres");
    }
  }
  person.speed_m_per_s = positive(table, "speed_m_per_s");
  person.radius_m = positive(table, "radius_m");
  person.start_s = within(table, "start_s", 0.0, kLatestStartS);
  return person;
}

Source read_source(const files::TomlReader& table) {
  Source source;
  table.text_or("name", "");
  const std::string kind = table.text_or("kind", name_of(SourceKind::kRadiation));
  if (kind == name_of(SourceKind::kLight)) {
    source.kind = SourceKind::kLight;
  } else if (kind != name_of(SourceKind::kRadiation)) {
    table.fail(
        "kind",
        "no source sends out '" + kind + "'" + files::suggestion(kind, {"radiation", "light"}));
  }
  source.position_m = {table.number("x_m"), table.number("y_m")};
  source.strength = positive(table, "strength");
  source.height_m = table.has("height_m") ? positive(table, "height_m") : source.height_m;
  return source;
}

void read_sources(const files::TomlReader& file, const Polygon& room_m, FloorMarks& marks) {
  for (const files::TomlReader& table : file.tables("source")) {
    marks.sources.push_back(read_source(table));
    if (!geometry::contains(room_m, marks.sources.back().position_m)) {
      table.fail("x_m", "the source is not inside of the room");
    }
  }
  marks.backgrounds.radiation_per_s = within(file, "background_per_s", 0.0, kMaxBackground);
  marks.backgrounds.light_lux = within(file, "ambient_lux", 0.0, kMaxBackground);
}

FloorMarks read_marks(const files::TomlReader& file, const Polygon& room_m) {
  FloorMarks marks;
  for (const files::TomlReader& table : file.tables("hole")) {
    table.text_or("name", "");
    marks.holes_m.push_back(read_corners(table));
    if (!geometry::contains(room_m, marks.holes_m.back())) {
      table.fail("corners_m", "the hole is not inside of the room");
    }
  }
  for (const files::TomlReader& table : file.tables("virtual_wall")) {
    marks.virtual_walls.push_back(read_virtual_wall(table));
    if (!geometry::contains(room_m, marks.virtual_walls.back().origin_m) &&
        geometry::distance_to_sides_m(room_m, marks.virtual_walls.back().origin_m) > 0.0) {
      table.fail("x_m", "the beam begins outside of the room");
    }
  }
  for (const files::TomlReader& table : file.tables("person")) {
    marks.people.push_back(read_person(table));
  }
  read_sources(file, room_m, marks);
  return marks;
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
    if (!geometry::contains(room.corners_m, obstacle.corners_m)) {
      table.fail("corners_m", "the obstacle is not inside of the room");
    }
    obstacles.push_back(std::move(obstacle));
  }
  FloorMarks marks = read_marks(file, room.corners_m);
  const files::TomlReader start = file.table("start");
  const geometry::Pose2 T_world_start = read_start(start);
  file.reject_unknown_keys();
  try {
    return {name, std::move(room), std::move(obstacles), T_world_start, std::move(marks)};
  } catch (const std::invalid_argument& fault) {
    start.fail("x_m", fault.what());
  }
}

}  // namespace echomap::world
