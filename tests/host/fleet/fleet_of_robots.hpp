// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "host/fleet/fleet_exchange.hpp"
#include "tests/support/memory_bus.hpp"

namespace echomap::fleet {

/// A submap like that of a stop: half a kilobyte.
inline team_map::Submap random_submap(std::mt19937& random, std::uint32_t index) {
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  team_map::Submap submap;
  submap.index = index;
  submap.begin_s = 20.0 * index;
  submap.end_s = submap.begin_s + 18.0;
  for (int i = 0; i < 120; ++i) {
    slam::StopReading reading;
    reading.mark.T_odom_robot = {0.1 * index, 0.0, 0.0};
    reading.T_robot_sonar = {0.03, 0.0, -1.5 + 0.025 * i};
    reading.range_m = 1.0 + share();
    submap.readings.push_back(reading);
  }
  for (int i = 0; i < 12; ++i) {
    submap.T_odom_way.emplace_back(0.1 * i, share(), 0.1 * share());
  }
  return submap;
}

/// Robots of one fleet on a broker in memory, in steps of a tenth of a second.
class FleetOfRobots {
 public:
  /// One robot: its connection, its exchange and what it has made.
  struct Robot {
    std::unique_ptr<tests::MemoryBus> bus;
    std::unique_ptr<FleetExchange> exchange;
    std::uint32_t submaps = 0;
    std::vector<geometry::Pose2> T_map_submaps;
  };

  explicit FleetOfRobots(const tests::MemoryBrokerParams& params = {})
      : broker_(params), random_(params.seed) {}

  static FleetExchangeParams params_of(const std::string& name, std::uint32_t boot_id = 1) {
    FleetExchangeParams params;
    params.fleet = "hall";
    params.robot = name;
    params.boot_id = boot_id;
    params.traits.body_radius_m = 0.1;
    return params;
  }

  FleetExchange& add(const FleetExchangeParams& params) {
    Robot robot;
    robot.bus = broker_.client(params.robot, last_will(params));
    robot.exchange = std::make_unique<FleetExchange>(*robot.bus, params);
    return *robots_.insert_or_assign(params.robot, std::move(robot)).first->second.exchange;
  }
  FleetExchange& add(const std::string& name) { return add(params_of(name)); }
  /// Its process ends without a good-bye.
  void kill(const std::string& name) { robots_.erase(name); }

  /// The robot has stopped once more: a submap, and a graph of all of its map.
  void stop_once(const std::string& name) {
    Robot& robot = robots_.at(name);
    robot.exchange->add_submap(random_submap(random_, robot.submaps++));
    ++made_;
    robot.T_map_submaps.emplace_back(
        0.5 * robot.submaps, 0.1 * static_cast<double>(random_() % 10), 0.0);
    robot.exchange->set_graph(robot.T_map_submaps, 1e-4 * Eigen::Matrix3d::Identity());
  }

  void run(double seconds) {
    const double until_s = now_s_ + seconds;
    while (now_s_ < until_s - 1e-9) {
      now_s_ += 0.1;
      broker_.advance_to(now_s_);
      for (auto& [name, robot] : robots_) {
        robot.exchange->update(now_s_);
      }
    }
  }
  /// Runs until all robots have the same objects, all that were made, and nothing waits; false
  /// where they have not within that time.
  bool run_until_same(double seconds, std::optional<std::size_t> objects = std::nullopt) {
    for (double passed_s = 0.0; passed_s < seconds; passed_s += 1.0) {
      run(1.0);
      if (is_same(objects)) {
        return true;
      }
    }
    return false;
  }
  /// Whether all have that many objects, the same ones, and the same graphs.
  bool is_same(std::optional<std::size_t> objects = std::nullopt) const {
    std::optional<FleetState> first;
    for (const auto& [name, robot] : robots_) {
      FleetState state = robot.exchange->state();
      if ((objects && state.objects != *objects) || (first && !have_same_records(*first, state))) {
        return false;
      }
      first = std::move(state);
    }
    return true;
  }

  Robot& robot(const std::string& name) { return robots_.at(name); }
  FleetExchange& operator[](const std::string& name) { return *robots_.at(name).exchange; }
  tests::MemoryBroker& broker() { return broker_; }
  std::map<std::string, Robot>& robots() { return robots_; }
  double now_s() const { return now_s_; }
  std::size_t made() const { return made_; }
  std::mt19937& random() { return random_; }

 private:
  static bool have_same_records(const FleetState& one, const FleetState& other) {
    if (one.object_set != other.object_set || one.robots.size() != other.robots.size()) {
      return false;
    }
    for (std::size_t i = 0; i < one.robots.size(); ++i) {
      if (!have_same_maps(one.robots[i].maps, other.robots[i].maps)) {
        return false;
      }
    }
    return true;
  }
  static bool have_same_maps(const std::vector<FleetMap>& some,
                             const std::vector<FleetMap>& others) {
    if (some.size() != others.size()) {
      return false;
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      const auto rows = [](const FleetMap& map) {
        return fleet_messages::to_graph_message(
            map.record->T_map_submaps, map.latest_covariance, map.number);
      };
      if (rows(some[i]) != rows(others[i])) {
        return false;
      }
    }
    return true;
  }

  tests::MemoryBroker broker_;
  std::map<std::string, Robot> robots_;
  std::mt19937 random_;
  double now_s_ = 0.0;
  std::size_t made_ = 0;
};

/// The robot of that name; it is there.
inline FleetRobot robot_in(const FleetState& state, const std::string& name) {
  for (const FleetRobot& robot : state.robots) {
    if (robot.name == name) {
      return robot;
    }
  }
  throw std::out_of_range("no robot " + name);
}

}  // namespace echomap::fleet
