// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/host/fleet/fleet_of_robots.hpp"
#include "tests/support/every_seed.hpp"

// Whatever a broker and a network do to four robots, all of them end with the same.
namespace echomap::fleet {
namespace {

class FleetWithFaults {
 public:
  explicit FleetWithFaults(std::uint32_t seed) : fleet_(broker_params(seed)), random_(seed + 1000) {
    for (const char* name : {"r1", "r2", "r3", "r4"}) {
      fleet_.add(name);
    }
  }

  /// Ten minutes of stops and faults.
  void explore() {
    for (int step = 0; step < 40; ++step) {
      for (auto& [name, robot] : fleet_.robots()) {
        if (random_() % 2 == 0) {
          fleet_.stop_once(name);
          robot.exchange->set_claims({{name, {0.1 * step, 0.0}, 1.0, 1.0}});
        }
      }
      happen(step);
      fleet_.run(15.0);
    }
    end_cut();
  }

  FleetOfRobots& fleet() { return fleet_; }

 private:
  static tests::MemoryBrokerParams broker_params(std::uint32_t seed) {
    tests::MemoryBrokerParams params;
    params.seed = seed;
    params.max_delay_s = seed % 3 == 0 ? 2.0 : 0.2;
    params.loss_share = seed % 2 == 0 ? 0.01 : 0.0;
    params.repeat_share = 0.05;
    return params;
  }

  void happen(int step) {
    const double share = static_cast<double>(random_()) / 4294967296.0;
    switch (random_() % 6) {
      case 0:
        fleet_.broker().restart(share < 0.3 ? 1.0 : share);
        break;
      case 1:
        end_cut();
        cut_ = "r" + std::to_string(1 + random_() % 3);
        cut_until_ = step + 4;  // A minute.
        fleet_.broker().cut(cut_);
        break;
      case 2:
        if (step == 20 || (step > 20 && !is_killed_)) {
          is_killed_ = true;
          fleet_.kill("r4");
        }
        break;
      default:
        break;
    }
    if (!cut_.empty() && step >= cut_until_) {
      end_cut();
    }
  }
  void end_cut() {
    if (!cut_.empty()) {
      fleet_.broker().resume(cut_);
    }
    cut_.clear();
  }

  FleetOfRobots fleet_;
  std::mt19937 random_;
  std::string cut_;
  int cut_until_ = 0;
  bool is_killed_ = false;
};

TEST(FleetWithFaults, EndsWithTheSameObjectsAndGraphsOnAllRobots) {
  const std::uint32_t seeds = tests::runs_every_seed() ? 400 : 40;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    FleetWithFaults faults(seed);
    faults.explore();
    FleetOfRobots& fleet = faults.fleet();
    fleet.add("late");
    ASSERT_TRUE(fleet.run_until_same(600.0)) << "seed " << seed;
    // Of a robot that was killed some may be known to nobody.
    const std::size_t known = fleet["late"].state().objects;
    EXPECT_LE(known, fleet.made()) << "seed " << seed;
    EXPECT_GE(known + 2, fleet.made()) << "seed " << seed;
    for (auto& [name, robot] : fleet.robots()) {
      const auto& sent = robot.exchange->statistics().sent;
      EXPECT_LT(static_cast<double>(sent.bytes), 4000.0 + 1000.0 * fleet.now_s()) << name;
      EXPECT_EQ(sent.too_large, 0U);
    }
  }
}

TEST(FleetWithFaults, GivesALateJoinerTenThousandObjects) {
  FleetOfRobots fleet;
  FleetExchangeParams params = FleetOfRobots::params_of("r1");
  params.bytes_per_s = 1e9;
  params.burst_bytes = 1e9;
  fleet.add(params);
  for (int stop = 0; stop < 10000; ++stop) {
    ASSERT_TRUE(
        fleet["r1"].add_source_batch({0, {{1.0 * stop, {0.001 * stop, 0.0, 0.0}, 1.0, 1.0}}}));
  }
  fleet.run(2.0);
  fleet.add("late");
  fleet.run(2.0);
  EXPECT_EQ(fleet["late"].state().objects, 10000U);
}

}  // namespace
}  // namespace echomap::fleet
