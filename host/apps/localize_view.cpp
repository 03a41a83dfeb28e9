// SPDX-License-Identifier: MIT
#include "host/apps/localize_view.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "host/apps/explore_view.hpp"

namespace echomap::apps {
namespace {

/// So many particles show how they lie.
constexpr std::size_t kShownPoses = 500;
/// Particles that spread more do not agree on a place, metres.
constexpr double kMaxAgreeing95M = 1.0;

}  // namespace

std::optional<AgreedPose> agreed_pose(const std::vector<geometry::Pose2>& poses) {
  if (poses.size() < 2) {
    return std::nullopt;
  }
  const auto count = static_cast<double>(poses.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d heading = Eigen::Vector2d::Zero();
  for (const geometry::Pose2& pose : poses) {
    mean += pose.position_m() / count;
    heading += Eigen::Vector2d(std::cos(pose.heading_rad()), std::sin(pose.heading_rad()));
  }
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const geometry::Pose2& pose : poses) {
    const Eigen::Vector2d offset = pose.position_m() - mean;
    covariance += offset * offset.transpose() / count;
  }
  const double variance =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance, Eigen::EigenvaluesOnly)
          .eigenvalues()
          .maxCoeff();
  const AgreedPose agreed{{mean.x(), mean.y(), std::atan2(heading.y(), heading.x())},
                          kStddevsOf95 * std::sqrt(std::max(0.0, variance))};
  return agreed.position_95_m <= kMaxAgreeing95M ? std::optional(agreed) : std::nullopt;
}

terminal_view::RunView LocalizeView::view() {
  const std::vector<geometry::Pose2> poses = filter_.sampled_poses(kShownPoses);
  terminal_view::RunView view{map_, {}, {}};
  for (const geometry::Pose2& pose : poses) {
    view.marks.particles_m.push_back(pose.position_m());
  }
  view.status.mode = "localizing";
  if (const auto agreed = agreed_pose(poses)) {
    view.marks.T_map_robot = agreed->T_map_robot;
    view.status.T_map_robot = agreed->T_map_robot;
    view.status.position_95_m = agreed->position_95_m;
  }
  view.status.stops = filter_.trajectory().size();
  view.status.elapsed_s = elapsed_s();
  view.status.link = health_of(robot_.session().link().statistics());
  return view;
}

}  // namespace echomap::apps
