// SPDX-License-Identifier: MIT
#include "host/exploration/round_sweep.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {

namespace {

/// Angles given in degrees are whole numbers of steps only up to rounding.
constexpr double kRoundingRad = 1e-9;
/// Ours, chosen in simulated rooms (docs/algorithms/frontier.md).
constexpr double kFirstStopDivisor = 4.0;

/// So many does the body have to turn to, for the pan to read all round.
int sectors_of(const RoundSweepParams& params) {
  return static_cast<int>(std::ceil(std::numbers::pi / params.pan_limit_rad - kRoundingRad));
}

/// From the sector ahead on, one beside the other; after all round it begins again.
std::deque<Motion> sweep_of(const RoundSweepParams& params, bool turned_left, int sectors) {
  const auto rounds = static_cast<int>(std::lround(params.scan_rad / geometry::kFullTurnRad));
  const double sector_rad = geometry::kFullTurnRad / sectors_of(params);
  Sweep sweep{
      -sector_rad / 2.0, sector_rad / 2.0 - params.step_rad, params.step_rad, params.settle_s};

  std::deque<Motion> motions{BeginScan{}};
  for (int sector = 0; sector < sectors; ++sector) {
    if (sector > 0) {
      motions.emplace_back(Turn{turned_left ? -sector_rad : sector_rad});
    }
    for (int round = 0; round < rounds; ++round) {
      motions.emplace_back(sweep);
      std::swap(sweep.from_rad, sweep.to_rad);
      sweep.step_rad = -sweep.step_rad;
    }
  }
  motions.emplace_back(EndScan{});
  return motions;
}

}  // namespace

bool is_full_turn(double angle_rad) { return angle_rad >= geometry::kFullTurnRad - kRoundingRad; }

bool is_possible(const RoundSweepParams& params) {
  return is_full_turn(params.scan_rad) && params.step_rad > 0.0 &&
         params.pan_limit_rad >= params.step_rad && params.settle_s >= 0.0;
}

std::deque<Motion> round_sweep(const RoundSweepParams& params, bool turned_left) {
  return sweep_of(params, turned_left, sectors_of(params));
}

std::deque<Motion> stop_sweep(RoundSweepParams params, std::size_t stops, bool turned_left) {
  const int sectors = sectors_of(params);
  if (stops > 0) {
    return sweep_of(params, turned_left, sectors);
  }
  params.step_rad /= kFirstStopDivisor;
  return sweep_of(params, turned_left, sectors > 1 ? sectors + 1 : sectors);
}

}  // namespace echomap::exploration
