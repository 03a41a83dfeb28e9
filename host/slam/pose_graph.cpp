// SPDX-License-Identifier: MIT
#include "host/slam/pose_graph.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include "host/geometry/angle.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

constexpr Eigen::Index kPoseSize = 3;

/// The normal equations of all nodes but the first.
class Equations {
 public:
  explicit Equations(std::size_t nodes)
      : size_(kPoseSize * static_cast<Eigen::Index>(nodes - 1)),
        gradient_(Eigen::VectorXd::Zero(size_)) {}

  void add(const PoseEdge& edge, const EdgeError& off, double trust) {
    const Eigen::Matrix3d information = trust * edge.information;
    add_block(edge.from, edge.from, off.by_from.transpose() * information * off.by_from);
    add_block(edge.to, edge.to, off.by_to.transpose() * information * off.by_to);
    // The lower half is enough.
    if (edge.from > edge.to) {
      add_block(edge.from, edge.to, off.by_from.transpose() * information * off.by_to);
    } else {
      add_block(edge.to, edge.from, off.by_to.transpose() * information * off.by_from);
    }
    add_gradient(edge.from, off.by_from.transpose() * information * off.error);
    add_gradient(edge.to, off.by_to.transpose() * information * off.error);
  }

  /// The step of all nodes but the first; empty where the equations do not determine it.
  Eigen::VectorXd solved() const {
    Eigen::SparseMatrix<double> information(size_, size_);
    information.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(information);
    if (factors.info() != Eigen::Success) {
      return {};
    }
    Eigen::VectorXd step = factors.solve(-gradient_);
    return step.allFinite() ? step : Eigen::VectorXd();
  }

 private:
  static Eigen::Index place(std::size_t node) {
    return kPoseSize * (static_cast<Eigen::Index>(node) - 1);
  }

  void add_block(std::size_t row_node, std::size_t column_node, const Eigen::Matrix3d& block) {
    if (row_node == 0 || column_node == 0) {
      return;
    }
    for (Eigen::Index row = 0; row < kPoseSize; ++row) {
      const Eigen::Index last = row_node == column_node ? row : kPoseSize - 1;
      for (Eigen::Index column = 0; column <= last; ++column) {
        entries_.emplace_back(
            place(row_node) + row, place(column_node) + column, block(row, column));
      }
    }
  }

  void add_gradient(std::size_t node, const Eigen::Vector3d& gradient) {
    if (node != 0) {
      gradient_.segment<kPoseSize>(place(node)) += gradient;
    }
  }

  Eigen::Index size_;
  Eigen::VectorXd gradient_;
  std::vector<Eigen::Triplet<double>> entries_;
};

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

EdgeError edge_error(const PoseEdge& edge, const Pose2& T_map_from, const Pose2& T_map_to) {
  const Eigen::Matrix2d to_from = Eigen::Rotation2Dd(-T_map_from.heading_rad()).toRotationMatrix();
  const Eigen::Matrix2d to_edge =
      Eigen::Rotation2Dd(-edge.T_from_to.heading_rad()).toRotationMatrix();
  const Eigen::Matrix2d map_to_edge = to_edge * to_from;
  const Eigen::Vector2d way_m = T_map_to.position_m() - T_map_from.position_m();
  EdgeError off;
  off.error << map_to_edge * way_m - to_edge * edge.T_from_to.position_m(),
      geometry::wrap_angle(T_map_to.heading_rad() - T_map_from.heading_rad() -
                           edge.T_from_to.heading_rad());
  off.by_from.topLeftCorner<2, 2>() = -map_to_edge;
  // What lies in the map turns the other way as `from` turns.
  off.by_from.topRightCorner<2, 1>() = map_to_edge * Eigen::Vector2d(way_m.y(), -way_m.x());
  off.by_from(2, 2) = -1.0;
  off.by_to.topLeftCorner<2, 2>() = map_to_edge;
  off.by_to(2, 2) = 1.0;
  return off;
}

PoseGraph::PoseGraph(const PoseGraphParams& params) : params_(params) {
  if (params.most_iterations < 1 || !(params.kernel > 0.0)) {
    throw std::invalid_argument("pose graph: at least one iteration, and a kernel above 0");
  }
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
    edge.information *= trust(edge, square_error(edge));
    edge.is_doubtful = false;
  }
  return weighed;
}

double PoseGraph::trust(const PoseEdge& edge, double square) const {
  if (!edge.is_doubtful) {
    return 1.0;
  }
  const double root = 1.0 / (1.0 + square / (params_.kernel * params_.kernel));
  return root * root;
}

bool PoseGraph::solve() {
  for (int i = 0; T_map_nodes_.size() > 1 && i < params_.most_iterations; ++i) {
    double most_m = 0.0;
    double most_rad = 0.0;
    if (!move_nodes(most_m, most_rad)) {
      return false;
    }
    if (most_m < params_.least_step_m && most_rad < params_.least_step_rad) {
      break;
    }
  }
  return true;
}

bool PoseGraph::move_nodes(double& most_m, double& most_rad) {
  Equations equations(T_map_nodes_.size());
  for (const PoseEdge& edge : edges_) {
    const EdgeError off = edge_error(edge, T_map_nodes_[edge.from], T_map_nodes_[edge.to]);
    equations.add(edge, off, trust(edge, off.error.dot(edge.information * off.error)));
  }
  const Eigen::VectorXd step = equations.solved();
  if (step.size() == 0) {
    return false;
  }
  for (std::size_t node = 1; node < T_map_nodes_.size(); ++node) {
    const Eigen::Vector3d moved =
        step.segment<kPoseSize>(kPoseSize * static_cast<Eigen::Index>(node - 1));
    const Pose2& before = T_map_nodes_[node];
    T_map_nodes_[node] = {
        before.x_m() + moved.x(), before.y_m() + moved.y(), before.heading_rad() + moved.z()};
    most_m = std::max(most_m, moved.head<2>().norm());
    most_rad = std::max(most_rad, std::abs(moved.z()));
  }
  return true;
}

}  // namespace echomap::slam
