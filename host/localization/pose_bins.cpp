// SPDX-License-Identifier: MIT
#include "host/localization/pose_bins.hpp"

#include <cmath>
#include <numbers>

#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::localization {

namespace {

/// A table has so many slots for each bin, so that most are found at the first look.
constexpr std::size_t kSlotsPerBin = 4;

/// Also of what is no number.
[[gnu::always_inline]] inline float within_reach(float bins) {
  constexpr float kReach = 16.0e6F;
  const float above = bins > -kReach ? bins : -kReach;
  return above < kReach ? above : kReach;
}

[[gnu::always_inline]] inline std::int32_t floor_of(float value) {
  const auto whole = static_cast<std::int32_t>(value);
  return whole - (value < static_cast<float>(whole) ? 1 : 0);
}

ECHOMAP_VECTOR_CLONES
void locate_all(const float* __restrict values,
                std::size_t count,
                float bins_per_unit,
                std::int32_t* __restrict bins,
                float* __restrict offs) {
  for (std::size_t i = 0; i < count; ++i) {
    const float value = within_reach(values[i] * bins_per_unit);
    bins[i] = floor_of(value);
    offs[i] = (value - static_cast<float>(bins[i])) - 0.5F;
  }
}

/// The turn is closed: a heading below 0 counts from a turn on.
ECHOMAP_VECTOR_CLONES
void close_turn(std::size_t count, std::int32_t headings, std::int32_t* __restrict bins) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t up = bins[i] < 0 ? bins[i] + headings : bins[i];
    const std::int32_t below = up < headings ? up : headings - 1;
    bins[i] = below > 0 ? below : 0;
  }
}

}  // namespace

PoseBins::PoseBins(const PoseBinSize& size)
    : metres_(size.metres),
      headings_(static_cast<std::int32_t>(std::lround(2.0 * std::numbers::pi / size.radians))),
      radians_(2.0 * std::numbers::pi / headings_) {
  geometry::ParameterValidator("pose bins")
      .positive("metres", size.metres)
      .positive("radians", size.radians)
      .at_least("headings of so many radians", headings_, 1);
}

void PoseBins::locate(const Particles& particles,
                      ParticleRange range,
                      BinnedStretch& stretch) const {
  const auto bins_per_m = static_cast<float>(1.0 / metres_);
  const auto bins_per_rad = static_cast<float>(1.0 / radians_);
  const std::size_t count = range.size();
  locate_all(
      &particles.x_m[range.begin], count, bins_per_m, stretch.x.data(), stretch.off_x.data());
  locate_all(
      &particles.y_m[range.begin], count, bins_per_m, stretch.y.data(), stretch.off_y.data());
  locate_all(&particles.heading_rad[range.begin],
             count,
             bins_per_rad,
             stretch.heading.data(),
             stretch.off_heading.data());
  close_turn(count, headings_, stretch.heading.data());
}

std::int32_t PoseBins::insert_at(std::size_t slot, PoseBin bin) {
  const auto number = static_cast<std::int32_t>(bins_.size());
  slots_[slot] = {bin, number};
  bins_.push_back(bin);
  if (kSlotsPerBin * bins_.size() > slots_.size()) {
    grow();
  }
  return number;
}

void PoseBins::grow() {
  slots_.assign(2 * slots_.size(), {});
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    std::size_t slot = first_slot(bins_[i]);
    while (slots_[slot].number >= 0) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = {bins_[i], static_cast<std::int32_t>(i)};
  }
}

}  // namespace echomap::localization
