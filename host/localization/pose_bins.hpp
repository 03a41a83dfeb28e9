// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
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

  /// Of x, y (m) and heading (rad, in [-pi, pi]).
  PoseBin bin_at(const Eigen::Vector3d& pose) const;
  /// With a heading in [0, 2 pi).
  Eigen::Vector3d middle(PoseBin bin) const;

  /// The bin's number; the next free one where it is new.
  std::int32_t insert(PoseBin bin);
  /// -1 where no pose has fallen.
  std::int32_t find(PoseBin bin) const;
  PoseBin bin(std::int32_t number) const { return bins_[static_cast<std::size_t>(number)]; }
  std::size_t size() const { return bins_.size(); }
  /// The numbers of the bins around one that are there, at most 26.
  std::vector<std::int32_t> neighbours(std::int32_t number) const;

 private:
  std::size_t first_slot(PoseBin bin) const;
  void grow();

  double metres_;
  std::int32_t headings_;
  double radians_;
  std::vector<PoseBin> bins_;
  std::vector<std::int32_t> slots_ = std::vector<std::int32_t>(64, -1);
};

}  // namespace echomap::localization
