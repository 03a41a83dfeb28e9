// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/source_search/field_model.hpp"

namespace echomap::source_search {

/// How readings of a robot's scalar sensor are placed. Values without another source are ours.
struct SourceReadingsParams {
  /// Dead time of a sensor of pulses after each pulse (sensors::ScalarParams).
  double dead_time_s = 0.0;
  /// Consecutive readings are merged while they are within this distance of the first, and for no
  /// longer than this.
  double together_m = 0.05;
  double together_s = 2.0;
  /// Standard deviation of a reading's place against the map that was made from there, along each
  /// axis.
  double position_stddev_m = 0.03;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const SourceReadingsParams& params);

/// The part of a dwell in which a non-paralysable sensor could notice a pulse (Knoll 2010,
/// section 4.VII), seconds. The number of pulses is left as it is, so that its distribution is,
/// too.
double live_time_s(double count, double dwell_s, double dead_time_s);

/// Collects what a robot's scalar sensor reads, and places it where the robot's trajectory has it
/// now.
class SourceReadings final : public pipeline::ObservationSink {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit SourceReadings(const SourceReadingsParams& params);

  void on_odometry(const sensors::OdometryObservation& /*observation*/) override {}
  void on_sonar(const sensors::SonarObservation& /*observation*/) override {}
  void on_scalar(const sensors::ScalarObservation& observation) override;
  void begin_scan() override {}
  void end_scan() override {}

  /// All readings in the map frame, corrected for the dead time: placed on the trajectory by the
  /// middle of their dwell, behind its end at the latest pose. The last reading is included once it
  /// is complete. Those from before the map, or from while the robot was carried, are left out.
  std::vector<FieldReading> placed(const pipeline::Snapshot& snapshot) const;
  /// From the first reading to the last, seconds.
  double elapsed_s() const;

 private:
  SourceReadingsParams params_;
  std::vector<sensors::ScalarObservation> observations_;
};

}  // namespace echomap::source_search
