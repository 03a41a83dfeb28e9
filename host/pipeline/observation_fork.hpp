// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "host/pipeline/observation_sink.hpp"

namespace echomap::pipeline {

/// Hands all that it takes on to others, in the order in which they were added.
class ObservationFork final : public AnyObservationSink {
 public:
  /// `sink` outlives this, or is removed before.
  void add(ObservationSink& sink) { sinks_.push_back(&sink); }
  void remove(ObservationSink& sink) { std::erase(sinks_, &sink); }
  /// `other` takes the place of `sink`; does nothing without that.
  void replace(ObservationSink& sink, ObservationSink& other) {
    std::replace(sinks_.begin(), sinks_.end(), &sink, &other);
  }

  void on(const sensors::Observation& observation) override {
    for (ObservationSink* sink : sinks_) {
      hand_on(observation, *sink);
    }
  }

 private:
  std::vector<ObservationSink*> sinks_;
};

}  // namespace echomap::pipeline
