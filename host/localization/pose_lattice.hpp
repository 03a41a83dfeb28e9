// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/pose2.hpp"
#include "host/localization/observation_model.hpp"
#include "host/localization/particles.hpp"

namespace echomap::localization {

/// Poses around one: none, half a step and a whole one to each side in x, y and heading.
Particles poses_around(const geometry::Pose2& T_map_middle, double step_m, double step_rad);

/// Sets the natural logarithms of the likelihood of what the model observes, the sum over its
/// readings.
void set_log_likelihoods(ObservationModel& model, Particles& particles);

}  // namespace echomap::localization
