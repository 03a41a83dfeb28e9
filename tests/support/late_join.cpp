// SPDX-License-Identifier: MIT
#include "tests/support/late_join.hpp"

#include <chrono>
#include <set>
#include <string>

#include "tests/support/running_broker.hpp"

namespace echomap::tests {

LateJoin join_late(std::size_t objects) {
  const std::string fleet = "echomap/1/lab/";
  RunningBroker broker(broker_settings({"robot1", "robot2"}));
  Client robot(broker.params("robot1"));
  for (std::size_t i = 0; i < objects; ++i) {
    robot->publish(fleet + "robot1/submap/" + std::to_string(i),
                   std::string(500, 's'),
                   mqtt::Delivery::kAtLeastOnce,
                   true);
  }
  robot.is_acknowledged();
  LateJoin join;
  join.dropped = robot->statistics().dropped;
  const auto begin = std::chrono::steady_clock::now();
  Client late(broker.params("robot2"), fleet + "#");
  late.serve_until([&] { return late.heard().size() >= objects; });
  join.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::set<std::string> topics;
  for (const mqtt::Message& message : late.heard()) {
    topics.insert(message.topic);
    join.are_retained = join.are_retained && message.is_retained;
  }
  join.objects = topics.size();
  return join;
}

}  // namespace echomap::tests
