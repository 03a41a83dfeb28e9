// SPDX-License-Identifier: MIT
#include "host/mapping/outline_sides.hpp"

#include <cmath>
#include <optional>

#include "host/geometry/touching_sides.hpp"
#include "host/mapping/floor_border.hpp"
#include "host/mapping/ring_loops.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using geometry::Segment;

/// A lower step between two lines is one corner.
constexpr double kMinStepM = 0.05;
/// A side has a line if both its ends are this near to it.
constexpr double kOnLineM = 1e-6;

class StraightOutline {
 public:
  StraightOutline(const Polygon& border_m,
                  const RasterMap& map,
                  const std::vector<Segment>& walls,
                  const OutlineSideParams& params)
      : params_(params),
        map_(map),
        border_(border_points(border_m, map)),
        lines_(outline_lines(border_, walls, params.lines)),
        is_given_up_(lines_.size()) {
    for (const BorderPoint& point : border_) {
      misfits_.push_back(misfits(lines_, point, map, params.lines));
    }
  }

  Polygon outline() {
    // A round takes at least one line.
    for (;;) {
      const auto runs = line_sequence(border_, lines_, misfits_, map_, params_.sequence);
      Polygon outline_m = without_small_loops(corners(runs), params_.max_loop_m2);
      bool any_given_up = false;
      for (const auto& [first, second] : geometry::touching_sides({outline_m})) {
        any_given_up |= give_up_line(
            geometry::side(outline_m, first.side), geometry::side(outline_m, second.side), runs);
      }
      if (!any_given_up) {
        return outline_m;
      }
    }
  }

 private:
  Polygon corners(const std::vector<LineRun>& runs) const {
    Polygon corners_m;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const LineRun& next = runs[(i + 1) % runs.size()];
      const auto joint = corners_between(
          lines_[runs[i].line].line, lines_[next.line].line, joint_m(border_, next.begin));
      corners_m.insert(corners_m.end(), joint.begin(), joint.end());
    }
    return corners_m;
  }

  /// Of two sides that meet about a point of the border: where their lines cross, or a step.
  std::vector<Eigen::Vector2d> corners_between(const DirectedLine& before,
                                               const DirectedLine& after,
                                               const Eigen::Vector2d& border_m) const {
    if (const auto corner = line_corner(before, after, border_m, map_, params_.sequence)) {
      return {corner->position_m};
    }
    const Eigen::Vector2d from_m = before.foot_of(border_m);
    const Eigen::Vector2d to_m = after.foot_of(border_m);
    if ((to_m - from_m).norm() < kMinStepM) {
      return {0.5 * (from_m + to_m)};
    }
    return {from_m, to_m};
  }

  /// That of the shorter of two sides that cross, or else of the other one. Whether there was any.
  bool give_up_line(const Segment& first, const Segment& second, const std::vector<LineRun>& runs) {
    const bool is_first_shorter = first.length_m() < second.length_m();
    auto line = line_of(is_first_shorter ? first : second, runs);
    if (!line) {
      line = line_of(is_first_shorter ? second : first, runs);
    }
    if (line) {
      give_up(*line);
    }
    return line.has_value();
  }

  /// Empty for a step, and for a line that is given up.
  std::optional<std::size_t> line_of(const Segment& side, const std::vector<LineRun>& runs) const {
    for (const LineRun& run : runs) {
      const DirectedLine& line = lines_[run.line].line;
      if (!is_given_up_[run.line] && std::abs(line.left_m(side.from_m)) < kOnLineM &&
          std::abs(line.left_m(side.to_m)) < kOnLineM) {
        return run.line;
      }
    }
    return std::nullopt;
  }

  void give_up(std::size_t line) {
    is_given_up_[line] = true;
    for (auto& of_point : misfits_) {
      of_point[line] = 1.0;
    }
  }

  OutlineSideParams params_;
  const RasterMap& map_;
  std::vector<BorderPoint> border_;
  std::vector<OutlineLine> lines_;
  std::vector<bool> is_given_up_;             ///< By line: no piece of border may follow it.
  std::vector<std::vector<double>> misfits_;  ///< By point of the border and line.
};

}  // namespace

Polygon straight_outline(const Polygon& border_m,
                         const RasterMap& map,
                         const std::vector<Segment>& walls,
                         const OutlineSideParams& params) {
  return StraightOutline(border_m, map, walls, params).outline();
}

}  // namespace echomap::mapping
