// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/pipeline/observation_sink.hpp"

namespace echomap::pipeline {

/// Hands all that it takes on to others, in the order in which they were added.
class ObservationFork final : public AnyObservationSink {
 public:
  /// `sink` outlives this, or is removed before.
  void add(ObservationSink& sink) { sinks_.push_back(&sink); }
  void remove(ObservationSink& sink) { std::erase(sinks_, &sink); }

  void on(const sensors::Observation& observation) override {
    for (ObservationSink* sink : sinks_) {
      hand_on(observation, *sink);
    }
  }

 private:
  std::vector<ObservationSink*> sinks_;
};

}  // namespace echomap::pipeline
