// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cell_values.hpp"
#include "host/exploration/company.hpp"
#include "host/exploration/unobserved_walls.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// The values are ours, chosen in simulation.
struct ViewGainParams {
  /// Unknown floor farther off than this is not counted: bearings of echoes are too poor.
  double reach_m = 2.5;
  /// Unknown floor counts 1/e at this distance.
  double fade_m = 4.0;
  /// A look from this distance counts 1/e of one from beside.
  double look_fade_m = 1.0;
  /// A look goes this deep into unknown floor: what lies behind is anybody's guess.
  double depth_m = 0.5;
  /// Unknown floor nearer to something occupied than this counts the less the nearer: most of it
  /// lies behind a wall of which only a part was seen.
  double beside_wall_m = 0.4;
  /// What each look that left it unknown leaves of the worth of a cell: behind most of it stands a
  /// wall.
  double left_by_look = 0.05;
  /// Behind an unknown island stands no wall: there a look counts by the share of the rim that is
  /// occupied (unknown_islands.hpp), and at least so much.
  double min_island_look = 0.1;
  /// The share of an island without any occupied rim that is floor.
  double island_floor = 0.7;
  /// A sweep nearer than this to an earlier one shows the less, the nearer it is: from the same
  /// place a sonar hears the same again.
  double novel_m = 0.3;
  UnobservedWallParams unobserved;
};

/// A sweep as it was made: from where, and the bearings that its beams covered.
struct PastView {
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();
  double middle_rad = 0.0;      ///< In the map frame.
  double half_width_rad = 0.0;  ///< Half of what the sweep covered, at most pi.

  bool covers(double bearing_rad) const;
};

/// What has been looked at: a view for each scan of a stop that has a reading, from where the map
/// has the stop now.
std::vector<PastView> views_of(const std::vector<mapping::Scan>& scans);

/// Where a sweep would show most.
struct BestView {
  double gain_m2 = 0.0;
  double middle_rad = 0.0;  ///< In the map frame.
  double width_rad = 0.0;
};

/// How much unknown floor a sweep from a place would show: rays run over free floor and into the
/// unknown until something occupied stops them, and what earlier sweeps have looked at in vain
/// counts less each time. So does the floor expected behind a wall that nobody has heard, which
/// only a sweep that faces it may show.
class ViewGain {
 public:
  /// Bearings are told apart in so many sectors of the full turn.
  static constexpr std::size_t kSectors = 72;

  /// `map` outlives this; `unobserved` are the walls on it that nobody has heard. Throws
  /// std::invalid_argument for invalid parameters.
  ViewGain(const mapping::RasterMap& map,
           const std::vector<PastView>& past,
           const std::vector<geometry::Segment>& unobserved,
           const ViewGainParams& params);

  /// Counts less what a look that somebody else makes is expected to show: a cell beside it not at
  /// all, and one at its reach in full (Burgard et al. 2005, with P(d) = 1 - d / reach).
  void leave_to(const PromisedLook& promised);

  /// Square metres by sector, from -pi on.
  std::vector<double> by_sector_m2(const Eigen::Vector2d& from_m) const;
  /// How much of an unknown cell of the map counts, from 0 to 1.
  double worth(geometry::CellIndex cell) const { return static_cast<double>(worth_[index(cell)]); }
  /// The share of an unknown cell that is expected to be floor, after all looks: what a look may
  /// not show may be floor all the same where an island has an open rim.
  double floor_share(geometry::CellIndex cell) const {
    return std::max(worth(cell),
                    params_.island_floor * (1.0 - static_cast<double>(occupied_rim_[cell])));
  }
  /// Walls that nobody has heard, with what is expected behind them after all looks.
  const std::vector<UnobservedWall>& unobserved() const { return unobserved_; }

 private:
  template <typename Visitor>
  void follow(const Eigen::Vector2d& from_m, double bearing_rad, Visitor&& visit) const;
  void weight_by_walls();
  void weight_by_looks();
  void look(const PastView& view);
  double novelty(const Eigen::Vector2d& from_m) const;
  std::size_t index(geometry::CellIndex cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(map_.columns()) +
           static_cast<std::size_t>(cell.x);
  }

  const mapping::RasterMap& map_;
  ViewGainParams params_;
  std::vector<float> worth_;         ///< By cell: 1 far from walls where nobody has looked.
  CellValues<float> occupied_rim_;   ///< By cell: the share of its island's rim.
  std::vector<float> looks_;         ///< By cell: how often it was looked at from beside.
  std::vector<std::uint32_t> seen_;  ///< By cell: the last view that has looked at it.
  std::uint32_t views_ = 0;
  std::vector<Eigen::Vector2d> looked_from_m_;
  std::vector<UnobservedWall> unobserved_;
  std::vector<double> shown_m2_;  ///< By step of a ray: what one unknown cell there adds.
  std::vector<float> look_;       ///< By step of a ray: how much of a look from beside it is.
};

/// The part of the gain within `width_rad`, where it is greatest.
BestView best_view(const std::vector<double>& by_sector_m2, double width_rad);

}  // namespace echomap::exploration
