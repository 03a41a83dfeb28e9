// SPDX-License-Identifier: MIT
#include "tests/support/faulty_fleet.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "host/fleet/fleet_exchange.hpp"
#include "tests/host/fleet/fleet_of_robots.hpp"
#include "tests/support/running_broker.hpp"
#include "tests/support/tcp_proxy.hpp"

namespace echomap::tests {
namespace {

constexpr double kSpeed = 10.0;

struct ConnectedRobot {
  std::unique_ptr<mqtt::Connection> connection;
  std::unique_ptr<fleet::FleetExchange> exchange;
  std::uint32_t submaps = 0;
  std::vector<geometry::Pose2> T_map_submaps;
};

class FleetOnABroker {
 public:
  explicit FleetOnABroker(std::uint32_t seed) : random_(seed) {
    for (const char* name : {"r1", "r2", "r3", "r4"}) {
      add(name);
    }
  }

  void add(const std::string& name) {
    fleet::FleetExchangeParams params = fleet::FleetOfRobots::params_of(name);
    params.fleet = "lab";
    mqtt::ConnectionParams connection = broker_.params(name);
    connection.port = proxy_.port();
    connection.will = fleet::last_will(params);
    connection.keep_alive_s = 5;
    ConnectedRobot robot;
    robot.connection = std::make_unique<mqtt::Connection>(connection);
    robot.exchange = std::make_unique<fleet::FleetExchange>(*robot.connection, params);
    robots_.emplace(name, std::move(robot));
  }
  void kill(const std::string& name) { robots_.erase(name); }

  /// Runs so many seconds of the robots' clock.
  void run(double seconds) {
    const double until_s = now_s() + seconds;
    while (now_s() < until_s) {
      for (auto& [name, robot] : robots_) {
        robot.exchange->update(now_s());
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  void stop_once() {
    for (auto& [name, robot] : robots_) {
      robot.exchange->add_submap(fleet::random_submap(random_, robot.submaps++));
      robot.T_map_submaps.emplace_back(0.5 * robot.submaps, 0.0, 0.0);
      robot.exchange->set_graph(robot.T_map_submaps, 1e-4 * Eigen::Matrix3d::Identity());
    }
  }
  void happen() {
    switch (random_() % 5) {
      case 0:
        broker_->kill();
        run(3.0);
        broker_->start();
        break;
      case 1:
        proxy_.set_delay(std::chrono::milliseconds(200));  // Two seconds on the robots' clock.
        run(10.0);
        proxy_.set_delay(std::chrono::milliseconds(0));
        break;
      case 2:
        proxy_.stall();
        run(20.0);
        proxy_.resume();
        break;
      case 3:
        proxy_.cut();
        run(60.0);
        proxy_.resume();
        break;
      default:
        break;
    }
  }
  /// Whether all have the same within so many seconds of their clock.
  bool become_same(double seconds) {
    const double until_s = now_s() + seconds;
    while (now_s() < until_s) {
      run(2.0);
      if (is_same()) {
        return true;
      }
    }
    return false;
  }
  std::size_t objects(const std::string& name) const {
    return robots_.at(name).exchange->state().objects;
  }
  double mean_bytes_per_s(const std::string& name) const {
    return static_cast<double>(robots_.at(name).exchange->statistics().sent.bytes) / now_s();
  }

 private:
  bool is_same() const {
    std::optional<fleet::FleetState> first;
    for (const auto& [name, robot] : robots_) {
      fleet::FleetState state = robot.exchange->state();
      if (first && state.object_set != first->object_set) {
        return false;
      }
      for (std::size_t i = 0; first && i < state.robots.size(); ++i) {
        if (graph_size(state, i) != graph_size(*first, i)) {
          return false;
        }
      }
      first = std::move(state);
    }
    return true;
  }
  static std::size_t graph_size(const fleet::FleetState& state, std::size_t robot) {
    const auto& maps = state.robots.at(robot).maps;
    return maps.empty() ? 0 : maps[0].record->T_map_submaps.size();
  }
  double now_s() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    return kSpeed * passed.count();
  }

  RunningBroker broker_{broker_settings({"r1", "r2", "r3", "r4", "late", "hub"})};
  TcpProxy proxy_{broker_->port()};
  std::map<std::string, ConnectedRobot> robots_;
  std::mt19937 random_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

FaultyFleetRun run_faulty_fleet(std::uint32_t seed) {
  FleetOnABroker fleet(seed);
  for (int stop = 0; stop < 4; ++stop) {
    fleet.run(15.0);
    fleet.stop_once();
    fleet.happen();
  }
  fleet.run(15.0);
  fleet.kill("r4");
  fleet.happen();
  fleet.add("late");
  const bool is_same = fleet.become_same(300.0);
  return {is_same, fleet.objects("late"), fleet.mean_bytes_per_s("r1")};
}

}  // namespace echomap::tests
