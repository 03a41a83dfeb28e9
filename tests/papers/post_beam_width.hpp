// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "host/sensors/beam_width.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::papers {

/// What stands before the sonar while its cone is measured.
struct PostBeamWidthParams {
  /// Distance to the post or the card, metres.
  double target_range_m = 1.0;
  /// What is heard within this of the distance is the target.
  double tolerance_m = 0.1;
  /// How wide the post is, metres: it sticks out of the cone by half of that on either side.
  double width_m = 0.0;
};

/// Opening of a cone from a sweep past a thin post: the angle between the two bearings at which the
/// post is heard half as often as on the axis. On each side the chance to hear it at b is
///
///     q + (p - q) / (1 + exp((|b - a| - e) / s)):                                         (1)
///
/// p on the axis, q beside the cone, the edge e with its softness s. The opening is the likeliest
/// sum of both edges, its bounds are where the likelihood's profile has fallen by 1.92
/// (chi-squared, one degree of freedom); all three less the angle that the post itself takes up.
///
/// Empty where the post was heard fewer than three times, or to one end of the sweep.
std::optional<sensors::BeamWidth> beam_width_past_post(std::span<const sensors::Beam> sweep,
                                                       const PostBeamWidthParams& params);

/// The same from a smooth card that is turned before a sonar which stands still; `bearing_rad` is
/// the angle between the sonar's axis and the card's perpendicular, of which one sign is enough. A
/// smooth card answers while its perpendicular lies in the cone, so that the opening is twice the
/// angle of the edge.
std::optional<sensors::BeamWidth> beam_width_by_tilt(std::span<const sensors::Beam> tilts,
                                                     const PostBeamWidthParams& params);

}  // namespace echomap::papers
