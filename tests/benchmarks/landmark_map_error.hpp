// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::bench {

/// A place as it is believed, and as it is.
using PlacePair = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/// The rigid motion that lays the believed places onto the true ones with the least sum of squares
/// (Arun, Huang and Blostein 1987; no scale). At least two pairs.
geometry::Pose2 laid_onto(std::span<const PlacePair> pairs);

/// Root mean square distance of the places, the believed ones moved by `T_true_believed`.
double rms_m(std::span<const PlacePair> pairs, const geometry::Pose2& T_true_believed);

}  // namespace echomap::bench
