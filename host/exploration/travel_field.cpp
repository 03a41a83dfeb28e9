// SPDX-License-Identifier: MIT
#include "host/exploration/travel_field.hpp"

#include <array>

namespace echomap::exploration {

namespace {

/// Lengths of a step to the side and across, in sevenths of about sqrt(2): 7 / 5 = 1.4.
constexpr std::uint32_t kSide = 5;
constexpr std::uint32_t kAcross = 7;
/// More than the dearest step, which is across two cells of cost 255, and a power of two.
constexpr std::size_t kBuckets = 4096;
static_assert(kBuckets > std::size_t{2} * kAcross * 255);

}  // namespace

void TravelField::search(const CostGrid& grid, geometry::CellIndex from) {
  columns_ = grid.columns();
  rows_ = grid.rows();
  // A step costs its length by the sum of both cells' costs.
  metres_per_unit_ = grid.resolution_m() / (kSide * 2.0 * CostGrid::kPlain);
  costs_.assign(grid.costs().size(), kUnreached);
  buckets_.resize(kBuckets);
  if (!grid.is_open(from)) {
    return;
  }
  const auto& prices = grid.costs();
  const std::int32_t up = grid.stride();
  struct Step {
    std::int32_t offset;
    std::uint32_t length;
  };
  const std::array<Step, 8> steps{{{1, kSide},
                                   {-1, kSide},
                                   {up, kSide},
                                   {-up, kSide},
                                   {up + 1, kAcross},
                                   {up - 1, kAcross},
                                   {1 - up, kAcross},
                                   {-1 - up, kAcross}}};
  costs_[grid.index(from)] = 0;
  buckets_[0].push_back(static_cast<std::uint32_t>(grid.index(from)));
  std::size_t waiting = 1;
  const auto try_step = [&](std::uint32_t at, std::uint32_t cost, const Step& step) {
    const auto to = static_cast<std::uint32_t>(static_cast<std::int32_t>(at) + step.offset);
    const std::uint32_t reached = cost + step.length * (prices[at] + prices[to]);
    if (prices[to] != 0 && reached < costs_[to]) {
      costs_[to] = reached;
      buckets_[reached % kBuckets].push_back(to);
      ++waiting;
    }
  };
  for (std::uint32_t cost = 0; waiting > 0; ++cost) {
    auto& bucket = buckets_[cost % kBuckets];
    waiting -= bucket.size();
    // No step is free of cost, so nothing is added to the bucket meanwhile.
    for (const std::uint32_t at : bucket) {
      if (costs_[at] != cost) {
        continue;
      }
      for (const Step& step : steps) {
        try_step(at, cost, step);
      }
    }
    bucket.clear();
  }
}

std::optional<double> TravelField::cost_m(geometry::CellIndex cell) const {
  if (cell.x < 0 || cell.x >= columns_ || cell.y < 0 || cell.y >= rows_) {
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(cell.y + 1) * static_cast<std::size_t>(columns_ + 2) +
                     static_cast<std::size_t>(cell.x + 1);
  const std::uint32_t cost = costs_[index];
  return cost == kUnreached ? std::nullopt : std::optional(cost * metres_per_unit_);
}

}  // namespace echomap::exploration
