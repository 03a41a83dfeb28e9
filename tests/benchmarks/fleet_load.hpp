// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/mqtt/message_bus.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What a robot has published once: when, what kind, how large.
struct RecordedMessage {
  double at_s = 0.0;
  std::string kind;  ///< Topic below the robot's name.
  std::size_t bytes = 0;
  mqtt::Delivery delivery = mqtt::Delivery::kAtLeastOnce;
  bool retain = true;
};

/// What robots have published, each in the order of its times.
struct LoadRecord {
  double duration_s = 0.0;
  std::vector<std::vector<RecordedMessage>> robots;
};

/// How many robots replay a record.
struct LoadParams {
  std::size_t robots = 50;
  double duration_s = 30.0;
  bool all_hear = true;    ///< Every robot hears all; else the hub alone does.
  std::uint32_t seed = 1;  ///< Of the place in the record at which each robot begins.
};

/// What the broker has done of it.
struct LoadResult {
  double published_per_s = 0.0;
  double delivered_per_s = 0.0;
  double p50_ms = 0.0;  ///< From publish() of one client to take() of another.
  double p99_ms = 0.0;
  double broker_cpu_percent = 0.0;      ///< Of one core.
  double kbytes_per_s_per_robot = 0.0;  ///< Published, topics and payloads.
  std::size_t missing = 0;              ///< Deliveries that have not come.
};

/// Replays the record at its own pace, by so many robots, which take the robots of the record in
/// turn, against one Mosquitto on this machine, with all clients in this thread: latencies are
/// upper ends. Throws std::invalid_argument for a record without a message.
LoadResult measure_load(const LoadParams& params, const LoadRecord& record);

/// 10, 50 and 200 robots that a hub hears, and 10 and 50 that all hear.
std::vector<Figure> load_figures(const LoadRecord& record, double duration_s);

}  // namespace echomap::bench
