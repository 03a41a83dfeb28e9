// SPDX-License-Identifier: MIT
// How much faster than it was driven the Edmonton log becomes a grid, from the packed files on.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "host/datasets/open_log.hpp"
#include "host/pipeline/log_mapper.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

/// Seconds of the log for each second of ours.
double realtime_factor(const std::filesystem::path& path) {
  const auto start = std::chrono::steady_clock::now();
  const auto log = datasets::open_log(path, "");
  pipeline::LogMapper mapper;
  while (const auto record = log->next()) {
    mapper.add(*record);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  return mapper.duration_s().value_or(0.0) / took.count();
}

void run(const std::filesystem::path& path, std::size_t runs, const std::filesystem::path& json) {
  std::vector<double> factors;
  for (std::size_t i = 0; i < runs; ++i) {
    factors.push_back(realtime_factor(path));
  }
  report({{"edmonton_realtime_factor", tests::median(factors), "x", runs, {}}}, json);
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  std::filesystem::path log;
  std::size_t runs = 5;
  std::filesystem::path json;
  CLI::App app("How much faster than real time a log with stamps becomes a grid");
  app.add_option("log", log, "dataset_edmonton.rawlog_LASER.txt.gz, the other files beside it")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--runs", runs, "So often; the median counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::run(log, runs, json);
}
