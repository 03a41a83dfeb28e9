// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/mapping/cell_field.hpp"

namespace echomap::source_search {

/// A disc and the sum of a field in it.
struct ProbableDisc {
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  double probability = 0.0;
};

/// The disc of that radius around the middle of a cell that has the largest sum of probabilities,
/// among the cells that are themselves more probable. Cells count by their middles.
ProbableDisc most_probable_disc(const mapping::CellField& probability, double radius_m);

/// The sum in the disc of that radius around the middle of the cell that `middle_m` is in.
double sum_in_disc(const mapping::CellField& field,
                   const Eigen::Vector2d& middle_m,
                   double radius_m);

/// Spreads a probability field by a normal error along each axis. What falls out of the field is
/// lost.
mapping::CellField with_error(const mapping::CellField& probability, double stddev_m);

/// The radius of the smallest disc around a point that holds that share of a field's sum; 0 where
/// that is 0.
double radius_with_share_m(const mapping::CellField& probability,
                           const Eigen::Vector2d& middle_m,
                           double share);

}  // namespace echomap::source_search
