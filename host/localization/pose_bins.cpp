// SPDX-License-Identifier: MIT
#include "host/localization/pose_bins.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace echomap::localization {

PoseBins::PoseBins(const PoseBinSize& size)
    : metres_(size.metres),
      headings_(static_cast<std::int32_t>(std::lround(2.0 * std::numbers::pi / size.radians))),
      radians_(2.0 * std::numbers::pi / headings_) {
  if (!(size.metres > 0.0) || !(size.radians > 0.0) || headings_ < 1) {
    throw std::invalid_argument("pose bins: a size is above 0, and at most a turn");
  }
}

PoseBin PoseBins::bin_at(const Eigen::Vector3d& pose) const {
  const auto heading = static_cast<std::int32_t>(std::floor(pose.z() / radians_));
  return {static_cast<std::int32_t>(std::floor(pose.x() / metres_)),
          static_cast<std::int32_t>(std::floor(pose.y() / metres_)),
          (heading + headings_) % headings_};
}

Eigen::Vector3d PoseBins::middle(PoseBin bin) const {
  return {(bin.x + 0.5) * metres_, (bin.y + 0.5) * metres_, (bin.heading + 0.5) * radians_};
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

std::vector<std::int32_t> PoseBins::neighbours(std::int32_t number) const {
  const PoseBin middle = bin(number);
  std::vector<std::int32_t> found;
  for (std::int32_t dy = -1; dy <= 1; ++dy) {
    for (std::int32_t dx = -1; dx <= 1; ++dx) {
      for (std::int32_t turn = -1; turn <= 1; ++turn) {
        const std::int32_t heading = (middle.heading + turn + headings_) % headings_;
        const std::int32_t other = find({middle.x + dx, middle.y + dy, heading});
        if (other >= 0 && other != number) {
          found.push_back(other);
        }
      }
    }
  }
  return found;
}

std::size_t PoseBins::first_slot(PoseBin bin) const {
  std::uint64_t mixed = static_cast<std::uint32_t>(bin.x);
  mixed = mixed * 0x9E3779B97F4A7C15U + static_cast<std::uint32_t>(bin.y);
  mixed = mixed * 0x9E3779B97F4A7C15U + static_cast<std::uint32_t>(bin.heading);
  mixed *= 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>(mixed >> 32) & (slots_.size() - 1);
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
