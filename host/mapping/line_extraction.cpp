// SPDX-License-Identifier: MIT
#include "host/mapping/line_extraction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using Run = std::span<const Eigen::Vector2d>;

void validate(const LineExtractionParams& params) {
  geometry::ParameterValidator("line extraction")
      .positive("split_distance_m", params.split_distance_m)
      .positive("max_gap_m", params.max_gap_m)
      .positive("point_stddev_m", params.point_stddev_m)
      .positive("min_length_m", params.min_length_m)
      .at_least("min_points", params.min_points, 2);
}

/// Cuts where neighbours are too far apart for a wall.
std::vector<Run> without_gaps(Run points, double max_gap_m) {
  std::vector<Run> runs;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= points.size(); ++i) {
    if (i == points.size() || (points[i] - points[i - 1]).norm() > max_gap_m) {
      runs.push_back(points.subspan(begin, i - begin));
      begin = i;
    }
  }
  return runs;
}

/// Index of the inner point farthest from the chord, where it is farther than `distance_m`.
std::optional<std::size_t> split_point(Run run, double distance_m) {
  std::optional<std::size_t> farthest;
  if (run.size() < 3) {
    return farthest;
  }
  const geometry::Segment chord{run.front(), run.back()};
  for (std::size_t i = 1; i + 1 < run.size(); ++i) {
    const double off_m = geometry::distance_m(chord, run[i]);
    if (off_m > distance_m) {
      distance_m = off_m;
      farthest = i;
    }
  }
  return farthest;
}

/// Both parts keep the point at which they are split: it is the corner.
void split(Run run, const LineExtractionParams& params, std::vector<Run>& pieces) {
  std::vector<Run> waiting{run};
  while (!waiting.empty()) {
    const Run piece = waiting.back();
    waiting.pop_back();
    if (const auto at = split_point(piece, params.split_distance_m)) {
      waiting.push_back(piece.subspan(*at));
      waiting.push_back(piece.first(*at + 1));
    } else if (piece.size() >= 2) {
      pieces.push_back(piece);
    }
  }
}

/// Two pieces that follow each other in the same run, as one.
Run joined(Run first, Run second) {
  return {first.data(), static_cast<std::size_t>(second.data() - first.data()) + second.size()};
}

double max_m(Run points, const FittedLine& line) {
  const Eigen::Vector2d normal = geometry::unit_vector(line.normal_rad);
  double max_m = 0.0;
  for (const Eigen::Vector2d& point_m : points) {
    max_m = std::max(max_m, std::abs(normal.dot(point_m) - line.offset_m));
  }
  return max_m;
}

bool are_one(Run first, Run second, const LineExtractionParams& params) {
  const Run both = joined(first, second);
  const bool is_closed = (both.front() - both.back()).norm() == 0.0;
  return !is_closed &&
         max_m(both, fit_line(both, params.point_stddev_m)) <= params.split_distance_m;
}

std::vector<Run> merged(const std::vector<Run>& pieces, const LineExtractionParams& params) {
  std::vector<Run> lines;
  for (const Run piece : pieces) {
    if (!lines.empty() && are_one(lines.back(), piece, params)) {
      lines.back() = joined(lines.back(), piece);
    } else {
      lines.push_back(piece);
    }
  }
  return lines;
}

Eigen::Vector2d direction(const FittedLine& line) {
  return (line.segment.to_m - line.segment.from_m).normalized();
}

/// Where the two lines cross; `sine` of the angle between them is not 0.
Eigen::Vector2d crossing_m(const FittedLine& first, const FittedLine& second, double sine) {
  const Eigen::Vector2d ahead = direction(first);
  const Eigen::Vector2d between_m = second.segment.from_m - first.segment.to_m;
  return first.segment.to_m + geometry::cross(between_m, direction(second)) / sine * ahead;
}

std::optional<WallCorner> corner_between(const FittedLine& first,
                                         const FittedLine& second,
                                         const WallCornerParams& params) {
  const double sine = geometry::cross(direction(first), direction(second));
  if (std::abs(sine) < std::sin(params.min_turn_rad)) {
    return std::nullopt;
  }
  const Eigen::Vector2d position_m = crossing_m(first, second, sine);
  if ((position_m - first.segment.to_m).norm() > params.reach_m ||
      (position_m - second.segment.from_m).norm() > params.reach_m) {
    return std::nullopt;
  }
  return WallCorner{position_m, sine < 0.0 ? CornerKind::kReflex : CornerKind::kNonReflex, 0};
}

}  // namespace

std::vector<FittedLine> extract_lines(const std::vector<Eigen::Vector2d>& points_m,
                                      const LineExtractionParams& params) {
  validate(params);
  std::vector<FittedLine> lines;
  for (const Run run : without_gaps(points_m, params.max_gap_m)) {
    std::vector<Run> pieces;
    split(run, params, pieces);
    for (const Run piece : merged(pieces, params)) {
      if (piece.size() >= params.min_points &&
          (piece.front() - piece.back()).norm() >= params.min_length_m) {
        lines.push_back(fit_line(piece, params.point_stddev_m));
      }
    }
  }
  return lines;
}

std::vector<WallCorner> find_corners(const std::vector<FittedLine>& lines,
                                     bool closed,
                                     const WallCornerParams& params) {
  std::vector<WallCorner> corners;
  const std::size_t count = lines.size();
  const std::size_t pairs = closed && count > 2 ? count : std::max<std::size_t>(count, 1) - 1;
  for (std::size_t i = 0; i < pairs; ++i) {
    if (auto corner = corner_between(lines[i], lines[(i + 1) % count], params)) {
      corner->line = i;
      corners.push_back(*corner);
    }
  }
  return corners;
}

}  // namespace echomap::mapping
