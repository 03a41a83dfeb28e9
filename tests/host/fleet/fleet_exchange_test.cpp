// SPDX-License-Identifier: MIT
#include "host/fleet/fleet_exchange.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/fleet_messages/payload.hpp"
#include "tests/host/fleet/fleet_of_robots.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::fleet {
namespace {

using fleet_messages::RefusedReason;

std::size_t refused(const FleetExchange& exchange, RefusedReason reason) {
  return exchange.statistics().received.refused[static_cast<std::size_t>(reason)];
}

TEST(FleetExchange, PublishesToAllOthersWhatARobotHasMade) {
  FleetOfRobots fleet;
  for (const char* name : {"r1", "r2", "r3"}) {
    fleet.add(name);
  }
  for (int stop = 0; stop < 3; ++stop) {
    fleet.stop_once("r1");
    fleet.stop_once("r3");
    fleet.run(20.0);
  }
  EXPECT_TRUE(fleet.is_same(6));
  const FleetRobot r3 = robot_in(fleet["r1"].state(), "r3");
  EXPECT_EQ(r3.attendance, Attendance::kAlive);
  EXPECT_NEAR(r3.traits.body_radius_m, 0.1, 1e-9);
  ASSERT_EQ(r3.maps.size(), 1U);
  EXPECT_EQ(r3.maps[0].record->robot, "r3");
  EXPECT_EQ(r3.maps[0].record->submaps.size(), 3U);
  EXPECT_EQ(r3.maps[0].record->T_map_submaps.size(), 3U);
  EXPECT_NEAR(r3.maps[0].record->body_radius_m, 0.1, 1e-9);
  EXPECT_EQ(fleet["r1"].unconfirmed(), 0U);
}

TEST(FleetExchange, GivesTheRobotItselfWhatAllOthersHave) {
  FleetOfRobots fleet;
  FleetExchange& r1 = fleet.add("r1");
  FleetExchange& r2 = fleet.add("r2");
  const auto used = r1.add_submap(random_submap(fleet.random(), 0));
  ASSERT_TRUE(used);
  r1.set_graph({{0.1234567, 0.0, 1.0}}, Eigen::Matrix3d::Zero());
  fleet.run(10.0);
  const auto of_own = robot_in(r1.state(), "r1").maps.at(0).record;
  const auto of_other = robot_in(r2.state(), "r1").maps.at(0).record;
  ASSERT_EQ(of_own->submaps.size(), 1U);
  ASSERT_EQ(of_other->submaps.size(), 1U);
  for (std::size_t i = 0; i < used->readings.size(); ++i) {
    EXPECT_EQ(used->readings[i].range_m, of_own->submaps[0].readings[i].range_m);
    EXPECT_EQ(used->readings[i].range_m, of_other->submaps[0].readings[i].range_m);
  }
  EXPECT_EQ(of_own->T_map_submaps[0].x_m(), 0.123);
  EXPECT_EQ(of_other->T_map_submaps[0].x_m(), 0.123);
}

TEST(FleetExchange, PublishesPoseClaimsSourceReadingsSearchAndAlignment) {
  FleetOfRobots fleet;
  FleetExchange& r1 = fleet.add("r1");
  FleetExchange& r2 = fleet.add("r2");
  fleet.run(1.0);
  r1.set_pose({{1.0, 2.0, 0.5}, 0.01 * Eigen::Matrix3d::Identity()}, 17.5);
  r1.set_claims({{"r1", {3.0, 4.0}, 0.05, 2.0}});
  r1.set_alignment({{"r1", 0, {}, {}}, {"r2", 0, {1.0, 0.0, 0.0}, {}}});
  ASSERT_TRUE(r1.add_source_batch({0, {{10.0, {}, 12.0, 3.0}}}));
  ASSERT_TRUE(r1.set_search({source_search::SourceVerdict::kNone,
                             0.95,
                             Eigen::Vector2d::Zero(),
                             0.0,
                             {{{3.0, 4.0}, 2.0}}}));
  fleet.run(5.0);
  const FleetRobot received = robot_in(r2.state(), "r1");
  ASSERT_TRUE(received.pose);
  EXPECT_NEAR(received.pose->estimate.T_map_robot.y_m(), 2.0, 1e-9);
  EXPECT_NEAR(received.pose->stamp_s, 17.5, 1e-9);
  EXPECT_NEAR(received.pose->age_s, 4.8, 0.3);
  ASSERT_EQ(received.claims.size(), 1U);
  EXPECT_NEAR(received.claims[0].at_m.x(), 3.0, 1e-9);
  ASSERT_EQ(received.alignment.size(), 2U);
  ASSERT_EQ(received.maps.size(), 1U);
  ASSERT_EQ(received.maps[0].source_batches->size(), 1U);
  EXPECT_EQ(received.maps[0].source_batches->at(0).readings[0].value, 12.0);
  EXPECT_EQ(robot_in(r1.state(), "r1").claims.size(), 1U) << "it knows of itself";
  ASSERT_TRUE(received.search);
  EXPECT_EQ(received.search->verdict, source_search::SourceVerdict::kNone);
  EXPECT_EQ(received.search->plan.size(), 1U);
  EXPECT_FALSE(robot_in(r1.state(), "r2").search) << "it does not search";
  r1.leave();
  fleet.run(2.0);
  const FleetRobot left = robot_in(r2.state(), "r1");
  EXPECT_EQ(left.search->verdict, source_search::SourceVerdict::kNone) << "its answer stays";
  EXPECT_TRUE(left.search->plan.empty()) << "it reads no more";
}

TEST(FleetExchange, SendsAPoseOnceASecondAndSeldomAtRest) {
  FleetOfRobots fleet;
  FleetExchange& r1 = fleet.add("r1");
  fleet.run(1.0);
  const auto messages_in = [&](double seconds, double speed_m_per_s) {
    const std::size_t before = r1.statistics().sent.messages;
    for (int step = 0; step < 10 * seconds; ++step) {
      r1.set_pose({{speed_m_per_s * fleet.now_s(), 0.0, 0.0}, Eigen::Matrix3d::Zero()}, 0.0);
      fleet.run(0.1);
    }
    return r1.statistics().sent.messages - before;
  };
  const std::size_t heartbeats = 12;
  EXPECT_NEAR(static_cast<double>(messages_in(60.0, 0.2)), 60.0 + heartbeats, 8.0);
  EXPECT_NEAR(static_cast<double>(messages_in(60.0, 0.0)), 6.0 + heartbeats, 2.0);
}

TEST(FleetExchange, ShowsWhoHasLeftAndWhoIsGone) {
  FleetOfRobots fleet;
  for (const char* name : {"r1", "r2", "r3", "r4"}) {
    fleet.add(name).set_claims({{name, {1.0, 1.0}, 1.0, 1.0}});
    fleet.stop_once(name);
  }
  fleet.run(10.0);
  const auto attendance = [&](const std::string& name) {
    return robot_in(fleet["r1"].state(), name).attendance;
  };
  fleet["r2"].leave();
  fleet.run(0.5);
  fleet.robot("r2").bus->disconnect();
  fleet.kill("r3");
  fleet.run(0.5);
  EXPECT_EQ(attendance("r2"), Attendance::kLeft);
  EXPECT_EQ(attendance("r3"), Attendance::kGone) << "its will has come";
  EXPECT_EQ(attendance("r4"), Attendance::kAlive);
  EXPECT_TRUE(robot_in(fleet["r1"].state(), "r3").claims.empty()) << "its claims are given back";
  EXPECT_EQ(robot_in(fleet["r1"].state(), "r4").claims.size(), 1U);
  EXPECT_EQ(fleet["r1"].state().objects, 4U) << "what they have made stays";
}

TEST(FleetExchange, MissesARobotWithoutAWillByItsHeartbeat) {
  FleetOfRobots fleet;
  fleet.add("r1");
  fleet.add("r2");
  fleet.run(10.0);
  fleet.robot("r2").bus->disconnect();  // As behind a broker that was killed.
  fleet.run(10.0);
  EXPECT_EQ(robot_in(fleet["r1"].state(), "r2").attendance, Attendance::kAlive);
  fleet.run(10.0);
  EXPECT_EQ(robot_in(fleet["r1"].state(), "r2").attendance, Attendance::kGone);
}

TEST(FleetExchange, GivesALateJoinerEverything) {
  FleetOfRobots fleet;
  fleet.add("r1");
  fleet.add("r2");
  for (int stop = 0; stop < 40; ++stop) {
    fleet.stop_once("r1");
    fleet.run(15.0);
  }
  fleet["r2"].leave();
  fleet.run(1.0);
  fleet.robot("r2").bus->disconnect();
  fleet.kill("r2");
  fleet.add("late");
  fleet.run(20.0);
  EXPECT_TRUE(fleet.is_same(40));
  EXPECT_EQ(robot_in(fleet["late"].state(), "r1").maps.at(0).record->submaps.size(), 40U);
  EXPECT_EQ(robot_in(fleet["late"].state(), "r1").attendance, Attendance::kAlive);
  EXPECT_EQ(robot_in(fleet["late"].state(), "r2").attendance, Attendance::kLeft);
}

TEST(FleetExchange, PublishesAgainWhatTheBrokerHasForgotten) {
  FleetOfRobots fleet;
  fleet.add("r1");
  fleet.add("r2");
  for (int stop = 0; stop < 10; ++stop) {
    fleet.stop_once("r1");
    fleet.run(15.0);
  }
  fleet.broker().restart(1.0);
  fleet.run(60.0);
  EXPECT_EQ(fleet["r1"].unconfirmed(), 0U);
  EXPECT_GE(fleet["r1"].statistics().sent.published_again, 10U);
  fleet.add("late");
  fleet.run(20.0);
  EXPECT_TRUE(fleet.is_same(10));
}

TEST(FleetExchange, DoesNotPublishAgainWhatTheBrokerHas) {
  FleetOfRobots fleet;
  fleet.add("r1");
  for (int stop = 0; stop < 10; ++stop) {
    fleet.stop_once("r1");
    fleet.run(15.0);
  }
  fleet.broker().restart(0.0);
  fleet.run(60.0);
  EXPECT_EQ(fleet["r1"].statistics().sent.published_again, 0U);
}

TEST(FleetExchange, RelaysWhatARobotHasPublishedThatIsGone) {
  FleetOfRobots fleet;
  for (const char* name : {"r1", "r2", "r3"}) {
    fleet.add(name);
  }
  for (int stop = 0; stop < 5; ++stop) {
    fleet.stop_once("r3");
    fleet.run(15.0);
  }
  fleet.kill("r3");
  fleet.run(5.0);
  fleet.broker().restart(1.0);
  fleet.run(120.0);
  fleet.add("late");
  fleet.run(20.0);
  EXPECT_TRUE(fleet.is_same(5));
  const FleetRobot gone = robot_in(fleet["late"].state(), "r3");
  EXPECT_EQ(gone.attendance, Attendance::kGone);
  ASSERT_EQ(gone.maps.size(), 1U);
  EXPECT_EQ(gone.maps[0].record->submaps.size(), 5U);
  EXPECT_NEAR(gone.maps[0].record->body_radius_m, 0.1, 1e-9);
  EXPECT_GT(fleet["r1"].statistics().relays, 0U);
  EXPECT_EQ(fleet["r2"].statistics().relays, 0U) << "the first one does it";
}

TEST(FleetExchange, TakesBackWhatItPassedOnWhenTheAuthorIsBack) {
  FleetOfRobots fleet;
  fleet.add("r1");
  fleet.add("r2");
  fleet.stop_once("r2");
  fleet.run(15.0);
  const auto relays = [&] {
    std::size_t count = 0;
    for (const auto& [topic, payload] : fleet.broker().retained()) {
      count += topic.find("/relay/") == std::string::npos ? 0 : 1;
    }
    return count;
  };
  fleet.broker().cut("r2");
  fleet.broker().restart(1.0);
  fleet.run(60.0);
  EXPECT_GT(relays(), 0U);
  fleet.broker().resume("r2");
  fleet.run(60.0);
  EXPECT_EQ(relays(), 0U);
  EXPECT_TRUE(fleet.is_same(1));
}

TEST(FleetExchange, RequestsWhatDidNotCome) {
  tests::MemoryBrokerParams lossy;
  lossy.loss_share = 0.3;
  FleetOfRobots bad(lossy);
  bad.add("r1");
  bad.add("r2");
  for (int stop = 0; stop < 20; ++stop) {
    bad.stop_once("r1");
    bad.stop_once("r2");
    bad.run(20.0);
  }
  EXPECT_TRUE(bad.run_until_same(300.0, 40));
  EXPECT_GT(bad["r1"].statistics().requests + bad["r2"].statistics().requests, 0U);
}

TEST(FleetExchange, StaysBelowItsBudget) {
  FleetOfRobots fleet;
  FleetExchange& r1 = fleet.add("r1");
  fleet.add("r2");
  for (int stop = 0; stop < 200; ++stop) {
    fleet.stop_once("r1");
  }
  double latest_pose_age_s = 0.0;
  for (int second = 0; second < 60; ++second) {
    r1.set_pose({{0.2 * second, 0.0, 0.0}, Eigen::Matrix3d::Zero()}, second);
    fleet.run(1.0);
    const auto pose = robot_in(fleet["r2"].state(), "r1").pose;
    latest_pose_age_s = second < 5 || !pose ? 0.0 : std::max(latest_pose_age_s, pose->age_s);
  }
  const double burst_bytes = FleetExchangeParams().burst_bytes;
  EXPECT_LT(static_cast<double>(r1.statistics().sent.bytes), 60.0 * 1000.0 + burst_bytes);
  EXPECT_GT(static_cast<double>(r1.statistics().sent.bytes), 55.0 * 1000.0) << "it is used";
  EXPECT_LE(latest_pose_age_s, 5.0) << "poses overtake what waits";
  EXPECT_GT(fleet["r2"].state().objects, 60U) << "objects get their share";
  EXPECT_TRUE(fleet.run_until_same(200.0, 200));
}

TEST(FleetExchange, RefusesAndCountsWhatIsNotRight) {
  FleetOfRobots fleet;
  FleetExchange& r1 = fleet.add("r1");
  FleetExchange& r2 = fleet.add(FleetOfRobots::params_of("r2", 5));
  auto stranger = fleet.broker().client("stranger");
  stranger->subscribe("echomap/1/#");
  r2.set_claims({{"r2", {1.0, 1.0}, 1.0, 1.0}});
  fleet.run(2.0);
  stranger->take();
  r2.set_claims({{"r2", {2.0, 2.0}, 1.0, 1.0}});
  fleet.run(1.0);
  std::string old_claim;
  for (const auto& message : stranger->take()) {
    old_claim = message.topic == "echomap/1/hall/r2/claim" ? message.payload : old_claim;
  }
  ASSERT_FALSE(old_claim.empty());
  r2.set_claims({{"r2", {3.0, 3.0}, 1.0, 1.0}});
  fleet.run(1.0);
  const auto publish = [&](const std::string& topic, const std::string& payload) {
    stranger->publish(topic, payload, mqtt::Delivery::kAtLeastOnce, false);
    fleet.run(0.5);
  };
  publish("echomap/1/hall/r2/claim", old_claim);
  EXPECT_EQ(refused(r1, RefusedReason::kReplayed), 1U);
  publish("echomap/1/hall/r3/claim", old_claim);
  EXPECT_EQ(refused(r1, RefusedReason::kForeignAuthor), 1U);
  publish("echomap/1/hall/r2/pose", old_claim);
  EXPECT_EQ(refused(r1, RefusedReason::kWrongTopic), 1U);
  publish("echomap/1/hall/r2/claim", std::string(20000, '\x01'));
  EXPECT_EQ(refused(r1, RefusedReason::kTooLarge), 1U);
  publish("echomap/1/hall/r2/claim", old_claim.substr(0, 20));
  EXPECT_EQ(refused(r1, RefusedReason::kDamaged), 1U);
  const auto former =
      fleet_messages::encode({{"r2", 4, 100}, fleet_messages::ClaimMessage{0, {{9, 9, 9, 9}}}});
  publish("echomap/1/hall/r2/claim", *former);
  EXPECT_EQ(refused(r1, RefusedReason::kOldBoot), 1U);
  EXPECT_NEAR(robot_in(r1.state(), "r2").claims.at(0).at_m.x(), 3.0, 1e-9) << "none was taken in";
}

TEST(FleetExchange, AcceptsNoRelayOfARobotThatIsHere) {
  FleetOfRobots fleet;
  FleetExchange& r1 = fleet.add("r1");
  fleet.add("r2");
  fleet.run(5.0);
  fleet_messages::FleetMessage forged;
  forged.sender.robot = "r2";
  forged.body = fleet_messages::to_message(random_submap(fleet.random(), 0), 0).value();
  const std::string payload = fleet_messages::encode(forged).value();
  auto stranger = fleet.broker().client("r3");
  stranger->take();
  stranger->publish(
      fleet_messages::format_topic(
          {"hall", "r3", fleet_messages::TopicKind::kRelay, fleet_messages::content_hash(payload)}),
      payload,
      mqtt::Delivery::kAtLeastOnce,
      true);
  fleet.run(1.0);
  EXPECT_EQ(r1.statistics().received.ignored_relays, 1U);
  EXPECT_EQ(r1.state().objects, 0U);
}

TEST(FleetExchange, IsTheSourceAgainAfterARestartWithItsFolder) {
  const tests::ScratchFolder folder;
  FleetOfRobots fleet;
  FleetExchangeParams params = FleetOfRobots::params_of("r1");
  params.folder = folder.path();
  fleet.add(params);
  for (int stop = 0; stop < 4; ++stop) {
    fleet.stop_once("r1");
    fleet.run(10.0);
  }
  EXPECT_EQ(fleet["r1"].map_number(), 0);
  fleet.kill("r1");
  fleet.broker().restart(1.0);
  params.boot_id = 2;
  fleet.add(params);
  EXPECT_EQ(fleet["r1"].map_number(), 1) << "another map, as odometry starts again";
  fleet.stop_once("r1");
  fleet.add("late");
  EXPECT_TRUE(fleet.run_until_same(60.0, 5));
  const FleetRobot received = robot_in(fleet["late"].state(), "r1");
  ASSERT_EQ(received.maps.size(), 2U);
  EXPECT_EQ(received.maps[0].record->submaps.size(), 4U);
  EXPECT_EQ(received.maps[1].record->submaps.size(), 1U);
}

TEST(FleetExchange, IsReceivedThoughItsClockWasSetBack) {
  FleetOfRobots fleet;
  const FleetExchange& other = fleet.add("r2");
  fleet.add(FleetOfRobots::params_of("r1", 5000));
  fleet.stop_once("r1");
  fleet.run(20.0);
  fleet.kill("r1");
  fleet.add(FleetOfRobots::params_of("r1", 70));
  fleet.run(5.0);
  fleet.stop_once("r1");
  fleet.run(20.0);
  EXPECT_EQ(refused(other, RefusedReason::kOldBoot), 0U);
  const FleetRobot received = robot_in(other.state(), "r1");
  EXPECT_EQ(received.attendance, Attendance::kAlive);
  ASSERT_EQ(received.maps.size(), 2U);
  EXPECT_EQ(received.maps[1].record->submaps.size(), 1U);
}

TEST(FleetExchange, IsTheSourceAgainOfWhatTheBrokerHasKept) {
  FleetOfRobots fleet;
  fleet.add("r1");
  fleet.stop_once("r1");
  fleet.stop_once("r1");
  fleet.run(20.0);
  fleet.kill("r1");
  fleet.add(FleetOfRobots::params_of("r1", 2));
  fleet.run(10.0);
  EXPECT_EQ(fleet["r1"].map_number(), 1);
  fleet.broker().restart(1.0);
  fleet.add("late");
  EXPECT_TRUE(fleet.run_until_same(60.0, 2));
}

TEST(FleetExchange, BeginsAnotherMapForARobotThatWasCarried) {
  FleetOfRobots fleet;
  FleetExchange& r1 = fleet.add("r1");
  fleet.add("r2");
  fleet.stop_once("r1");
  r1.begin_map();
  fleet.robot("r1").submaps = 0;
  fleet.robot("r1").T_map_submaps.clear();
  fleet.stop_once("r1");
  EXPECT_TRUE(fleet.run_until_same(30.0, 2));
  const FleetRobot received = robot_in(fleet["r2"].state(), "r1");
  EXPECT_EQ(received.map_number, 1);
  ASSERT_EQ(received.maps.size(), 2U);
  EXPECT_EQ(received.maps[0].record->submaps.size(), 1U);
  EXPECT_EQ(received.maps[1].record->submaps.size(), 1U);
}

TEST(FleetExchange, RefusesWhatDoesNotFit) {
  FleetOfRobots fleet;
  FleetExchange& r1 = fleet.add("r1");
  team_map::Submap submap = random_submap(fleet.random(), 0);
  submap.readings[0].range_m = 1e9;
  EXPECT_FALSE(r1.add_submap(submap));
  submap.readings.clear();
  EXPECT_FALSE(r1.add_submap(submap));
  EXPECT_FALSE(r1.add_source_batch({}));
  EXPECT_FALSE(r1.set_graph({{1e9, 0.0, 0.0}}, Eigen::Matrix3d::Zero()));
  EXPECT_EQ(r1.state().objects, 0U);
}

TEST(LastWill, IsAPresenceWithTheStateGone) {
  const mqtt::LastWill will = last_will(FleetOfRobots::params_of("r1", 7));
  EXPECT_EQ(will.topic, "echomap/1/hall/r1/presence");
  EXPECT_TRUE(will.retain);
  const auto decoded = fleet_messages::decode(will.topic, will.payload);
  const auto& message = std::get<fleet_messages::TopicMessage>(decoded).message;
  EXPECT_EQ(std::get<fleet_messages::PresenceMessage>(message.body).state, 2);
  EXPECT_EQ(message.sender.boot_id, 7U);
}

}  // namespace
}  // namespace echomap::fleet
