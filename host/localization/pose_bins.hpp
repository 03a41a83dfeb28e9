// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "host/localization/particles.hpp"

namespace echomap::localization {

/// A box of poses: columns, rows and parts of a turn.
struct PoseBin {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t heading = 0;  ///< From 0; the turn is closed.

  bool operator==(const PoseBin&) const = default;
};

/// Size of a PoseBin; a whole number of headings goes into a turn, or the nearest that does.
struct PoseBinSize {
  double metres = 0.25;
  double radians = 0.2618;
};

/// Bins of a stretch of particles, and where in them these are: from the bin's middle, in bins.
struct BinnedStretch {
  static constexpr std::size_t kMost = 256;

  alignas(64) std::array<std::int32_t, kMost> x;
  alignas(64) std::array<std::int32_t, kMost> y;
  alignas(64) std::array<std::int32_t, kMost> heading;
  alignas(64) std::array<float, kMost> off_x;
  alignas(64) std::array<float, kMost> off_y;
  alignas(64) std::array<float, kMost> off_heading;

  PoseBin bin(std::size_t i) const { return {x[i], y[i], heading[i]}; }
};

/// The bins that poses fall into, numbered as they come: a hash table with open addressing.
class PoseBins {
 public:
  /// Throws std::invalid_argument for a size that is not above 0.
  explicit PoseBins(const PoseBinSize& size);

  /// Of at most BinnedStretch::kMost particles. What is more than 16 million bins off is as far as
  /// that.
  void locate(const Particles& particles, ParticleRange range, BinnedStretch& stretch) const;
  /// With a heading in [0, 2 pi).
  Eigen::Vector3d middle(PoseBin bin) const {
    return {(bin.x + 0.5) * metres_, (bin.y + 0.5) * metres_, (bin.heading + 0.5) * radians_};
  }
  /// In bins, the shorter way round.
  std::array<std::int32_t, 3> offset(PoseBin from, PoseBin to) const {
    const std::int32_t turn = to.heading - from.heading;
    const std::int32_t whole = 2 * turn > headings_    ? headings_
                               : 2 * turn < -headings_ ? -headings_
                                                       : 0;
    return {to.x - from.x, to.y - from.y, turn - whole};
  }
  /// Of a bin: m, m, rad.
  Eigen::Vector3d size_of_bin() const { return {metres_, metres_, radians_}; }

  /// The bin's number; the next free one where it is new.
  std::int32_t insert(PoseBin bin) {
    std::size_t slot = first_slot(bin);
    while (slots_[slot].number >= 0) {
      if (slots_[slot].bin == bin) {
        return slots_[slot].number;
      }
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return insert_at(slot, bin);
  }
  /// -1 where no pose has fallen.
  std::int32_t find(PoseBin bin) const {
    std::size_t slot = first_slot(bin);
    while (slots_[slot].number >= 0 && slots_[slot].bin != bin) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slots_[slot].number;
  }
  PoseBin bin(std::int32_t number) const { return bins_[static_cast<std::size_t>(number)]; }
  std::size_t size() const { return bins_.size(); }
  /// Calls visit(number of one, number of the other) for each pair of bins that touch, once.
  template <typename Visit>
  void for_neighbours(const Visit& visit) const {
    for (std::int32_t number = 0; number < static_cast<std::int32_t>(bins_.size()); ++number) {
      const PoseBin middle = bin(number);
      for (const auto& [dx, dy, turn] : kHalfAround) {
        const std::int32_t next = middle.heading + turn;
        const std::int32_t heading = next < headings_ ? next : next - headings_;
        const std::int32_t other = find({middle.x + dx, middle.y + dy, heading});
        if (other >= 0) {
          visit(number, other);
        }
      }
    }
  }

 private:
  struct Slot {
    PoseBin bin;
    std::int32_t number = -1;
  };

  /// One of each two ways that are opposite.
  static constexpr std::array<std::array<std::int32_t, 3>, 13> kHalfAround{{{1, 0, 0},
                                                                            {-1, 1, 0},
                                                                            {0, 1, 0},
                                                                            {1, 1, 0},
                                                                            {-1, -1, 1},
                                                                            {0, -1, 1},
                                                                            {1, -1, 1},
                                                                            {-1, 0, 1},
                                                                            {0, 0, 1},
                                                                            {1, 0, 1},
                                                                            {-1, 1, 1},
                                                                            {0, 1, 1},
                                                                            {1, 1, 1}}};

  std::size_t first_slot(PoseBin bin) const {
    const std::uint64_t mixed = static_cast<std::uint32_t>(bin.x) * 0x9E3779B97F4A7C15U +
                                static_cast<std::uint32_t>(bin.y) * 0xC2B2AE3D27D4EB4FU +
                                static_cast<std::uint32_t>(bin.heading) * 0x165667B19E3779F9U;
    return static_cast<std::size_t>((mixed ^ (mixed >> 29)) >> 16) & (slots_.size() - 1);
  }
  std::int32_t insert_at(std::size_t slot, PoseBin bin);
  void grow();

  double metres_;
  std::int32_t headings_;
  double radians_;
  std::vector<PoseBin> bins_;
  std::vector<Slot> slots_ = std::vector<Slot>(256);
};

}  // namespace echomap::localization
