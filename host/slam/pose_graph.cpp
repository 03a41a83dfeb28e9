// SPDX-License-Identifier: MIT
#include "host/slam/pose_graph.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/optimization/block_equations.hpp"
#include "host/optimization/gauss_newton.hpp"
#include "host/optimization/robust_kernel.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

optimization::BlockEquations equations_over(std::size_t nodes) {
  optimization::BlockEquations equations;
  equations.add_fixed_block();
  for (std::size_t node = 1; node < nodes; ++node) {
    equations.add_block(3);
  }
  return equations;
}

}  // namespace

Eigen::Matrix3d in_frame_of(const Pose2& T_map_robot, const Eigen::Matrix3d& information) {
  Eigen::Matrix3d to_map = Eigen::Matrix3d::Identity();
  to_map.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(T_map_robot.heading_rad()).toRotationMatrix();
  return to_map.transpose() * information * to_map;
}

Eigen::Matrix3d with_spread(const Eigen::Matrix3d& information,
                            double spread_m,
                            double spread_rad) {
  // (information^-1 + spread)^-1 without the inverse of what may be singular.
  const Eigen::Vector3d variance(spread_m * spread_m, spread_m * spread_m, spread_rad * spread_rad);
  const Eigen::Matrix3d growth = Eigen::Matrix3d::Identity() + information * variance.asDiagonal();
  const Eigen::Matrix3d left = growth.inverse() * information;
  return (left + left.transpose()) / 2.0;
}

Pose2 moved(const Pose2& pose, const Eigen::Vector3d& step) {
  return {pose.x_m() + step.x(), pose.y_m() + step.y(), pose.heading_rad() + step.z()};
}

EdgeError edge_error(const PoseEdge& edge, const Pose2& T_map_from, const Pose2& T_map_to) {
  const Eigen::Matrix2d to_from = Eigen::Rotation2Dd(-T_map_from.heading_rad()).toRotationMatrix();
  const Eigen::Matrix2d to_edge =
      Eigen::Rotation2Dd(-edge.T_from_to.heading_rad()).toRotationMatrix();
  const Eigen::Matrix2d map_to_edge = to_edge * to_from;
  const Eigen::Vector2d offset_m = T_map_to.position_m() - T_map_from.position_m();
  EdgeError off;
  off.error << map_to_edge * offset_m - to_edge * edge.T_from_to.position_m(),
      geometry::wrap_angle(T_map_to.heading_rad() - T_map_from.heading_rad() -
                           edge.T_from_to.heading_rad());
  off.by_from.topLeftCorner<2, 2>() = -map_to_edge;
  // What lies in the map turns the other way as `from` turns.
  off.by_from.topRightCorner<2, 1>() = map_to_edge * Eigen::Vector2d(offset_m.y(), -offset_m.x());
  off.by_from(2, 2) = -1.0;
  off.by_to.topLeftCorner<2, 2>() = map_to_edge;
  off.by_to(2, 2) = 1.0;
  return off;
}

PoseGraph::PoseGraph(const PoseGraphParams& params) : params_(params) {
  geometry::ParameterValidator("pose graph")
      .at_least("max_iterations", params.max_iterations, 1)
      .positive("kernel", params.kernel);
}

std::size_t PoseGraph::add_node(const Pose2& T_map_node) {
  T_map_nodes_.push_back(T_map_node);
  return T_map_nodes_.size() - 1;
}

void PoseGraph::add_edge(const PoseEdge& edge) {
  if (std::max(edge.from, edge.to) >= T_map_nodes_.size() || edge.from == edge.to) {
    throw std::invalid_argument("pose graph: an edge joins two nodes that are there");
  }
  edges_.push_back(edge);
}

double PoseGraph::square_error(const PoseEdge& edge) const {
  const Eigen::Vector3d error =
      edge_error(edge, T_map_nodes_[edge.from], T_map_nodes_[edge.to]).error;
  return error.dot(edge.information * error);
}

std::vector<PoseEdge> PoseGraph::weighed_edges() const {
  std::vector<PoseEdge> weighed = edges_;
  for (PoseEdge& edge : weighed) {
    edge.information *= robust_weight(edge, square_error(edge));
    edge.is_doubtful = false;
  }
  return weighed;
}

double PoseGraph::robust_weight(const PoseEdge& edge, double squared_error) const {
  return edge.is_doubtful ? optimization::geman_mcclure_weight(squared_error, params_.kernel) : 1.0;
}

bool PoseGraph::solve() {
  const auto linearize = [this] {
    optimization::BlockEquations equations = equations_over(T_map_nodes_.size());
    for (const PoseEdge& edge : edges_) {
      const EdgeError off = edge_error(edge, T_map_nodes_[edge.from], T_map_nodes_[edge.to]);
      const double weight = robust_weight(edge, off.error.dot(edge.information * off.error));
      equations.add<3, 3, 3>(
          off.error, weight * edge.information, {edge.from, off.by_from}, {edge.to, off.by_to});
    }
    return equations;
  };
  const auto apply = [this](const optimization::BlockSolution& solution) {
    double max_step_m = 0.0;
    double max_step_rad = 0.0;
    for (std::size_t node = 1; node < T_map_nodes_.size(); ++node) {
      const Eigen::Vector3d step = solution.step_of<3>(node);
      T_map_nodes_[node] = moved(T_map_nodes_[node], step);
      max_step_m = std::max(max_step_m, step.head<2>().norm());
      max_step_rad = std::max(max_step_rad, std::abs(step.z()));
    }
    return max_step_m < params_.min_step_m && max_step_rad < params_.min_step_rad;
  };
  return T_map_nodes_.size() < 2 ||
         optimization::gauss_newton(params_.max_iterations, linearize, apply);
}

}  // namespace echomap::slam
