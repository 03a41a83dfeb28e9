// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "host/mapping/ray_mask.hpp"

namespace echomap::mapping {

/// Where the rays of a scan stand so close together that they cross every cell.
///
/// Rays a and b with an angle g < 90 degrees between them, and a cell between them whose centre is
/// c cells from the sensor: the nearer ray passes the centre within c sin(g / 2). Where c <=
/// cot(g), which is below 1 / (2 sin(g / 2)), that is less than half a cell. So a ray crosses the
/// inside of the cell, as long as neither is shorter than c. A scan whose rays follow each other
/// all around thus crosses every cell of a quadrant up to the least such c of all neighbours that
/// the quadrant has a part of.
class RayFan {
 public:
  /// Takes the rays of a scan, in its order, from the sensor to their ends, none of which is the
  /// sensor's place. In any other order nothing is taken to be crossed.
  void reset(std::span<const LatticePoint> directions);

  /// How far from the sensor, in lattice units, cells have their centres all of which are crossed.
  double radius(Quadrant quadrant) const { return radii_[static_cast<std::size_t>(quadrant)]; }
  /// For each ray the share of its way, from the sensor on, on which it only crosses such cells, or
  /// the sensor's; none if not above 0.
  std::span<const double> covered_shares() const { return shares_; }

 private:
  void find_radii(bool is_clockwise);
  void open_gap(std::size_t ray, bool is_clockwise);

  std::array<double, 4> radii_{};
  /// The first ray is there once more in the end.
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> lengths_;
  /// For a ray and the next: how far they cross all between them; negative where they are too far
  /// apart.
  std::vector<double> reaches_;
  std::vector<double> shares_;
};

}  // namespace echomap::mapping
