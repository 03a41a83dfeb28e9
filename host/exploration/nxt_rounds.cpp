// SPDX-License-Identifier: MIT
#include "host/exploration/nxt_rounds.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {
namespace {

constexpr double kRoundingRad = 1e-9;

/// So many times the body turns until the pan has looked all round; a power of two, so that each
/// sector has as many of the readings.
int round_sectors(const NxtRoundsParams& params) {
  int sectors = 1;
  while (std::numbers::pi / sectors > params.pan_limit_rad + kRoundingRad) {
    sectors *= 2;
  }
  return sectors;
}

}  // namespace

NxtRounds::NxtRounds(const NxtRoundsParams& params) : params_(params) {
  geometry::ParameterValidator("nxt rounds")
      .positive("bearing_step_rad", params.bearing_step_rad)
      .at_least("pan_limit_rad", params.pan_limit_rad, 0.5 * params.bearing_step_rad)
      .positive("drive_m", params.drive_m);
}

Motion NxtRounds::next(const pipeline::Snapshot& /*snapshot*/, MotionResult last) {
  if (last == MotionResult::kLifted) {
    return Finished{FinishReason::kLifted};
  }
  if (motions_.empty()) {
    if (rounds_ == params_.rounds) {
      return Finished{FinishReason::kComplete};
    }
    begin_round();
  }
  const Motion motion = motions_.front();
  motions_.pop_front();
  return motion;
}

void NxtRounds::begin_round() {
  const int sectors = round_sectors(params_);
  const double sector_rad = geometry::kFullTurnRad / sectors;
  const double lowest = std::floor((params_.first_bearing_rad + 0.5 * sector_rad - kRoundingRad) /
                                   params_.bearing_step_rad);
  const double from_rad = params_.first_bearing_rad - lowest * params_.bearing_step_rad;
  const Sweep sweep{from_rad,
                    from_rad + sector_rad - params_.bearing_step_rad,
                    params_.bearing_step_rad,
                    params_.settle_s};
  if (rounds_ > 0) {
    motions_.emplace_back(Turn{params_.turn_rad});
    motions_.emplace_back(Drive{params_.drive_m});
  }
  motions_.emplace_back(BeginScan{});
  for (int sector = 0; sector < sectors; ++sector) {
    if (sector > 0) {
      motions_.emplace_back(Turn{sector_rad});
    }
    motions_.emplace_back(sweep);
  }
  motions_.emplace_back(EndScan{});
  ++rounds_;
}

std::vector<double> round_bearings_rad(const NxtRoundsParams& params) {
  std::vector<double> bearings_rad;
  for (double offset_rad = 0.0; offset_rad < geometry::kFullTurnRad - kRoundingRad;
       offset_rad += params.bearing_step_rad) {
    bearings_rad.push_back(params.first_bearing_rad + offset_rad);
  }
  return bearings_rad;
}

}  // namespace echomap::exploration
