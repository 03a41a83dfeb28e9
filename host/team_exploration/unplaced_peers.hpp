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

/// When an echo is taken for one of a robot of which nobody knows where it is. Values are ours.
struct UnplacedPeerParams {
  /// Where the map has firm floor.
  mapping::ScanCheckParams floor;
  /// One robot's echoes at a stop follow each other: from one to the next at most so far,
  double next_m = 0.25;
  double next_rad = 0.45;
  /// and all of them over so much of the circle.
  double max_spread_rad = 1.4;
  /// A robot moves on: what is heard at one place for longer is a thing.
  double same_m = 0.2;
  double stays_s = 60.0;
};

/// Keeps robots whose maps are not joined yet out of a map, and out of what says that the map is
/// wrong: an echo from amid floor that two stops have seen, of one compact thing for each such
/// robot and stop, becomes a reading that says nothing. A robot that was carried off hears such
/// echoes from all around and goes on hearing them.
class UnplacedPeerFilter final : public pipeline::AnyObservationSink {
 public:
  /// What is known when a reading comes in.
  struct Surroundings {
    geometry::Pose2 T_map_robot;
    std::shared_ptr<const mapping::OccupancyGrid> grid;
    std::size_t unplaced = 0;  ///< So many robots are about, somewhere.
  };
  using Known = std::function<Surroundings()>;

  /// `sink` outlives this. Throws std::invalid_argument for invalid parameters.
  UnplacedPeerFilter(pipeline::ObservationSink& sink,
                     const sensors::RobotGeometry& robot,
                     Known known,
                     const UnplacedPeerParams& params);

  void on(const sensors::Observation& observation) override;

  /// Echoes that were taken for those of other robots.
  std::size_t echoes_of_peers() const { return echoes_; }

  /// Another map begins: places of the one before are none of it.
  void forget_places() { places_.clear(); }

 private:
  /// Echoes of one compact thing at this stop.
  struct Thing {
    mapping::PlacedReading last;
    double first_bearing_rad = 0.0;
  };
  /// Where such echoes came from.
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
