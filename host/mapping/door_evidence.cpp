// SPDX-License-Identifier: MIT
#include "host/mapping/door_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/square.hpp"

namespace echomap::mapping {

using Piece = MatchedWall::Piece;

namespace {

bool has_foot_in(const MatchedWall& wall, const Piece& door) {
  return std::ranges::any_of(wall.echoes, [&](const FootEcho& echo) {
    return echo.foot_m > door.from_m && echo.foot_m < door.to_m;
  });
}

double overlap_m(const Piece& one, double from_m, double to_m) {
  return std::min(one.to_m, to_m) - std::max(one.from_m, from_m);
}

/// Student's t but for a constant: an echo that neither a wall nor a door explains tells little.
double log_likelihood(double error_m, const DoorEvidenceParams& params) {
  const double dof = params.range_degrees_of_freedom;
  return -0.5 * (dof + 1.0) * std::log1p(geometry::square(error_m / params.range_scale_m) / dof);
}

}  // namespace

double wall_log_odds(const MatchedWall& wall, const Piece& door, const DoorEvidenceParams& params) {
  double log_odds = 0.0;
  for (const FootEcho& echo : wall.echoes) {
    if (echo.distance_m <= params.sure_distance_m &&
        overlap_m(door, echo.foot_m - echo.right_m, echo.foot_m + echo.left_m) >
            params.max_sure_m) {
      return std::numeric_limits<double>::infinity();
    }
    const double inside_m = std::min(echo.foot_m - door.from_m, door.to_m - echo.foot_m);
    if (inside_m > 0.0) {
      const double frame_m = std::hypot(inside_m, echo.distance_m) - echo.distance_m;
      log_odds +=
          log_likelihood(echo.longer_m, params) - log_likelihood(echo.longer_m - frame_m, params);
    }
  }
  return log_odds;
}

std::vector<Piece> doors_left_by_echoes(const MatchedWall& wall, const DoorEvidenceParams& params) {
  std::vector<std::pair<double, Piece>> found;
  for (const Piece& piece : wall.pieces) {
    for (double from_m = piece.from_m; from_m + params.door_m <= piece.to_m;
         from_m += params.step_m) {
      const Piece door{from_m, from_m + params.door_m};
      const double log_odds = wall_log_odds(wall, door, params);
      if (log_odds < params.sure_log_odds && has_foot_in(wall, door)) {
        found.emplace_back(log_odds, door);
      }
    }
  }
  std::ranges::stable_sort(found, {}, &std::pair<double, Piece>::first);
  std::vector<Piece> doors;
  for (const auto& [log_odds, door] : found) {
    if (std::ranges::none_of(doors, [&](const Piece& other) {
          return std::abs(other.from_m - door.from_m) < params.apart_m;
        })) {
      doors.push_back(door);
    }
  }
  return doors;
}

}  // namespace echomap::mapping
