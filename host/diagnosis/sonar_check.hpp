// SPDX-License-Identifier: MIT
#pragma once

#include "host/pipeline/observation_sink.hpp"

namespace echomap::diagnosis {

/// Notices a sonar that does not answer its triggers: an HC-SR04 always raises its echo line, also
/// where nothing is in reach.
class SonarCheck final : public pipeline::ObservationSink {
 public:
  /// Triggers in a row without an answer that make a dead sonar.
  static constexpr int kMaxUnanswered = 3;

  void on_odometry(const sensors::OdometryObservation& /*observation*/) override {}
  void on_sonar(const sensors::SonarObservation& observation) override {
    unanswered_ = observation.has_answered ? 0 : unanswered_ + 1;
  }
  void begin_scan() override {}
  void end_scan() override {}

  bool is_dead() const { return unanswered_ >= kMaxUnanswered; }

 private:
  int unanswered_ = 0;  ///< In a row.
};

}  // namespace echomap::diagnosis
