// SPDX-License-Identifier: MIT
#include "host/mapping/line_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/geometry/segment.hpp"

namespace echomap::mapping {
namespace {

/// A line with the cost of the best description of the border so far that ends in it.
struct State {
  std::size_t line = 0;
  double cost_m = 0.0;
  std::size_t previous = 0;  ///< Index of the state at the point before.
};

class LineSequence {
 public:
  LineSequence(const std::vector<BorderPoint>& border,
               const std::vector<OutlineLine>& lines,
               const std::vector<std::vector<double>>& misfits,
               const RasterMap& map,
               const LineSequenceParams& params)
      : border_(border), lines_(lines), misfits_(misfits), map_(map), params_(params) {
    for (const OutlineLine& line : lines) {
      max_line_cost_m_ = std::max(max_line_cost_m_, line.cost_m);
    }
  }

  std::vector<LineRun> runs() {
    const std::size_t count = border_.size();
    for (std::size_t i = 0; i < 3 * count; ++i) {
      advance(i);
    }
    // Of the second of three rounds: what is best there depends on no end.
    std::vector<std::size_t> line_at(count);
    std::size_t state = best(states_.back());
    for (std::size_t i = 3 * count; i-- > count;) {
      if (i < 2 * count) {
        line_at[i - count] = states_[i][state].line;
      }
      state = states_[i][state].previous;
    }
    return runs_of(line_at);
  }

 private:
  static std::size_t best(const std::vector<State>& states) {
    return static_cast<std::size_t>(
        std::min_element(states.begin(),
                         states.end(),
                         [](const State& a, const State& b) { return a.cost_m < b.cost_m; }) -
        states.begin());
  }

  /// Of going over from one line to another one before a point of the border.
  double turn_cost_m(std::size_t from, std::size_t to, std::size_t point) const {
    const auto corner =
        line_corner(lines_[from].line, lines_[to].line, joint_m(border_, point), map_, params_);
    return lines_[to].cost_m + (corner ? corner->cost_m : 2.0 * params_.corner_cost_m);
  }

  /// Adds the states of the next point.
  void advance(std::size_t point) {
    const std::vector<double>& misfits = misfits_[point % border_.size()];
    std::vector<State> next;
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      if (auto state = states_.empty() ? State{line} : reached(line, point, misfits[line] < 1.0);
          std::isfinite(state.cost_m)) {
        state.cost_m += map_.resolution_m() * misfits[line];
        next.push_back(state);
      }
    }
    // What costs more than a step from the best one to any line is not on the best way.
    const double max_m = next[best(next)].cost_m + 2.0 * params_.corner_cost_m + max_line_cost_m_;
    std::erase_if(next, [&](const State& state) { return state.cost_m > max_m; });
    states_.push_back(std::move(next));
  }

  /// The best way to a line from the states of the point before, of infinite cost where there is
  /// none.
  State reached(std::size_t line, std::size_t point, bool may_begin) const {
    const std::vector<State>& before = states_.back();
    State state{line, std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < before.size(); ++i) {
      const bool stays = before[i].line == line;
      // A turn costs something.
      if (before[i].cost_m >= state.cost_m || (!stays && !may_begin)) {
        continue;
      }
      const double cost_m =
          before[i].cost_m + (stays ? 0.0 : turn_cost_m(before[i].line, line, point));
      if (cost_m < state.cost_m) {
        state = {line, cost_m, i};
      }
    }
    return state;
  }

  std::vector<LineRun> runs_of(const std::vector<std::size_t>& line_at) const {
    const std::size_t count = line_at.size();
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < count; ++i) {
      if (line_at[i] != line_at[(i + count - 1) % count]) {
        begins.push_back(i);
      }
    }
    std::vector<LineRun> runs;
    for (std::size_t i = 0; i < begins.size(); ++i) {
      const bool is_last = i + 1 == begins.size();
      runs.push_back(
          {line_at[begins[i]], begins[i], is_last ? begins.front() + count : begins[i + 1]});
    }
    return runs;
  }

  const std::vector<BorderPoint>& border_;
  const std::vector<OutlineLine>& lines_;
  const std::vector<std::vector<double>>& misfits_;
  const RasterMap& map_;
  LineSequenceParams params_;
  double max_line_cost_m_ = 0.0;
  std::vector<std::vector<State>> states_;  ///< By point.
};

}  // namespace

std::optional<LineCorner> line_corner(const DirectedLine& before,
                                      const DirectedLine& after,
                                      const Eigen::Vector2d& border_m,
                                      const RasterMap& map,
                                      const LineSequenceParams& params) {
  if (std::abs(geometry::cross(before.direction, after.direction)) <
      std::sin(params.min_turn_rad)) {
    return std::nullopt;
  }
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): they are not parallel
  const Eigen::Vector2d corner_m = *before.crossing(after);
  const bool is_floor = map.state(map.cell_at(corner_m)) == CellState::kFree;
  const double off = (corner_m - border_m).norm() /
                     (is_floor ? params.floor_corner_reach_m : params.corner_reach_m);
  if (off > 1.0) {
    return std::nullopt;
  }
  return LineCorner{corner_m, (1.0 + off * off) * params.corner_cost_m};
}

std::vector<LineRun> line_sequence(const std::vector<BorderPoint>& border,
                                   const std::vector<OutlineLine>& lines,
                                   const std::vector<std::vector<double>>& misfits,
                                   const RasterMap& map,
                                   const LineSequenceParams& params) {
  if (border.empty() || lines.empty()) {
    return {};
  }
  return LineSequence(border, lines, misfits, map, params).runs();
}

}  // namespace echomap::mapping
