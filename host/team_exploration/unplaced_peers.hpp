// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/scan_check.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::team_exploration {

/// When an echo is attributed to a robot whose place is unknown. Values are ours.
struct UnplacedPeerParams {
  /// When floor of the map is firm.
  mapping::ScanCheckParams floor;
  /// Largest differences of range and bearing from one echo of a robot at a stop to the next,
  double next_m = 0.25;
  double next_rad = 0.45;
  /// and largest spread of the bearings of all of them.
  double max_spread_rad = 1.4;
  /// An echo from one place, within same_m, for longer than stays_s is from an object: a robot
  /// moves on.
  double same_m = 0.2;
  double stays_s = 60.0;
};

/// Keeps robots whose maps are not joined yet out of a map, and out of the evidence that the map is
/// wrong: an echo from amid floor that two stops have seen becomes a reading without information,
/// for one compact object per such robot and stop. A robot that was carried off receives such
/// echoes from all around, and continues to.
class UnplacedPeerFilter final : public pipeline::AnyObservationSink {
 public:
  /// What is known when a reading arrives.
  struct Surroundings {
    geometry::Pose2 T_map_robot;
    std::shared_ptr<const mapping::OccupancyGrid> grid;
    std::size_t unplaced = 0;  ///< Number of robots at unknown places.
  };
  using Known = std::function<Surroundings()>;

  /// `sink` outlives this. Throws std::invalid_argument for invalid parameters.
  UnplacedPeerFilter(pipeline::ObservationSink& sink,
                     const sensors::RobotGeometry& robot,
                     Known known,
                     const UnplacedPeerParams& params);

  void on(const sensors::Observation& observation) override;

  /// Number of echoes that were attributed to other robots.
  std::size_t echoes_of_peers() const { return echoes_; }

  /// Forgets all places of echoes, because another map begins.
  void forget_places() { places_.clear(); }

 private:
  /// Echoes of one compact object at this stop.
  struct Thing {
    mapping::PlacedReading last;
    double first_bearing_rad = 0.0;
  };
  /// A place where such echoes came from.
  struct Place {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    double first_s = 0.0;
  };

  bool is_of_peer(const sensors::SonarObservation& observation);
  bool is_next_of(const Thing& thing, const mapping::PlacedReading& reading) const;
  bool has_stayed(const Eigen::Vector2d& echo_m, double now_s);

  pipeline::ObservationSink& sink_;
  sensors::RobotGeometry robot_;
  Known known_;
  UnplacedPeerParams params_;
  std::vector<Thing> things_;  ///< Of the stop.
  std::vector<Place> places_;  ///< Of all stops.
  std::size_t echoes_ = 0;
};

}  // namespace echomap::team_exploration
