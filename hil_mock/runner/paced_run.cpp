// SPDX-License-Identifier: MIT
#include "hil_mock/runner/paced_run.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "hil_mock/runner/stop_signal.hpp"
#include "hil_mock/runner/wait_readable.hpp"

namespace echomap::runner {
namespace {

/// Most simulated time between two looks at the byte stream.
constexpr std::int64_t kSliceNs = 2'000'000;
constexpr std::chrono::microseconds kRest{1000};

}  // namespace

void run_paced(RobotTeam& team,
               std::span<const ServedRobot> robots,
               Pacer pacer,
               std::int64_t end_ns) {
  std::vector<Awaited> hosts;
  for (const ServedRobot& robot : robots) {
    hosts.push_back({robot.endpoint});
  }
  while (!stop_requested() && team.now_ns() < end_ns) {
    for (const ServedRobot& robot : robots) {
      if (const auto bytes = robot.endpoint->receive(); !bytes.empty()) {
        robot.simulation->receive(bytes);
      }
    }
    const std::int64_t now_ns = team.now_ns();
    const std::int64_t due_ns =
        std::min(end_ns, pacer.due_ns(std::chrono::steady_clock::now(), now_ns));
    team.advance_to(std::min(due_ns, now_ns + kSliceNs));
    for (const ServedRobot& robot : robots) {
      robot.endpoint->send(robot.simulation->take_sent());
    }
    if (due_ns <= team.now_ns()) {
      wait_readable(hosts, kRest);
    }
  }
}

}  // namespace echomap::runner
