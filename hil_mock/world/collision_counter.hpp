// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "hil_mock/world/robot_params.hpp"

namespace echomap::world {

/// How often walls have stopped the body.
struct Collisions {
  /// Met by a bumper, at no more than the speed of a drive.
  int bumps = 0;
  /// Met by the hull where no bumper is, or faster.
  int hard = 0;
};

/// Counts what pushes a body back. Touching one wall again within half a second is the same
/// collision, and hard where any part of it was.
class CollisionCounter {
 public:
  explicit CollisionCounter(const BodyParams& body) : body_(body) {}

  /// `push_m` is how far walls have pushed the body during `dt_s`, in the robot's frame.
  void note(const Eigen::Vector2d& push_m, double dt_s);

  const Collisions& collisions() const { return collisions_; }

 private:
  bool is_hard(const Eigen::Vector2d& push_m, double dt_s) const;

  BodyParams body_;
  Collisions collisions_;
  double free_s_ = 1e9;  ///< Since the last push.
  bool is_hard_ = false;
};

}  // namespace echomap::world
