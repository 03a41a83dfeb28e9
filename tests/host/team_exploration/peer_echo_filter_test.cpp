// SPDX-License-Identifier: MIT
#include "host/team_exploration/peer_echo_filter.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/pipeline/observation_log.hpp"
#include "tests/host/team_exploration/team_rooms.hpp"

namespace echomap::team_exploration {
namespace {

using geometry::Pose2;
using tests::peer_at;

/// Keeps the last of each.
class LastSink final : public pipeline::AnyObservationSink {
 public:
  void on(const sensors::Observation& observation) override {
    if (const auto* one = std::get_if<sensors::SonarObservation>(&observation)) {
      sonar = *one;
    } else if (const auto* other = std::get_if<sensors::HazardObservation>(&observation)) {
      hazards = *other;
    } else {
      ++others;
    }
  }

  sensors::SonarObservation sonar;
  sensors::HazardObservation hazards;
  int others = 0;
};

class PeerEchoFilterTest : public ::testing::Test {
 protected:
  sensors::SonarObservation filtered(double pan_rad, std::optional<double> range_m) {
    sensors::SonarObservation observation;
    observation.pan_rad = pan_rad;
    observation.range_m = range_m;
    filter.on_sonar(observation);
    return sink.sonar;
  }

  LastSink sink;
  std::vector<Peer> peers{peer_at("b", {1.0, 0.0, 0.0})};
  PeerEchoFilter filter{
      sink, {}, [] { return Pose2(); }, [this](time::RobotTime) { return peers; }, {}};
};

/// The sonar sits 6 cm before the middle, and the hull's face 9 cm before the peer's.
constexpr double kToHullM = 1.0 - 0.06 - 0.09;

TEST_F(PeerEchoFilterTest, AnEchoOfAPeersHullIsNoInformation) {
  const auto reading = filtered(0.0, kToHullM);
  EXPECT_FALSE(reading.range_m);
  EXPECT_FALSE(reading.has_answered) << "silence would say that the floor is free";
  EXPECT_EQ(filter.echoes_of_peers(), 1U);
}

TEST_F(PeerEchoFilterTest, EchoesFromBeforeBehindAndBesideThePeerAreOfTheRoom) {
  EXPECT_TRUE(filtered(0.0, kToHullM - 0.15).range_m);
  EXPECT_TRUE(filtered(0.0, kToHullM + 0.25).range_m);
  EXPECT_TRUE(filtered(0.8, kToHullM).range_m);
  EXPECT_TRUE(filtered(0.0, std::nullopt).has_answered);
  EXPECT_EQ(filter.echoes_of_peers(), 0U);
}

TEST_F(PeerEchoFilterTest, ABeamsEdgeMeetsThePeerToo) {
  EXPECT_FALSE(filtered(0.25, kToHullM).range_m);
}

TEST_F(PeerEchoFilterTest, IsWiderWhereThePeersPlaceIsUnsure) {
  EXPECT_TRUE(filtered(0.0, kToHullM + 0.2).range_m);
  peers.front().position_stddev_m = 0.1;
  EXPECT_FALSE(filtered(0.0, kToHullM + 0.2).range_m);
}

TEST_F(PeerEchoFilterTest, AContactWithAPeerIsNone) {
  sensors::HazardObservation bump;
  bump.bump_left = true;
  filter.on_hazards(bump);
  EXPECT_TRUE(sink.hazards.is_touching()) << "the peer is far: it is a wall";
  peers.front().T_map_robot = Pose2(0.19, 0.0, 0.0);
  bump.cliffs[1] = true;
  filter.on_hazards(bump);
  EXPECT_FALSE(sink.hazards.is_touching());
  EXPECT_TRUE(sink.hazards.cliffs[1]);
  EXPECT_EQ(filter.contacts_with_peers(), 1U);
}

TEST_F(PeerEchoFilterTest, HandsOnAllElse) {
  filter.on_odometry({});
  filter.begin_scan();
  filter.end_scan();
  EXPECT_EQ(sink.others, 3);
}

TEST_F(PeerEchoFilterTest, RejectsParametersWithoutSense) {
  PeerEchoParams params;
  params.near_m = -0.1;
  EXPECT_THROW(PeerEchoFilter(sink, {}, nullptr, nullptr, params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::team_exploration
