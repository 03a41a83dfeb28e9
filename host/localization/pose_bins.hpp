// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

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

/// The bins that poses fall into, numbered as they come: a hash table with open addressing.
class PoseBins {
 public:
  /// Throws std::invalid_argument for a size that is not above 0.
  explicit PoseBins(const PoseBinSize& size);

  /// With a heading in [0, 2 pi].
  PoseBin bin_at(double x_m, double y_m, double heading_rad) const {
    const auto heading = static_cast<std::int32_t>(heading_rad * bins_per_rad_);
    return {floor_of(x_m * bins_per_m_),
            floor_of(y_m * bins_per_m_),
            heading < headings_ ? heading : 0};
  }
  /// With a heading in [0, 2 pi).
  Eigen::Vector3d middle(PoseBin bin) const {
    return {(bin.x + 0.5) * metres_, (bin.y + 0.5) * metres_, (bin.heading + 0.5) * radians_};
  }

  /// The bin's number; the next free one where it is new.
  std::int32_t insert(PoseBin bin);
  /// -1 where no pose has fallen.
  std::int32_t find(PoseBin bin) const;
  PoseBin bin(std::int32_t number) const { return bins_[static_cast<std::size_t>(number)]; }
  std::size_t size() const { return bins_.size(); }
  /// Calls visit(number of one, number of the other) for each pair of bins that touch, once.
  template <typename Visit>
  void for_neighbours(const Visit& visit) const {
    for (std::int32_t number = 0; number < static_cast<std::int32_t>(bins_.size()); ++number) {
      const PoseBin middle = bin(number);
      for (const auto& [dx, dy, turn] : kHalfAround) {
        const std::int32_t heading = (middle.heading + turn + headings_) % headings_;
        const std::int32_t other = find({middle.x + dx, middle.y + dy, heading});
        if (other >= 0) {
          visit(number, other);
        }
      }
    }
  }

 private:
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

  static std::int32_t floor_of(double value) {
    const auto whole = static_cast<std::int32_t>(value);
    return whole - (value < whole ? 1 : 0);
  }
  std::size_t first_slot(PoseBin bin) const;
  void grow();

  double metres_;
  std::int32_t headings_;
  double radians_;
  double bins_per_m_;
  double bins_per_rad_;
  std::vector<PoseBin> bins_;
  std::vector<std::int32_t> slots_ = std::vector<std::int32_t>(64, -1);
};

}  // namespace echomap::localization
