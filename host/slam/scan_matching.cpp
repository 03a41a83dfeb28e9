// SPDX-License-Identifier: MIT
#include "host/slam/scan_matching.hpp"

#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/optimization/gauss_newton.hpp"
#include "host/optimization/normal_equations.hpp"
#include "host/optimization/robust_kernel.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

/// Where odometry holds, the error before a match is within these cells.
constexpr int kStartLevel = 1;

Eigen::Vector3d as_vector(const Pose2& pose) {
  return {pose.x_m(), pose.y_m(), pose.heading_rad()};
}

/// The errors of the points around a pose.
struct PointErrors {
  optimization::NormalEquations<3> equations;
  double cost = 0.0;
  double share = 0.0;  ///< Of the points that lie on surfaces.
};

/// How a point, turned into the map but not yet moved, changes with x, y and heading: by heading it
/// moves at right angles to where it lies from the robot.
Eigen::Matrix<double, 2, 3> point_by_pose(const Eigen::Vector2d& turned_m) {
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << Eigen::Matrix2d::Identity(), geometry::perpendicular(turned_m);
  return jacobian;
}

/// The surfaces that points were last found on: from one iteration to the next most stay in their
/// cells.
class FoundSurfaces {
 public:
  FoundSurfaces(SurfaceField& field, std::size_t points) : field_(&field), found_(points) {}

  const Surface& at(std::size_t point, const Eigen::Vector2d& placed_m, int level) {
    Found& found = found_[point];
    const geometry::CellIndex cell = field_->cell_at(placed_m, level);
    if (found.level != level || found.cell != cell) {
      found = {level, cell, field_->surface_at(cell, level)};
    }
    return found.surface;
  }

 private:
  struct Found {
    int level = -1;
    geometry::CellIndex cell;
    Surface surface;
  };

  SurfaceField* field_;
  std::vector<Found> found_;
};

PointErrors linearized(std::span<const Eigen::Vector2d> points_m,
                       const Eigen::Vector3d& pose,
                       int level,
                       double kernel,
                       FoundSurfaces& surfaces) {
  PointErrors sum;
  const double cos = std::cos(pose.z());
  const double sin = std::sin(pose.z());
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    const Eigen::Vector2d& point_m = points_m[i];
    const Eigen::Vector2d turned_m(cos * point_m.x() - sin * point_m.y(),
                                   sin * point_m.x() + cos * point_m.y());
    const Eigen::Vector2d placed_m = pose.head<2>() + turned_m;
    const Surface& surface = surfaces.at(i, placed_m, level);
    if (surface.empty()) {
      sum.cost += kernel * kernel / 2.0;
      continue;
    }
    const Eigen::Vector2d off_m = placed_m - surface.mean_m;
    const Eigen::Matrix2d information = surface.information();
    const double square = off_m.dot(information * off_m);
    const double share = optimization::inlier_share(square, kernel);
    sum.cost += square * share / 2.0;
    sum.share += share;
    sum.equations.add<2>(off_m, point_by_pose(turned_m), share * share * information);
  }
  sum.share /= static_cast<double>(points_m.size());
  return sum;
}

}  // namespace

ScanMatcher::ScanMatcher(const ScanMatchingParams& params) : params_(params) {
  geometry::ParameterValidator("scan matching")
      .positive("kernel", params.kernel)
      .positive("weight", params.weight)
      .at_least("max_iterations", params.max_iterations, 1)
      .at_least("max_coarse_iterations", params.max_coarse_iterations, 1)
      .at_least("turns", params.turns, 0)
      .at_least("min_saving", params.min_saving, 0)
      .below("min_saving", params.min_saving, 1);
}

ScanMatch ScanMatcher::match(std::span<const Eigen::Vector2d> points_m,
                             const localization::PoseGaussian& prior,
                             SurfaceField& field) const {
  if (points_m.empty() || field.empty()) {
    return {prior.T_map_robot, Eigen::Matrix3d::Zero(), 0.0, 0.0};
  }
  const Prior before{as_vector(prior.T_map_robot), prior.covariance.inverse()};
  ScanMatch match = refined(points_m, before, before.pose, {kStartLevel, 0}, field);
  const bool is_heading_known =
      prior.covariance(2, 2) < params_.known_heading_rad * params_.known_heading_rad;
  if (match.share >= (is_heading_known ? params_.good_share : params_.good_turned_share)) {
    return match;
  }
  const bool is_turned = match.share < params_.poor_share || !is_heading_known;
  const ScanMatch other = best_of_starts(points_m, before, is_turned ? params_.turns : 0, field);
  return other.cost < (1.0 - params_.min_saving) * match.cost ? other : match;
}

ScanMatch ScanMatcher::match_after(std::span<const Eigen::Vector2d> points_m,
                                   const Pose2& T_map_before,
                                   const localization::PoseGaussian& prior,
                                   SurfaceField& field) const {
  ScanMatch match = this->match(points_m, prior, field);
  if (match.share >= params_.poor_share || points_m.empty() || field.empty()) {
    return match;
  }
  const Prior before{as_vector(T_map_before), prior.covariance.inverse()};
  const ScanMatch stayed = best_of_starts(points_m, before, params_.turns, field);
  return stayed.share >= params_.good_share ? stayed : match;
}

ScanMatch ScanMatcher::best_of_starts(std::span<const Eigen::Vector2d> points_m,
                                      const Prior& prior,
                                      int turns,
                                      SurfaceField& field) const {
  constexpr int kCoarsest = SurfaceField::kLevels - 1;
  ScanMatch best = refined(points_m, prior, prior.pose, {kCoarsest, kCoarsest}, field);
  for (int turn = 1; turn <= turns; ++turn) {
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d turned =
          prior.pose + Eigen::Vector3d(0.0, 0.0, side * turn * params_.turn_rad);
      const ScanMatch other = refined(points_m, prior, turned, {kCoarsest, kCoarsest}, field);
      best = other.cost < best.cost ? other : best;
    }
  }
  return refined(points_m, prior, as_vector(best.T_map_robot), {kCoarsest - 1, 0}, field);
}

ScanMatch ScanMatcher::refined(std::span<const Eigen::Vector2d> points_m,
                               const Prior& prior,
                               const Eigen::Vector3d& start,
                               const Levels& levels,
                               SurfaceField& field) const {
  FoundSurfaces surfaces(field, points_m.size());
  Eigen::Vector3d pose = start;
  PointErrors points;
  double prior_cost = 0.0;
  for (int level = levels.from; level >= levels.to; --level) {
    const auto linearize = [&] {
      points = linearized(points_m, pose, level, params_.kernel, surfaces);
      Eigen::Vector3d off = pose - prior.pose;
      off.z() = geometry::wrap_angle(off.z());
      const double square = off.dot(prior.information * off);
      const double weight = optimization::geman_mcclure_weight(square, params_.prior_kernel);
      prior_cost = square / 2.0;
      optimization::NormalEquations<3> equations;
      // Noise doubles with the cells; a point keeps its weight against the prior.
      equations.add(points.equations, params_.weight * std::pow(4.0, level));
      equations.add_prior(off, weight * prior.information);
      return equations;
    };
    const auto apply = [&](const Eigen::Vector3d& step) {
      pose += step;
      return step.head<2>().norm() < params_.min_step_m &&
             std::abs(step.z()) < params_.min_step_rad;
    };
    optimization::gauss_newton(
        level > 0 ? params_.max_coarse_iterations : params_.max_iterations, linearize, apply);
  }
  return {Pose2(pose.x(), pose.y(), pose.z()),
          params_.weight * points.equations.information(),
          points.share,
          params_.weight * points.cost + prior_cost};
}

}  // namespace echomap::slam
