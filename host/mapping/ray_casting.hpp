// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <Eigen/Core>

#include "host/mapping/distance_field.hpp"

namespace echomap::mapping {

/// How far rays run on a map before they enter an occupied cell. Each step goes as far as the
/// distance field says that nothing stands (sphere tracing, Hart 1996), and at least to the border
/// of the cell or of the clear square around it, so that the range is that of a border; eight rays
/// go at once, and four such groups by turns.

/// From `from_m`, in the map frame, along unit vectors: the range of each, or `max_m` where
/// nothing stands so near or the ray leaves the map first. The same for all when `from_m` is
/// outside of the map. Right to 1/500 of a cell; what a ray only clips by less than that may be
/// missed.
void cast_rays(const DistanceField& field,
               const Eigen::Vector2d& from_m,
               std::span<const Eigen::Vector2f> directions,
               double max_m,
               std::span<float> ranges_m);

}  // namespace echomap::mapping
