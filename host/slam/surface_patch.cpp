// SPDX-License-Identifier: MIT
#include "host/slam/surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/LU>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/optimization/gauss_newton.hpp"
#include "host/optimization/normal_equations.hpp"
#include "host/optimization/robust_kernel.hpp"

namespace echomap::slam {

namespace {

constexpr int kMaxSteps = 8;
constexpr double kLongestTurnRad = 0.3;
constexpr double kConverged = 1e-5;
/// More neighbours say nothing new.
constexpr std::size_t kMaxNeighbours = 40;
/// Directions that a fit begins with, off the axis of the echo in question.
constexpr double kFirstTurnsRad[] = {-0.7, -0.35, 0.0, 0.35, 0.7};
/// Echoes are met by a surface up to this slant.
constexpr double kMaxIncidenceRad = 1.2;

using geometry::square;
using mapping::Echo;
using mapping::WallLine;
using mapping::WallView;
using Echoes = std::vector<const Echo*>;

struct FittedLine {
  WallLine line;
  Eigen::Matrix2d information;
};

/// How well a line explains the echoes that were asked.
struct Explanation {
  std::size_t explained = 0;
  double squares_m2 = 0.0;
  double from_m = std::numeric_limits<double>::max();
  double to_m = std::numeric_limits<double>::lowest();

  double rms_m() const { return std::sqrt(squares_m2 / static_cast<double>(explained)); }
};

/// Least squares of ranges; what is off by more than the noise counts less and less.
std::optional<FittedLine> fitted(WallLine line, const Echoes& echoes, double max_rms_m) {
  FittedLine fit{line, Eigen::Matrix2d::Zero()};
  const auto linearize = [&] {
    optimization::NormalEquations<2> equations;
    equations.add_prior(Eigen::Vector2d::Zero(), Eigen::Vector2d(1e-6, 1e-9).asDiagonal());
    for (const Echo* echo : echoes) {
      const WallView view = view_of_wall(*echo, fit.line);
      const double error_m = view.range_m - echo->range_m;
      const double weight = optimization::inlier_share(square(error_m), max_rms_m);
      equations.add(error_m, view.by_line.transpose(), weight);
    }
    fit.information = equations.information();
    return equations;
  };
  const auto apply = [&](const Eigen::Vector2d& step) {
    const Eigen::Vector2d change =
        step * std::min(1.0, kLongestTurnRad / std::max(std::abs(step[0]), 1e-12));
    fit.line.normal_rad = geometry::wrap_angle(fit.line.normal_rad + change[0]);
    fit.line.offset_m += change[1];
    return change.norm() < kConverged;
  };
  return optimization::gauss_newton(kMaxSteps, linearize, apply) ? std::optional(fit)
                                                                 : std::nullopt;
}

double error_m(const Echo& echo, const WallLine& line) {
  return view_of_wall(echo, line).range_m - echo.range_m;
}

Explanation explanation(const WallLine& line, const Echoes& echoes, double max_error_m) {
  const Eigen::Vector2d normal = geometry::unit_vector(line.normal_rad);
  const Eigen::Vector2d left = geometry::perpendicular(normal);
  Explanation found;
  for (const Echo* echo : echoes) {
    const WallView view = view_of_wall(*echo, line);
    const double off_m = view.range_m - echo->range_m;
    if (std::abs(off_m) > max_error_m) {
      continue;
    }
    const double along_m =
        left.dot(echo->sensor_m + echo->range_m * geometry::unit_vector(view.contact_rad));
    ++found.explained;
    found.squares_m2 += square(off_m);
    found.from_m = std::min(found.from_m, along_m);
    found.to_m = std::max(found.to_m, along_m);
  }
  return found;
}

SurfacePatch patch_at(const Echo& echo, const FittedLine& fit, double echo_stddev_m) {
  const Eigen::Vector2d normal = geometry::unit_vector(fit.line.normal_rad);
  const Eigen::Vector2d left = geometry::perpendicular(normal);
  const WallView view = view_of_wall(echo, fit.line);
  Eigen::Vector2d point_m = echo.sensor_m + echo.range_m * geometry::unit_vector(view.contact_rad);
  point_m += normal * (fit.line.offset_m - normal.dot(point_m));
  const Eigen::Matrix2d covariance = square(echo_stddev_m) * fit.information.inverse();
  const Eigen::Vector2d offset_by_line(-left.dot(point_m), 1.0);
  return {point_m,
          fit.line.normal_rad,
          std::sqrt(std::max(0.0, offset_by_line.dot(covariance * offset_by_line))),
          std::sqrt(covariance(0, 0))};
}

/// A patch where `echo` has met the line that explains it and its neighbours best.
class PatchSearch {
 public:
  PatchSearch(const Echo& echo, const Echoes& neighbours, const SurfacePatchParams& params)
      : echo_(echo), neighbours_(neighbours), params_(params) {}

  std::optional<SurfacePatch> best() const {
    std::optional<SurfacePatch> best;
    double min_cost = std::numeric_limits<double>::max();
    for (const double turn_rad : kFirstTurnsRad) {
      const auto fit =
          fitted(wall_through(echo_, echo_.axis_rad + turn_rad), neighbours_, params_.max_rms_m);
      if (!fit) {
        continue;
      }
      const Explanation found = explanation(fit->line, neighbours_, 2.5 * params_.max_rms_m);
      if (!is_good(found, fit->line) || cost(found) >= min_cost) {
        continue;
      }
      const SurfacePatch patch = patch_at(echo_, *fit, params_.echo_stddev_m);
      if (patch.normal_stddev_rad <= params_.max_normal_stddev_rad) {
        min_cost = cost(found);
        best = patch;
      }
    }
    return best;
  }

 private:
  bool is_good(const Explanation& found, const WallLine& line) const {
    const double share =
        static_cast<double>(found.explained) / static_cast<double>(neighbours_.size());
    const double slant_rad = geometry::angle_between(echo_.axis_rad, line.normal_rad);
    return found.explained >= params_.min_echoes && share >= params_.min_agreement &&
           found.rms_m() <= params_.max_rms_m &&
           found.to_m - found.from_m >= params_.min_length_m &&
           std::abs(slant_rad) <= kMaxIncidenceRad &&
           std::abs(error_m(echo_, line)) <= 2.0 * params_.max_rms_m;
  }

  double cost(const Explanation& found) const {
    const auto missed = static_cast<double>(neighbours_.size() - found.explained);
    return found.squares_m2 + missed * square(2.5 * params_.max_rms_m);
  }

  const Echo& echo_;
  const Echoes& neighbours_;
  const SurfacePatchParams& params_;
};

bool is_covered(const Eigen::Vector2d& point_m,
                const std::vector<SurfacePatch>& patches,
                double spacing_m) {
  return std::any_of(patches.begin(), patches.end(), [&](const SurfacePatch& patch) {
    return (patch.point_m - point_m).norm() < spacing_m;
  });
}

Echoes neighbours_of(const Echo& echo, const std::vector<Echo>& echoes, double reach_m) {
  const Eigen::Vector2d middle_m = echo.middle_m();
  const double within_m = reach_m + 0.7 * echo.range_m * std::sin(echo.beam_half_angle_rad);
  Echoes near;
  for (const Echo& other : echoes) {
    if ((other.middle_m() - middle_m).squaredNorm() < square(within_m)) {
      near.push_back(&other);
    }
  }
  const std::size_t stride = near.size() / kMaxNeighbours + 1;
  Echoes kept;
  for (std::size_t i = 0; i < near.size(); i += stride) {
    kept.push_back(near[i]);
  }
  return kept;
}

}  // namespace

void validate(const SurfacePatchParams& params) {
  geometry::ParameterValidator("surface patches")
      .positive("reach_m", params.reach_m)
      .positive("max_rms_m", params.max_rms_m)
      .at_least("min_length_m", params.min_length_m, 0.0)
      .positive("echo_stddev_m", params.echo_stddev_m)
      .positive("spacing_m", params.spacing_m)
      .at_least("min_echoes", params.min_echoes, 3)
      .positive("min_agreement", params.min_agreement)
      .at_most("min_agreement", params.min_agreement, 1.0)
      .positive("max_normal_stddev_rad", params.max_normal_stddev_rad);
}

std::vector<SurfacePatch> find_patches(const std::vector<Echo>& echoes,
                                       const SurfacePatchParams& params) {
  std::vector<SurfacePatch> patches;
  for (const Echo& echo : echoes) {
    if (is_covered(echo.middle_m(), patches, params.spacing_m)) {
      continue;
    }
    const Echoes neighbours = neighbours_of(echo, echoes, params.reach_m);
    if (neighbours.size() < params.min_echoes) {
      continue;
    }
    const auto patch = PatchSearch(echo, neighbours, params).best();
    if (patch && !is_covered(patch->point_m, patches, params.spacing_m)) {
      patches.push_back(*patch);
    }
  }
  return patches;
}

}  // namespace echomap::slam
