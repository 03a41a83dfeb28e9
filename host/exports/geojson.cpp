// SPDX-License-Identifier: MIT
#include "host/exports/geojson.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"

namespace echomap::exports {
namespace {

using Json = nlohmann::ordered_json;
using geometry::Polygon;

constexpr const char* kCrs =
    "local: metres in the map frame, x ahead of the robot at its start and y to its left; not "
    "longitude and latitude";

Json position_of(const Eigen::Vector2d& point_m) { return Json::array({point_m.x(), point_m.y()}); }

Eigen::Vector2d point_of(const Json& position) {
  return {position.at(0).get<double>(), position.at(1).get<double>()};
}

/// GeoJSON repeats the first corner at the end.
Json ring_of(const Polygon& polygon) {
  Json ring = Json::array();
  for (const Eigen::Vector2d& corner_m : polygon) {
    ring.push_back(position_of(corner_m));
  }
  ring.push_back(position_of(polygon.front()));
  return ring;
}

Polygon polygon_of(const Json& ring) {
  Polygon polygon;
  for (const Json& position : ring) {
    polygon.push_back(point_of(position));
  }
  if (polygon.size() > 1 && polygon.front() == polygon.back()) {
    polygon.pop_back();
  }
  return polygon;
}

Json feature(Json properties, const char* type, Json coordinates) {
  properties["crs"] = kCrs;
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

Json outline_feature(const mapping::PolygonMap& map, const std::vector<bool>& is_open) {
  Json corners = Json::array();
  for (std::size_t i = 0; i < map.outline_m().size(); ++i) {
    const auto kind = mapping::corner_kind(map.outline_m(), i);
    corners.push_back(kind == mapping::CornerKind::kReflex ? "reflex" : "non-reflex");
  }
  Json rings = Json::array({ring_of(map.outline_m())});
  for (const Polygon& hole_m : map.holes_m()) {
    rings.push_back(ring_of(hole_m));
  }
  Json properties{{"name", "outline"}, {"area_m2", map.area_m2()}, {"corners", corners}};
  for (const bool open : is_open) {
    properties["sides"].push_back(open ? "open" : "wall");
  }
  return feature(std::move(properties), "Polygon", rings);
}

void write_features(const std::filesystem::path& path, Json features) {
  const Json collection{{"type", "FeatureCollection"}, {"features", std::move(features)}};
  files::write_text_file(path, collection.dump(2) + "\n");
}

/// What `read` makes of the geometries in the text of a file.
template <class Read>
auto parse_geometries(const std::string& text, const std::string& file, const Read& read) {
  try {
    const Json collection = Json::parse(text);
    std::vector<Json> shapes;
    for (const Json& one : collection.at("features")) {
      shapes.push_back(one.at("geometry"));
    }
    return read(shapes);
  } catch (const nlohmann::json::exception& error) {
    throw files::FileError(file + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    throw files::FileError(file + ": " + error.what());
  }
}

std::optional<mapping::PolygonMap> first_polygon(const std::vector<Json>& shapes) {
  for (const Json& shape : shapes) {
    if (shape.at("type") == "Polygon") {
      std::vector<Polygon> rings;
      for (const Json& ring : shape.at("coordinates")) {
        rings.push_back(polygon_of(ring));
      }
      if (rings.empty()) {
        throw std::invalid_argument("a Polygon without rings");
      }
      Polygon outline_m = rings.front();
      rings.erase(rings.begin());
      return mapping::PolygonMap(std::move(outline_m), std::move(rings));
    }
  }
  return std::nullopt;
}

std::vector<geometry::Segment> all_pieces(const std::vector<Json>& shapes) {
  std::vector<geometry::Segment> pieces;
  for (const Json& shape : shapes) {
    if (shape.at("type") != "LineString") {
      continue;
    }
    const Json& positions = shape.at("coordinates");
    for (std::size_t i = 1; i < positions.size(); ++i) {
      pieces.push_back({point_of(positions.at(i - 1)), point_of(positions.at(i))});
    }
  }
  return pieces;
}

}  // namespace

void write_outline_geojson(const std::filesystem::path& path,
                           const std::optional<mapping::PolygonMap>& map,
                           const std::vector<bool>& is_open) {
  Json features = Json::array();
  if (map) {
    features.push_back(outline_feature(*map, is_open));
  }
  write_features(path, std::move(features));
}

std::optional<mapping::PolygonMap> read_outline_geojson(const std::filesystem::path& path) {
  return parse_outline_geojson(files::read_text_file(path), path.string());
}

std::optional<mapping::PolygonMap> parse_outline_geojson(const std::string& text,
                                                         const std::string& file) {
  return parse_geometries(text, file, first_polygon);
}

std::vector<geometry::Segment> read_line_strings(const std::filesystem::path& path) {
  return parse_geometries(files::read_text_file(path), path.string(), all_pieces);
}

}  // namespace echomap::exports
