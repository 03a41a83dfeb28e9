// SPDX-License-Identifier: MIT
#include "host/team_exploration/unplaced_peers.hpp"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::team_exploration {
namespace {

using geometry::Pose2;

class LastReading final : public pipeline::AnyObservationSink {
 public:
  void on(const sensors::Observation& observation) override {
    if (const auto* one = std::get_if<sensors::SonarObservation>(&observation)) {
      reading = *one;
    }
  }
  sensors::SonarObservation reading;
};

/// Four metres of floor each way.
std::shared_ptr<mapping::OccupancyGrid> floor_of(int centilogits) {
  auto grid = std::make_shared<mapping::OccupancyGrid>();
  for (double y_m = -2.0; y_m <= 2.0; y_m += grid->resolution_m()) {
    for (double x_m = -2.0; x_m <= 2.0; x_m += grid->resolution_m()) {
      grid->add(grid->cell_at({x_m, y_m}), centilogits);
    }
  }
  return grid;
}

class UnplacedPeerFilterTest : public ::testing::Test {
 protected:
  UnplacedPeerFilterTest() { known.grid = floor_of(-300); }

  void stop_at(double now_s) {
    now_s_ = now_s;
    filter.begin_scan();
  }
  bool is_kept(double pan_rad, double range_m) {
    sensors::SonarObservation observation;
    observation.stamp =
        time::RobotTime(time::RobotClock::duration(static_cast<std::int64_t>(now_s_ * 1e6)));
    observation.pan_rad = pan_rad;
    observation.range_m = range_m;
    filter.on_sonar(observation);
    return sink.reading.has_answered;
  }

  LastReading sink;
  UnplacedPeerFilter::Surroundings known{Pose2(), nullptr, 1};
  UnplacedPeerFilter filter{sink, {}, [this] { return known; }, {}};

 private:
  double now_s_ = 0.0;
};

TEST_F(UnplacedPeerFilterTest, TakesOneCompactThingAmidFloorForARobot) {
  stop_at(0.0);
  EXPECT_FALSE(is_kept(0.0, 1.0));
  EXPECT_FALSE(is_kept(0.1, 1.02));
  EXPECT_FALSE(is_kept(0.2, 0.98));
  EXPECT_FALSE(sink.reading.range_m);
  EXPECT_EQ(filter.echoes_of_peers(), 3U);
}

TEST_F(UnplacedPeerFilterTest, KeepsAllEchoesWhereItKnowsWhereAllAre) {
  known.unplaced = 0;
  stop_at(0.0);
  EXPECT_TRUE(is_kept(0.0, 1.0));
}

TEST_F(UnplacedPeerFilterTest, KeepsEchoesThatAreNotOnFirmFloor) {
  stop_at(0.0);
  EXPECT_TRUE(is_kept(0.0, 2.3)) << "beyond what is known";
  known.grid = floor_of(-150);
  EXPECT_TRUE(is_kept(0.0, 1.0)) << "one stop may have been deceived";
}

/// A robot that was carried off.
TEST_F(UnplacedPeerFilterTest, KeepsAllButOneThingForEachRobot) {
  stop_at(0.0);
  int dropped = 0;
  for (int i = 0; i < 60; ++i) {
    dropped += is_kept(i * 2.0 * std::numbers::pi / 60.0, 1.0) ? 0 : 1;
  }
  EXPECT_GT(dropped, 0);
  EXPECT_LT(dropped, 30);
  EXPECT_TRUE(is_kept(std::numbers::pi, 1.5)) << "a second thing at the stop";
  known.unplaced = 2;
  EXPECT_FALSE(is_kept(std::numbers::pi, 1.5));
}

TEST_F(UnplacedPeerFilterTest, KeepsAThingThatStays) {
  for (const double now_s : {0.0, 20.0, 40.0}) {
    stop_at(now_s);
    EXPECT_FALSE(is_kept(0.0, 1.0)) << now_s;
  }
  stop_at(70.0);
  EXPECT_TRUE(is_kept(0.0, 1.0));
  EXPECT_FALSE(is_kept(0.0, 1.5)) << "a robot elsewhere";
}

TEST_F(UnplacedPeerFilterTest, RefusesInvalidParameters) {
  UnplacedPeerParams params;
  params.next_m = 0.0;
  EXPECT_THROW(UnplacedPeerFilter(
                   sink, {}, [this] { return known; }, params),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::team_exploration
