// SPDX-License-Identifier: MIT
// Hours of driving, sweeping and line faults, in simulated time: what must not drift, leak or
// break.
#include "tests/sessions/soak.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "hil_mock/emulator/simavr_board.hpp"
#include "hil_mock/mock_device/mock_board.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {
namespace {

struct Options {
  std::string board = "uno";
  double hours = 24.0;
  std::uint32_t seed = 1;
  std::filesystem::path json;
};

std::unique_ptr<runner::SimulatedBoard> make_board(const std::string& name) {
  if (name == "native") {
    return std::make_unique<mock_device::MockBoard>();
  }
  return std::make_unique<emulator::SimavrBoard>(
      fmt::format(ECHOMAP_BINARY_DIR "/firmware/echomap-{}.elf", name));
}

std::vector<Figure> figures_of(const tests::SoakResult& result) {
  std::vector<Figure> figures;
  const auto add = [&](const char* name, auto value, const char* unit = "") {
    figures.push_back({name, static_cast<double>(value), unit, 1, {}});
  };
  add("hours", result.hours, "h");
  add("rounds", result.rounds);
  add("cuts", result.cuts);
  add("expired", result.expired);
  add("failures", result.failures);
  add("edges", result.edges);
  add("echoes", result.echoes);
  add("frames_lost", result.frames_lost);
  add("worst_drift_ticks", result.worst_drift_ticks, "ticks");
  add("worst_echo_error_us", result.worst_echo_error_us, "us");
  add("worst_lateness_us", result.worst_lateness_us, "us");
  add("worst_clock_error_us", result.worst_clock_error_us, "us");
  add("resets", result.resets);
  add("encoder_errors", result.encoder_errors);
  add("receive_overruns", result.receive_overruns);
  add("min_stack_bytes", result.min_stack_bytes, "B");
  add("grown_mb", result.grown_mb, "MB");
  return figures;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  using namespace echomap;
  bench::Options options;
  CLI::App app("Hours of driving, sweeping and line faults in simulated time; 1 where it breaks");
  app.add_option("--board", options.board, "The release image of a board, or the native firmware")
      ->check(CLI::IsMember({"uno", "mega", "native"}))
      ->capture_default_str();
  app.add_option("--hours", options.hours)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--seed", options.seed)->capture_default_str();
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  const auto result = tests::soak(
      bench::make_board(options.board), options.hours, options.seed, [](const auto& so_far) {
        fmt::print(stderr,
                   "{:.1f} h: {} rounds, {} failures, drift {} ticks, {} resets\n",
                   so_far.hours,
                   so_far.rounds,
                   so_far.failures,
                   so_far.worst_drift_ticks,
                   so_far.resets);
      });
  bench::report(bench::figures_of(result), options.json);
  return result.holds() ? 0 : 1;
}
