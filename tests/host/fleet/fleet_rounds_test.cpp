// SPDX-License-Identifier: MIT
#include "host/fleet/fleet_rounds.hpp"

#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/fleet/fleet_exchange.hpp"
#include "tests/host/fleet/fleet_of_robots.hpp"

namespace echomap::fleet {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A robot that decides by what it has received, in rounds of half a second.
struct RoundsRobot {
  std::unique_ptr<tests::MemoryBus> bus;
  std::unique_ptr<FleetRounds> rounds;
  std::unique_ptr<FleetExchange> exchange;
  std::vector<std::string> received;  ///< What it knew after each round.
  std::uint32_t submaps = 0;
  bool has_ended = false;
};

class RoundsFleet {
 public:
  explicit RoundsFleet(const tests::MemoryBrokerParams& params)
      : broker_(params), random_(params.seed) {
    for (const char* name : {"r1", "r2", "r3"}) {
      add(name);
    }
  }

  /// All robots that live take that many rounds; false where they do not end.
  bool run(int rounds) {
    const std::uint32_t until = robots_.begin()->second.rounds->round() + rounds;
    for (int tick = 0; tick < 3000 * rounds; ++tick) {
      now_s_ += 0.02;
      broker_.advance_to(now_s_);
      bool is_done = true;
      for (auto& [name, robot] : robots_) {
        // Robots are unequally fast: nobody may depend on it.
        is_done = is_done && robot.rounds->round() >= until;
        if (random_() % 3 != 0) {
          continue;
        }
        if (robot.rounds->round() < until) {
          step(name, robot);
        } else {
          robot.rounds->poll(now_s_);
        }
      }
      if (is_done) {
        return true;
      }
    }
    return false;
  }

  tests::MemoryBroker& broker() { return broker_; }
  std::map<std::string, RoundsRobot>& robots() { return robots_; }
  void kill(const std::string& name) { robots_.erase(name); }

 private:
  void add(const std::string& name) {
    const FleetExchangeParams params = FleetOfRobots::params_of(name);
    RoundsRobot robot;
    robot.bus = broker_.client(name, last_will(params));
    robot.rounds = std::make_unique<FleetRounds>(
        *robot.bus, FleetRoundsParams{"hall", name, 1, {"r1", "r2", "r3"}, 2.0});
    robot.exchange = std::make_unique<FleetExchange>(*robot.rounds, params);
    robots_.emplace(name, std::move(robot));
  }
  void step(const std::string& name, RoundsRobot& robot) {
    if (!robot.has_ended) {
      if (robot.rounds->round() > 0) {
        act(name, robot);
      }
      robot.rounds->end_round();
      robot.has_ended = true;
    }
    robot.has_ended = !robot.rounds->poll(now_s_);
  }
  /// A claim that depends on all that was received, and now and then a submap.
  static void act(const std::string& name, RoundsRobot& robot) {
    robot.exchange->update(0.5 * robot.rounds->round());
    const FleetState state = robot.exchange->state();
    double sum = 0.0;
    std::string known = fleet_messages::hex(state.object_set);
    for (const FleetRobot& other : state.robots) {
      for (const auto& claim : other.claims) {
        sum += claim.at_m.x();
        known += " " + other.name + " " + std::to_string(claim.at_m.x());
      }
    }
    robot.received.push_back(known);
    robot.exchange->set_claims({{name, {std::fmod(1.0 + 1.7 * sum, 10.0), 0.0}, 1.0, 1.0}});
    if (robot.rounds->round() % 7 == static_cast<std::uint32_t>(name.back() - '0')) {
      std::mt19937 random(robot.submaps);
      robot.exchange->add_submap(random_submap(random, robot.submaps++));
    }
  }

  tests::MemoryBroker broker_;
  std::map<std::string, RoundsRobot> robots_;
  std::mt19937 random_;
  double now_s_ = 0.0;
};

tests::MemoryBrokerParams delays(std::uint32_t seed) {
  tests::MemoryBrokerParams params;
  params.seed = seed;
  params.max_delay_s = 0.3;
  params.repeat_share = 0.1;
  return params;
}

TEST(FleetRounds, MakeARunAFunctionOfItsSeed) {
  std::map<std::string, std::vector<std::string>> first;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    RoundsFleet fleet(delays(seed));
    ASSERT_TRUE(fleet.run(60));
    for (auto& [name, robot] : fleet.robots()) {
      ASSERT_EQ(robot.received.size(), 59U);
      if (seed == 1) {
        first[name] = robot.received;
        EXPECT_NE(robot.received.front(), robot.received.back());
      }
      EXPECT_EQ(robot.received, first[name]) << name << ", seed " << seed;
    }
  }
}

TEST(FleetRounds, GoOnWhereTheBrokerLosesSome) {
  tests::MemoryBrokerParams params = delays(1);
  params.loss_share = 0.02;
  RoundsFleet fleet(params);
  ASSERT_TRUE(fleet.run(20));
  fleet.broker().restart(1.0);
  EXPECT_TRUE(fleet.run(20));
}

TEST(FleetRounds, DoNotWaitForARobotThatIsGone) {
  RoundsFleet fleet(delays(2));
  ASSERT_TRUE(fleet.run(10));
  fleet.kill("r2");
  EXPECT_TRUE(fleet.run(10));
  EXPECT_THAT(fleet.robots().at("r1").rounds->waits_for(), testing::Not(testing::Contains("r2")));
}

TEST(FleetRounds, WaitForAllBeforeTheFirstOne) {
  tests::MemoryBroker broker;
  auto bus = broker.client("r1");
  FleetRounds rounds(*bus, {"hall", "r1", 1, {"r1", "r2"}, 2.0});
  rounds.subscribe("echomap/1/hall/#");
  rounds.end_round();
  EXPECT_FALSE(rounds.poll(0.0));
  EXPECT_FALSE(rounds.poll(0.1));
  EXPECT_THAT(rounds.waits_for(), ElementsAre("r2"));
  auto other_bus = broker.client("r2");
  FleetRounds other(*other_bus, {"hall", "r2", 1, {"r1", "r2"}, 2.0});
  other.subscribe("echomap/1/hall/#");
  other.end_round();
  other.poll(0.2);
  EXPECT_TRUE(other.poll(0.3)) << "the broker has kept the other one's clock";
  EXPECT_TRUE(rounds.poll(0.3));
  EXPECT_EQ(rounds.round(), 1U);
}

TEST(FleetRounds, LetARobotLeave) {
  tests::MemoryBroker broker;
  auto bus = broker.client("r1");
  auto other_bus = broker.client("r2");
  FleetRounds rounds(*bus, {"hall", "r1", 1, {"r1", "r2"}, 2.0});
  FleetRounds other(*other_bus, {"hall", "r2", 1, {"r1", "r2"}, 2.0});
  const auto finish = [&](double wall_s) {
    for (int i = 0; i < 3; ++i) {
      rounds.poll(wall_s);
      other.poll(wall_s);
    }
  };
  rounds.subscribe("echomap/1/hall/#");
  other.subscribe("echomap/1/hall/#");
  rounds.end_round();
  other.end_round();
  finish(0.0);
  ASSERT_EQ(rounds.round(), 1U);
  rounds.end_round();
  other.end_round(true);
  finish(0.1);
  ASSERT_EQ(rounds.round(), 2U);
  rounds.end_round();
  finish(0.2);
  EXPECT_EQ(rounds.round(), 3U) << "nobody waits for the other one";
}

TEST(FleetRounds, NeedAMemberAndNames) {
  tests::MemoryBroker broker;
  auto bus = broker.client("r1");
  EXPECT_THROW(FleetRounds(*bus, {"hall", "r1", 1, {"r2"}, 2.0}), std::invalid_argument);
  EXPECT_THROW(FleetRounds(*bus, {"hall", "r1", 1, {"r1", "R2"}, 2.0}), std::invalid_argument);
  EXPECT_THROW(FleetRounds(*bus, {"a hall", "r1", 1, {"r1"}, 2.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::fleet
