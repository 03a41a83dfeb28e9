// SPDX-License-Identifier: MIT
#include "host/pipeline/observation_sink.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace echomap::pipeline {
namespace {

/// Notes the kind of what it takes, by its place in the variant.
class Kinds final : public AnyObservationSink {
 public:
  void on(const sensors::Observation& observation) override {
    kinds.push_back(observation.index());
  }

  std::vector<std::size_t> kinds;
};

TEST(ObservationSink, EveryKindReachesTheFunctionForIt) {
  const std::vector<sensors::Observation> all{sensors::OdometryObservation{},
                                              sensors::SonarObservation{},
                                              sensors::HazardObservation{},
                                              sensors::InfraredObservation{},
                                              sensors::CarriedObservation{},
                                              sensors::PoseFixObservation{},
                                              sensors::YawObservation{},
                                              sensors::BatteryObservation{},
                                              sensors::EncoderErrorObservation{},
                                              sensors::ScalarObservation{},
                                              sensors::BeginScan{},
                                              sensors::EndScan{}};
  ASSERT_EQ(all.size(), std::variant_size_v<sensors::Observation>);
  Kinds sink;
  for (const sensors::Observation& observation : all) {
    hand_on(observation, sink);
    EXPECT_EQ(sink.kinds.back(), observation.index());
  }
  EXPECT_EQ(sink.kinds.size(), all.size());
}

}  // namespace
}  // namespace echomap::pipeline
