// SPDX-License-Identifier: MIT
#include "host/team_exploration/unplaced_peers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/echo_arc.hpp"
#include "host/time/robot_seconds.hpp"

namespace echomap::team_exploration {

namespace {

double axis_rad(const mapping::PlacedReading& reading) { return reading.T_map_sonar.heading_rad(); }

}  // namespace

UnplacedPeerFilter::UnplacedPeerFilter(pipeline::ObservationSink& sink,
                                       const sensors::RobotGeometry& robot,
                                       Known known,
                                       const UnplacedPeerParams& params)
    : sink_(sink), robot_(robot), known_(std::move(known)), params_(params) {
  geometry::ParameterValidator("unplaced peers")
      .positive("next_m", params.next_m)
      .positive("next_rad", params.next_rad)
      .at_least("max_spread_rad", params.max_spread_rad, params.next_rad)
      .positive("same_m", params.same_m)
      .at_least("stays_s", params.stays_s, 0.0);
}

void UnplacedPeerFilter::on(const sensors::Observation& observation) {
  if (std::holds_alternative<sensors::BeginScan>(observation)) {
    things_.clear();
  }
  const auto* sonar = std::get_if<sensors::SonarObservation>(&observation);
  if (sonar == nullptr || !is_of_peer(*sonar)) {
    pipeline::hand_on(observation, sink_);
    return;
  }
  ++echoes_;
  sensors::SonarObservation silenced = *sonar;
  silenced.range_m.reset();
  silenced.has_answered = false;
  sink_.on_sonar(silenced);
}

bool UnplacedPeerFilter::is_of_peer(const sensors::SonarObservation& observation) {
  if (!observation.range_m) {
    return false;
  }
  const Surroundings known = known_();
  const mapping::PlacedReading reading{
      known.T_map_robot,
      known.T_map_robot * robot_.T_robot_sonar(observation.pan_rad),
      observation.range_m};
  if (known.unplaced == 0 || !mapping::arc_of(reading, *known.grid, params_.floor)
                                  .is_firm_floor(params_.floor.max_other_share)) {
    return false;
  }
  const auto thing = std::find_if(
      things_.begin(), things_.end(), [&](const Thing& one) { return is_next_of(one, reading); });
  const bool is_new = thing == things_.end();
  if (is_new && things_.size() >= known.unplaced) {
    return false;
  }
  const double now_s = time::robot_seconds(observation.stamp);
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): it has a range
  if (has_stayed(*mapping::echo_point_m(reading), now_s)) {
    return false;
  }
  if (is_new) {
    things_.push_back({reading, axis_rad(reading)});
  } else {
    thing->last = reading;
  }
  return true;
}

bool UnplacedPeerFilter::is_next_of(const Thing& thing,
                                    const mapping::PlacedReading& reading) const {
  const auto off_rad = [&](double from_rad) {
    return std::abs(geometry::angle_between(from_rad, axis_rad(reading)));
  };
  return std::abs(*thing.last.range_m - *reading.range_m) <= params_.next_m &&
         off_rad(axis_rad(thing.last)) <= params_.next_rad &&
         off_rad(thing.first_bearing_rad) <= params_.max_spread_rad;
}

bool UnplacedPeerFilter::has_stayed(const Eigen::Vector2d& echo_m, double now_s) {
  const auto place = std::find_if(places_.begin(), places_.end(), [&](const Place& one) {
    return (one.at_m - echo_m).norm() <= params_.same_m;
  });
  if (place == places_.end()) {
    places_.push_back({echo_m, now_s});
    return false;
  }
  return now_s - place->first_s > params_.stays_s;
}

}  // namespace echomap::team_exploration
