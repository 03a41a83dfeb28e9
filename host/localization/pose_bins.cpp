// SPDX-License-Identifier: MIT
#include "host/localization/pose_bins.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace echomap::localization {

PoseBins::PoseBins(const PoseBinSize& size)
    : metres_(size.metres),
      headings_(static_cast<std::int32_t>(std::lround(2.0 * std::numbers::pi / size.radians))),
      radians_(2.0 * std::numbers::pi / headings_),
      bins_per_m_(1.0 / metres_),
      bins_per_rad_(1.0 / radians_) {
  if (!(size.metres > 0.0) || !(size.radians > 0.0) || headings_ < 1) {
    throw std::invalid_argument("pose bins: a size is above 0, and at most a turn");
  }
}

std::int32_t PoseBins::insert(PoseBin bin) {
  std::size_t slot = first_slot(bin);
  while (slots_[slot] >= 0) {
    if (bins_[static_cast<std::size_t>(slots_[slot])] == bin) {
      return slots_[slot];
    }
    slot = (slot + 1) & (slots_.size() - 1);
  }
  const auto number = static_cast<std::int32_t>(bins_.size());
  slots_[slot] = number;
  bins_.push_back(bin);
  if (2 * bins_.size() > slots_.size()) {
    grow();
  }
  return number;
}

std::int32_t PoseBins::find(PoseBin bin) const {
  std::size_t slot = first_slot(bin);
  while (slots_[slot] >= 0 && bins_[static_cast<std::size_t>(slots_[slot])] != bin) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  return slots_[slot];
}

std::size_t PoseBins::first_slot(PoseBin bin) const {
  const std::uint64_t mixed = static_cast<std::uint32_t>(bin.x) * 0x9E3779B97F4A7C15U +
                              static_cast<std::uint32_t>(bin.y) * 0xC2B2AE3D27D4EB4FU +
                              static_cast<std::uint32_t>(bin.heading) * 0x165667B19E3779F9U;
  return static_cast<std::size_t>((mixed ^ (mixed >> 29)) >> 16) & (slots_.size() - 1);
}

void PoseBins::grow() {
  slots_.assign(2 * slots_.size(), -1);
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    std::size_t slot = first_slot(bins_[i]);
    while (slots_[slot] >= 0) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = static_cast<std::int32_t>(i);
  }
}

}  // namespace echomap::localization
