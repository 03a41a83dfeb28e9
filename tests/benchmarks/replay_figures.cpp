// SPDX-License-Identifier: MIT
#include "tests/benchmarks/replay_figures.hpp"

#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "host/datasets/open_log.hpp"
#include "host/pipeline/log_player.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "tests/support/median.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

/// Seconds of the log for each second of ours.
double realtime_factor(const std::filesystem::path& path) {
  const auto start = std::chrono::steady_clock::now();
  const auto log = datasets::open_log(path, "");
  pipeline::RobotPipeline pipeline(sensors::RobotGeometry{});
  pipeline::LogPlayer player(pipeline);
  while (const auto record = log->next()) {
    player.play(*record);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  return player.duration_s().value_or(0.0) / took.count();
}

}  // namespace

std::vector<Figure> replay_figures(std::size_t runs) {
  const auto path = tests::real_data("edmonton/dataset_edmonton.rawlog_LASER.txt.gz");
  if (!std::filesystem::exists(path)) {
    fmt::print("edmonton: not there, skipped\n");
    return {};
  }
  std::vector<double> factors;
  for (std::size_t i = 0; i < runs; ++i) {
    factors.push_back(realtime_factor(path));
  }
  return {{"edmonton_realtime_factor", tests::median(factors), "x", runs, {}}};
}

}  // namespace echomap::bench
