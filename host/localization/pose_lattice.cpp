// SPDX-License-Identifier: MIT
#include "host/localization/pose_lattice.hpp"

#include <algorithm>
#include <cstddef>

#include "host/geometry/angle.hpp"

namespace echomap::localization {

Particles poses_around(const geometry::Pose2& T_map_middle, double step_m, double step_rad) {
  constexpr int kSide = 2;
  constexpr std::size_t kAcross = 2 * kSide + 1;
  Particles particles;
  particles.resize(kAcross * kAcross * kAcross);
  std::size_t i = 0;
  for (int x = -kSide; x <= kSide; ++x) {
    for (int y = -kSide; y <= kSide; ++y) {
      for (int turn = -kSide; turn <= kSide; ++turn) {
        particles.set_pose(
            i++,
            {T_map_middle.x_m() + 0.5 * step_m * x,
             T_map_middle.y_m() + 0.5 * step_m * y,
             geometry::wrap_angle(T_map_middle.heading_rad() + 0.5 * step_rad * turn)});
      }
    }
  }
  return particles;
}

void set_log_likelihoods(ObservationModel& model, Particles& particles) {
  model.make_ready(particles, Workers());
  std::fill(particles.log_weight.begin(), particles.log_weight.end(), 0.0F);
  model.update_weights(1.0F, {0, particles.size()}, particles);
}

}  // namespace echomap::localization
