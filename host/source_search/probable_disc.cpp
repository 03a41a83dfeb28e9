// SPDX-License-Identifier: MIT
#include "host/source_search/probable_disc.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::source_search {

using geometry::CellIndex;
using mapping::CellField;

namespace {

/// Resolution of distances.
constexpr double kBinM = 0.01;
/// Discs are tried around cells that hold at least so much of what the most probable one does.
constexpr float kMinCellShare = 0.2F;
/// Number of points that represent a normal error in the plane.
constexpr int kErrorRings = 10;
constexpr int kErrorBearings = 12;
/// Cells that hold less do not count for it.
constexpr float kNegligibleCell = 1e-7F;

/// Those whose middles are within the radius of that of the cell (0, 0).
std::vector<CellIndex> disc_cells(double radius_m, double resolution_m) {
  const auto reach = static_cast<std::int32_t>(radius_m / resolution_m + 1e-9);
  std::vector<CellIndex> cells;
  for (std::int32_t y = -reach; y <= reach; ++y) {
    for (std::int32_t x = -reach; x <= reach; ++x) {
      if (std::hypot(x, y) * resolution_m <= radius_m + 1e-9) {
        cells.push_back({x, y});
      }
    }
  }
  return cells;
}

double sum_around(const CellField& field, CellIndex middle, const std::vector<CellIndex>& offsets) {
  double sum = 0.0;
  for (const CellIndex& offset : offsets) {
    const CellIndex cell{middle.x + offset.x, middle.y + offset.y};
    sum += field.holds(cell) ? static_cast<double>(field[field.index(cell)]) : 0.0;
  }
  return sum;
}

}  // namespace

ProbableDisc most_probable_disc(const CellField& probability, double radius_m) {
  float max = 0.0F;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    max = std::max(max, probability[i]);
  }
  const auto offsets = disc_cells(radius_m, probability.resolution_m());
  ProbableDisc best;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    if (probability[i] <= 0.0F || probability[i] < kMinCellShare * max) {
      continue;
    }
    const CellIndex cell = probability.cell(i);
    const double sum = sum_around(probability, cell, offsets);
    if (sum > best.probability) {
      best = {probability.center_m(cell), sum};
    }
  }
  return best;
}

double sum_in_disc(const CellField& field, const Eigen::Vector2d& middle_m, double radius_m) {
  return sum_around(field, field.cell_at(middle_m), disc_cells(radius_m, field.resolution_m()));
}

/// By errors that are as likely as each other, on rings.
CellField with_error(const CellField& probability, double stddev_m) {
  if (stddev_m <= 0.0) {
    return probability;
  }
  CellField blurred(probability.bounds(), probability.resolution_m());
  constexpr float kShare = 1.0F / (kErrorRings * kErrorBearings);
  for (int ring = 0; ring < kErrorRings; ++ring) {
    const double error_m = stddev_m * std::sqrt(-2.0 * std::log(1.0 - (ring + 0.5) / kErrorRings));
    for (int i = 0; i < kErrorBearings; ++i) {
      const Eigen::Vector2d off_m =
          error_m * geometry::unit_vector(geometry::kFullTurnRad * i / kErrorBearings);
      for (std::size_t from = 0; from < probability.size(); ++from) {
        if (probability[from] <= kNegligibleCell) {
          continue;
        }
        const CellIndex cell =
            blurred.cell_at(probability.center_m(probability.cell(from)) + off_m);
        if (blurred.holds(cell)) {
          blurred[blurred.index(cell)] += kShare * probability[from];
        }
      }
    }
  }
  return blurred;
}

double radius_with_share_m(const CellField& probability,
                           const Eigen::Vector2d& middle_m,
                           double share) {
  std::vector<double> by_distance;
  double total = 0.0;
  for (std::size_t i = 0; i < probability.size(); ++i) {
    if (probability[i] <= 0.0F) {
      continue;
    }
    const double distance_m = (probability.center_m(probability.cell(i)) - middle_m).norm();
    const auto bin = static_cast<std::size_t>(distance_m / kBinM + 0.5);
    by_distance.resize(std::max(by_distance.size(), bin + 1));
    by_distance[bin] += static_cast<double>(probability[i]);
    total += static_cast<double>(probability[i]);
  }
  double inside = 0.0;
  for (std::size_t bin = 0; bin < by_distance.size(); ++bin) {
    inside += by_distance[bin];
    if (inside >= share * total) {
      return static_cast<double>(bin) * kBinM;
    }
  }
  return 0.0;
}

}  // namespace echomap::source_search
