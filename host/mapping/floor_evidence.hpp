// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/cell_sums.hpp"
#include "host/mapping/stop_floor.hpp"

namespace echomap::mapping {

/// How much a stop's word on the floor counts. Ours, chosen in simulated rooms.
struct FloorEvidenceParams {
  /// Evidence at the stop's feet, in hundredths of log-odds.
  int free_centilogits = 220;
  /// It falls to 1/e at this distance, because an error of bearing counts the more the farther off.
  double fade_m = 6.0;
  /// What silence up to a known wall counts of it: something at a slant may be silent, too.
  double silent_share = 0.6;
};

/// Evidence for free floor, summed over stops. A stop that comes to know its floor better changes
/// only the cells in between.
class FloorEvidence {
 public:
  FloorEvidence(const FloorEvidenceParams& params, double resolution_m)
      : params_(params), resolution_m_(resolution_m) {}

  /// The floor around stop `index`, which counts in place of what it was before. Stops are numbered
  /// from 0 without gaps. One so far from the others that no memory would do counts nothing.
  void set(std::size_t index, const Eigen::Vector2d& center_m, const FloorReach& reach);
  /// Forgets the stops from that number on.
  void resize(std::size_t stops);

  /// Evidence of one stop at a distance, in hundredths of log-odds.
  int faded(double distance_m) const;
  /// The cells that may hold evidence.
  const CellBounds& bounds() const { return sums_.bounds(); }
  /// Summed evidence for floor, in hundredths of log-odds; not below 0.
  int centilogits(geometry::CellIndex cell) const { return sums_.at(cell); }

 private:
  struct Stop {
    Eigen::Vector2d center_m;
    FloorReach reach;
  };

  /// Replaces the profile of a stop between two steps, the second left out.
  void change(Stop& stop, const FloorReach& reach, std::size_t from, std::size_t to);
  void change_all(Stop& stop, const FloorReach& reach);
  /// What one stop adds to a cell in the direction of a step, in hundredths of log-odds.
  int evidence(const FloorReach& reach, std::size_t step, double distance_m) const;

  FloorEvidenceParams params_;
  double resolution_m_;
  std::deque<std::optional<Stop>> stops_;  ///< Large: growing must not move them.
  CellSums sums_;
};

}  // namespace echomap::mapping
