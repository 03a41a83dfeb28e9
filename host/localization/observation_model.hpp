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

/// One reading of a range sensor, from where the robot is now; empty where nothing returned.
struct RangeReading {
  geometry::Pose2 T_robot_sensor;
  std::optional<double> range_m;
};

/// How likely a sweep of range readings is from a pose in one map: what particles are weighed by.
class ObservationModel {
 public:
  ObservationModel() = default;
  ObservationModel(const ObservationModel&) = delete;
  ObservationModel& operator=(const ObservationModel&) = delete;
  virtual ~ObservationModel() = default;

  /// A robot stands on free cells.
  virtual const mapping::RasterMap& map() const = 0;

  /// What bumper and virtual wall say from now on; of no use to models of ranges.
  virtual void feel(const models::ContactReading& /*reading*/) {}

  /// Takes the sweep that poses are weighed by from now on.
  virtual void observe(std::span<const RangeReading> readings) = 0;
  /// How many readings of that sweep say something. What is_usable refuses does not.
  virtual std::size_t count() const = 0;

  /// Makes ready to weigh particles that are where they are now.
  virtual void make_ready(const Particles& particles, const Workers& workers) = 0;

  /// Adds `temper` times the logarithm of the sweep's likelihood to each particle's weight: below 1
  /// where readings of one sweep are not independent of each other. Apart ranges may be weighed at
  /// once.
  virtual void weigh(float temper, ParticleRange range, Particles& particles) const = 0;
};

}  // namespace echomap::localization
