// SPDX-License-Identifier: MIT
#include "hil_mock/world/person.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace echomap::world {
namespace {

/// What is left between a person who waits and the robot.
constexpr double kCareM = 0.02;

}  // namespace

Person::Person(PersonParams params) : params_(std::move(params)) {
  if (params_.path_m.size() < 2 || !(params_.speed_m_per_s > 0.0) || !(params_.radius_m > 0.0)) {
    throw std::invalid_argument("person: a path of two points, a speed and a radius above 0");
  }
  at_m_ = params_.path_m.front();
}

void Person::step(double dt_s, double now_s, std::span<const Disc> robots) {
  if (now_s < params_.start_s || next_ == params_.path_m.size()) {
    return;
  }
  const Eigen::Vector2d offset_m = params_.path_m[next_] - at_m_;
  const double step_m = params_.speed_m_per_s * dt_s;
  const bool arrives = offset_m.norm() <= step_m;
  const Eigen::Vector2d there_m =
      arrives ? params_.path_m[next_] : Eigen::Vector2d(at_m_ + step_m * offset_m.normalized());
  if (is_blocked(there_m, robots)) {
    return;
  }
  at_m_ = there_m;
  next_ += arrives ? 1 : 0;
  place_ = Disc{at_m_, params_.radius_m};
  if (next_ == params_.path_m.size()) {
    place_.reset();
  }
}

/// Whether a step there would come too near to a robot; away from one it may always go.
bool Person::is_blocked(const Eigen::Vector2d& there_m, std::span<const Disc> robots) const {
  return std::ranges::any_of(robots, [&](const Disc& robot) {
    const double apart_m = (there_m - robot.middle_m).norm();
    const bool comes_nearer = !place_ || apart_m < (at_m_ - robot.middle_m).norm();
    return comes_nearer && apart_m < params_.radius_m + robot.radius_m + kCareM;
  });
}

}  // namespace echomap::world
