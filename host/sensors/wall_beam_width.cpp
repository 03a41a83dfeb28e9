// SPDX-License-Identifier: MIT
#include "host/sensors/wall_beam_width.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/distributions/students_t.hpp>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::sensors {

namespace {

/// Bearing and range of a reading with echo; bearings go on beyond half a turn. `smooth_m` is the
/// middle one of three neighbours' ranges, so that noise makes no wall.
struct Echo {
  double bearing_rad;
  double range_m;
  double smooth_m;
};
using Echoes = std::span<const Echo>;

constexpr double kGridStepRad = geometry::radians(0.25);
constexpr int kBeamHalfAngles = 181;
/// Nothing is heard that far off a wall's perpendicular.
constexpr double kMaxOffRad = geometry::radians(75.0);
constexpr std::size_t kUnknowns = 3;

/// Student's t for a confidence of 95 %, both sides.
double student_t(std::size_t degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(static_cast<double>(degrees_of_freedom)),
                               0.975);
}

/// The sweep as runs of echoes that may be of one wall.
class Runs {
 public:
  Runs(std::span<const Beam> sweep, const WallBeamWidthParams& params)
      : sweep_(sweep), params_(params) {
    if (sweep.size() < params.min_readings) {
      return;
    }
    const std::size_t begin = is_ring() ? first_break() : 0;
    double bearing_rad = sweep[begin].bearing_rad;
    for (std::size_t i = 0; i < sweep.size(); ++i) {
      const std::size_t now = (begin + i) % sweep.size();
      const std::size_t before = (now + sweep.size() - 1) % sweep.size();
      if (i == 0 || breaks(before, now)) {
        runs_.emplace_back();
      }
      if (i > 0) {
        bearing_rad += geometry::angle_between(sweep[before].bearing_rad, sweep[now].bearing_rad);
      }
      if (const auto& range_m = sweep[now].range_m) {
        runs_.back().push_back({bearing_rad, *range_m, *range_m});
      }
    }
    for (std::vector<Echo>& run : runs_) {
      smooth(run);
    }
  }

  const std::vector<std::vector<Echo>>& runs() const { return runs_; }

 private:
  static void smooth(std::vector<Echo>& run) {
    for (std::size_t i = 1; i + 1 < run.size(); ++i) {
      const double before_m = run[i - 1].range_m;
      const double after_m = run[i + 1].range_m;
      run[i].smooth_m =
          std::clamp(run[i].range_m, std::min(before_m, after_m), std::max(before_m, after_m));
    }
  }
  /// Whether the way from the last reading to the first is no longer than two steps.
  bool is_ring() const {
    const double step_rad =
        std::abs(geometry::angle_between(sweep_[0].bearing_rad, sweep_[1].bearing_rad));
    return std::abs(geometry::angle_between(sweep_.back().bearing_rad, sweep_[0].bearing_rad)) <=
           2.0 * step_rad;
  }
  std::size_t first_break() const {
    for (std::size_t i = 1; i < sweep_.size(); ++i) {
      if (breaks(i - 1, i)) {
        return i;
      }
    }
    return 0;
  }
  bool breaks(std::size_t before, std::size_t now) const {
    const auto& from_m = sweep_[before].range_m;
    const auto& to_m = sweep_[now].range_m;
    return !from_m || !to_m ||
           std::abs(*to_m - *from_m) >
               params_.jump_share * std::min(*from_m, *to_m) + 2.0 * params_.range_stddev_m;
  }

  std::span<const Beam> sweep_;
  const WallBeamWidthParams& params_;
  std::vector<std::vector<Echo>> runs_;
};

/// How far a wall reaches from its nearest echo, one way: to the highest echo before the ranges
/// fall again by `fall_m`.
template <typename Iterator>
Iterator shoulder(Iterator nearest, Iterator end, double fall_m) {
  Iterator highest = nearest;
  for (Iterator echo = nearest; echo != end; ++echo) {
    if (echo->smooth_m > highest->smooth_m) {
      highest = echo;
    } else if (echo->smooth_m < highest->smooth_m - fall_m) {
      break;
    }
  }
  return highest;
}

/// Adds the pieces of a run that fall and rise again: one for each wall.
void add_dips(Echoes run, const WallBeamWidthParams& params, std::vector<Echoes>& dips) {
  if (run.size() < params.min_readings) {
    return;
  }
  const double shoulder_m = 3.0 * params.range_stddev_m;
  const auto nearer = [](const Echo& a, const Echo& b) { return a.smooth_m < b.smooth_m; };
  const auto nearest = std::min_element(run.begin(), run.end(), nearer);
  const auto last = shoulder(nearest, run.end(), shoulder_m);
  const auto first =
      shoulder(std::make_reverse_iterator(nearest + 1), run.rend(), shoulder_m).base() - 1;
  const auto begin = static_cast<std::size_t>(first - run.begin());
  const auto size = static_cast<std::size_t>(last - first) + 1;
  const bool rises = std::min(first->smooth_m, last->smooth_m) - nearest->smooth_m >= shoulder_m;
  if (rises && size >= params.min_readings) {
    dips.push_back(run.subspan(begin, size));
  }
  add_dips(run.first(begin), params, dips);
  add_dips(run.subspan(begin + size), params, dips);
}

/// Equation (1) with its best distance at a given bearing and half opening.
struct Fit {
  double squares_m2 = std::numeric_limits<double>::infinity();
  double bearing_rad = 0.0;
  double range_m = 0.0;
};

/// Equation (1): the range of a wall 1 m away.
double stretch_at(double off_bearing_rad, double beam_half_angle_rad) {
  return 1.0 /
         std::cos(std::clamp(std::abs(off_bearing_rad) - beam_half_angle_rad, 0.0, kMaxOffRad));
}

Fit fit_range(Echoes dip, double bearing_rad, double beam_half_angle_rad) {
  double ranges = 0.0;
  double stretches = 0.0;
  double both = 0.0;
  for (const Echo& echo : dip) {
    const double stretch = stretch_at(echo.bearing_rad - bearing_rad, beam_half_angle_rad);
    ranges += echo.range_m * echo.range_m;
    stretches += stretch * stretch;
    both += echo.range_m * stretch;
  }
  return {std::max(0.0, ranges - both * both / stretches), bearing_rad, both / stretches};
}

/// The best wall for each half opening.
std::array<Fit, kBeamHalfAngles> profile_of(Echoes dip) {
  const double low_rad = std::min(dip.front().bearing_rad, dip.back().bearing_rad);
  const double high_rad = std::max(dip.front().bearing_rad, dip.back().bearing_rad);
  const int bearings = static_cast<int>((high_rad - low_rad) / (2.0 * kGridStepRad));
  std::array<Fit, kBeamHalfAngles> profile;
  for (std::size_t half = 0; half < profile.size(); ++half) {
    for (int i = 0; i <= bearings; ++i) {
      const double bearing_rad = low_rad + i * 2.0 * kGridStepRad;
      const Fit fit = fit_range(dip, bearing_rad, static_cast<double>(half) * kGridStepRad);
      if (fit.squares_m2 < profile[half].squares_m2) {
        profile[half] = fit;
      }
    }
  }
  return profile;
}

std::vector<WallReading> heard_by(Echoes dip, const Fit& fit, double beam_half_angle_rad) {
  std::vector<WallReading> heard;
  for (const Echo& echo : dip) {
    const double off_rad = echo.bearing_rad - fit.bearing_rad;
    heard.push_back(
        {std::abs(off_rad), echo.range_m - fit.range_m * stretch_at(off_rad, beam_half_angle_rad)});
  }
  return heard;
}

SweptWall wall_of(Echoes dip) {
  const auto profile = profile_of(dip);
  const auto better = [](const Fit& a, const Fit& b) { return a.squares_m2 < b.squares_m2; };
  const auto best = std::min_element(profile.begin(), profile.end(), better);
  const std::size_t freedom = dip.size() - kUnknowns;
  const double variance_m2 = best->squares_m2 / static_cast<double>(freedom);
  const double t = student_t(freedom);
  const auto is_likely = [&](const Fit& fit) {
    return fit.squares_m2 <= best->squares_m2 + t * t * variance_m2;
  };
  const auto beam_width_rad = [&](auto fit) {
    return 2.0 * kGridStepRad * static_cast<double>(fit - profile.begin());
  };
  // Outwards to the grid's next steps.
  const auto first = std::find_if(profile.begin(), profile.end(), is_likely);
  const auto low = first == profile.begin() ? first : first - 1;
  const auto high =
      std::min(std::find_if(profile.rbegin(), profile.rend(), is_likely).base(), profile.end() - 1);
  return {geometry::wrap_angle(best->bearing_rad),
          best->range_m,
          {beam_width_rad(best), beam_width_rad(low), beam_width_rad(high)},
          std::sqrt(variance_m2),
          dip.size(),
          heard_by(dip, *best, 0.5 * beam_width_rad(best))};
}

/// No wall is surer than the grid.
double weight_of(const SweptWall& wall) {
  const double width_rad =
      std::max(wall.beam_width.high_rad - wall.beam_width.low_rad, 2.0 * kGridStepRad);
  return 1.0 / (width_rad * width_rad);
}

}  // namespace

std::vector<SweptWall> swept_walls(std::span<const Beam> sweep, const WallBeamWidthParams& params) {
  geometry::ParameterValidator("wall beam width")
      .positive("range_stddev_m", params.range_stddev_m)
      .at_least("jump_share", params.jump_share, 0.0)
      .above("min_readings", params.min_readings, kUnknowns);
  const Runs runs(sweep, params);
  std::vector<SweptWall> walls;
  for (const auto& run : runs.runs()) {
    std::vector<Echoes> dips;
    add_dips(run, params, dips);
    for (const Echoes& dip : dips) {
      const SweptWall wall = wall_of(dip);
      if (wall.residual_m <= 2.0 * params.range_stddev_m) {
        walls.push_back(wall);
      }
    }
  }
  std::sort(walls.begin(), walls.end(), [](const SweptWall& a, const SweptWall& b) {
    return a.bearing_rad < b.bearing_rad;
  });
  return walls;
}

std::optional<PooledBeamWidth> pooled_beam_width(std::span<const SweptWall> walls) {
  if (walls.size() < 3) {
    return std::nullopt;
  }
  double weights = 0.0;
  double sum_rad = 0.0;
  for (const SweptWall& wall : walls) {
    weights += weight_of(wall);
    sum_rad += weight_of(wall) * wall.beam_width.beam_width_rad;
  }
  const double mean_rad = sum_rad / weights;
  double squares = 0.0;
  for (const SweptWall& wall : walls) {
    squares += weight_of(wall) * std::pow(wall.beam_width.beam_width_rad - mean_rad, 2);
  }
  const double count = static_cast<double>(walls.size());
  const double spread_rad = std::sqrt(squares / weights * count / (count - 1.0));
  const double bound_rad = student_t(walls.size() - 1) * spread_rad / std::sqrt(count);
  return PooledBeamWidth{{mean_rad, mean_rad - bound_rad, mean_rad + bound_rad}, spread_rad};
}

}  // namespace echomap::sensors
