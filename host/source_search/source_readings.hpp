// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/source_search/field_model.hpp"

namespace echomap::source_search {

/// How readings of a robot's scalar sensor are placed. Values without another source are ours.
struct SourceReadingsParams {
  /// Of a sensor of pulses: for so long after one it notices no other (sensors::ScalarParams).
  double dead_time_s = 0.0;
  /// Readings in a row are one as long as they were taken within this distance of the first, and
  /// for no longer than this.
  double together_m = 0.05;
  double together_s = 2.0;
  /// Of a place against the map that was made from there, along each axis.
  double position_stddev_m = 0.03;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const SourceReadingsParams& params);

/// The part of a dwell in which a non-paralysable sensor could notice a pulse (Knoll 2010, section
/// 4.VII), seconds: the number of pulses stays what it is, so that its distribution does.
double live_time_s(double count, double dwell_s, double dead_time_s);

/// Gathers what a robot's scalar sensor reads and places it where the robot's trajectory has it
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

  /// All by the middle of their dwell on the trajectory, behind it at the latest pose, in the map
  /// frame, corrected for the dead time; the last of them once it is whole. Those from before the
  /// map, or from where the robot was carried, have no place and are left out.
  std::vector<FieldReading> placed(const pipeline::Snapshot& snapshot) const;
  /// From the first reading to the last, seconds.
  double elapsed_s() const;

 private:
  SourceReadingsParams params_;
  std::vector<sensors::ScalarObservation> observations_;
};

}  // namespace echomap::source_search
