// SPDX-License-Identifier: MIT
#include "hil_mock/world/source_field.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "hil_mock/world/floor_plan.hpp"

namespace echomap::world {
namespace {

/// Less of a solid than this is its skin, on which the way may end.
constexpr double kSkinM = 1e-6;

/// How much of a straight way is inside of a polygon.
double inside_m(const Polygon& polygon_m,
                const Eigen::Vector2d& from_m,
                const Eigen::Vector2d& to_m) {
  const double length_m = (to_m - from_m).norm();
  if (length_m < kSkinM) {
    return 0.0;
  }
  const Eigen::Vector2d direction = (to_m - from_m) / length_m;
  std::vector<double> cuts_m{0.0, length_m};
  for (std::size_t i = 0; i < polygon_m.size(); ++i) {
    const auto at_m = geometry::ray_distance_m(from_m, direction, geometry::side(polygon_m, i));
    if (at_m && *at_m < length_m) {
      cuts_m.push_back(*at_m);
    }
  }
  std::sort(cuts_m.begin(), cuts_m.end());
  double sum_m = 0.0;
  for (std::size_t i = 1; i < cuts_m.size(); ++i) {
    const double piece_m = cuts_m[i] - cuts_m[i - 1];
    const Eigen::Vector2d middle_m = from_m + 0.5 * (cuts_m[i] + cuts_m[i - 1]) * direction;
    if (piece_m > kSkinM && geometry::contains(polygon_m, middle_m)) {
      sum_m += piece_m;
    }
  }
  return sum_m;
}

double solid_m(const FloorPlan& plan, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  double sum_m = (to_m - from_m).norm() - inside_m(plan.room_m(), from_m, to_m);
  for (const Polygon& obstacle_m : plan.obstacles_m()) {
    sum_m += inside_m(obstacle_m, from_m, to_m);
  }
  return sum_m;
}

/// Share that comes through.
double transmission(const FloorPlan& plan, const Source& source, const Eigen::Vector2d& point_m) {
  if (source.kind == SourceKind::kLight) {
    return solid_m(plan, source.position_m, point_m) > kSkinM ? 0.0 : 1.0;
  }
  return std::exp(-optical_depth(plan, source.position_m, point_m));
}

Source parse_source(const std::string& text) {
  Source source;
  std::istringstream numbers(text);
  char first_comma = ' ';
  char second_comma = ' ';
  numbers >> source.position_m.x() >> first_comma >> source.position_m.y() >> second_comma >>
      source.strength;
  const bool is_read = !numbers.fail() && (numbers >> std::ws).eof();
  if (!is_read || first_comma != ',' || second_comma != ',' || source.strength <= 0.0) {
    throw std::invalid_argument("'" + text + "' is no source: X,Y,STRENGTH, as 3.5,2,20, or none");
  }
  return source;
}

}  // namespace

std::string_view name_of(SourceKind kind) {
  return kind == SourceKind::kLight ? "light" : "radiation";
}

double optical_depth(const FloorPlan& plan,
                     const Eigen::Vector2d& from_m,
                     const Eigen::Vector2d& to_m) {
  const double outside_m = (to_m - from_m).norm() - inside_m(plan.room_m(), from_m, to_m);
  double depth = outside_m * plan.room_attenuation_per_m();
  for (std::size_t i = 0; i < plan.obstacles_m().size(); ++i) {
    depth += plan.attenuations_per_m()[i] * inside_m(plan.obstacles_m()[i], from_m, to_m);
  }
  return depth;
}

double field_at(const FloorPlan& plan, SourceKind kind, const Eigen::Vector2d& point_m) {
  const Backgrounds& backgrounds = plan.backgrounds();
  double sum = kind == SourceKind::kLight ? backgrounds.light_lux : backgrounds.radiation_per_s;
  for (const Source& source : plan.sources()) {
    if (source.kind == kind) {
      const double distance_m2 =
          (point_m - source.position_m).squaredNorm() + source.height_m * source.height_m;
      sum += source.strength / distance_m2 * transmission(plan, source, point_m);
    }
  }
  return sum;
}

std::vector<Source> parse_sources(const std::vector<std::string>& texts) {
  std::vector<Source> sources;
  if (texts == std::vector<std::string>{"none"}) {
    return sources;
  }
  for (const std::string& text : texts) {
    sources.push_back(parse_source(text));
  }
  return sources;
}

}  // namespace echomap::world
