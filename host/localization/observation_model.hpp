// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "host/geometry/pose2.hpp"
#include "host/localization/particles.hpp"
#include "host/localization/workers.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/models/contact_likelihood.hpp"

namespace echomap::localization {

/// One range reading relative to the current pose of the robot; the range is empty where nothing
/// returned.
struct RangeReading {
  geometry::Pose2 T_robot_sensor;
  std::optional<double> range_m;
};

/// How likely a sweep of range readings is from a pose in one map: what updates the particles'
/// weights.
class ObservationModel {
 public:
  ObservationModel() = default;
  ObservationModel(const ObservationModel&) = delete;
  ObservationModel& operator=(const ObservationModel&) = delete;
  virtual ~ObservationModel() = default;

  /// The map; a robot stands on its free cells.
  virtual const mapping::RasterMap& map() const = 0;

  /// Sets the state of bumper and virtual wall for the next updates; models of ranges ignore it.
  virtual void add_contact(const models::ContactReading& /*reading*/) {}

  /// Sets the sweep for the next weight updates.
  virtual void observe(std::span<const RangeReading> readings) = 0;
  /// Number of readings of that sweep that constrain the pose: those that is_usable accepts.
  virtual std::size_t count() const = 0;

  /// Prepares for a weight update of these particles.
  virtual void make_ready(const Particles& particles, const Workers& workers) = 0;

  /// Adds `temper` times the logarithm of the sweep's likelihood to each particle's weight: below 1
  /// where readings of one sweep are not independent of each other. Apart ranges may be weighed at
  /// once.
  virtual void update_weights(float likelihood_exponent,
                              ParticleRange range,
                              Particles& particles) const = 0;
};

}  // namespace echomap::localization
