// SPDX-License-Identifier: MIT
// Link and firmware: a board's release image in its emulator and the host's own code, in simulated
// time. What depends on the board is measured by the program that has its emulator.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "hil_mock/line_faults/delay_model.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"
#include "tests/benchmarks/board_program.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/measured_boards.hpp"
#include "tests/hil/measure/differential.hpp"
#include "tests/hil_mock/line_faults/clock_errors.hpp"
#include "tests/hil_mock/line_faults/fault_stretches.hpp"
#include "tests/ports/hijacks.hpp"
#include "tests/ports/replugs.hpp"
#include "tests/ports/staged_desk.hpp"

namespace echomap::bench {
namespace {

using Path = std::filesystem::path;

class Report {
 public:
  void add(const char* name, double value, const char* unit = "", std::size_t runs = 1) {
    figures_.push_back({name, value, unit, runs, {}});
  }
  void add(const Figure& figure) { figures_.push_back(figure); }
  const std::vector<Figure>& figures() const { return figures_; }

 private:
  std::vector<Figure> figures_;
};

/// What a frame of message M is longer than its payload.
template <class M>
double overhead_bytes() {
  protocol::FrameEncoder encoder;
  return double(encoder.encode(M{}, 1).size) - double(protocol::MessageFacts<M>::kSize);
}

/// The figures of the board, from the program that has its emulator; its emulator's name.
std::string measure_board(Report& report, const MeasuredBoard& board) {
  const BoardReport measured = run_measures(board, "link", build_folders());
  for (const Figure& figure : measured.figures) {
    report.add(figure);
  }
  return measured.emulator;
}

/// Lost frames of faults of one byte, as claimed; wrong ones of all five kinds.
void measure_faults(Report& report, int faults_of_a_kind) {
  using line_faults::FaultKind;
  double wrong = 0.0;
  double lost = 0.0;
  for (const auto kind : {FaultKind::kFlip,
                          FaultKind::kDrop,
                          FaultKind::kInsert,
                          FaultKind::kBurst,
                          FaultKind::kCut}) {
    const auto outcome = line_faults::suffer_faults(kind, faults_of_a_kind, 1);
    wrong += double(outcome.wrong);
    if (kind != FaultKind::kBurst && kind != FaultKind::kCut) {
      lost = std::max(lost, outcome.lost_per_fault());
    }
  }
  const std::size_t runs = line_faults::kFaultKinds * std::size_t(faults_of_a_kind);
  report.add("wrong_accepts", wrong, "", runs);
  report.add("frames_lost_per_fault", lost, "", runs);
}

double clock_p99_us(const line_faults::LineDelays& line, const std::vector<double>& rates_ppm) {
  double worst_us = 0.0;
  for (const double rate_ppm : rates_ppm) {
    const auto errors = line_faults::measure_clock(line, rate_ppm);
    worst_us = std::max(worst_us, line_faults::quantile(errors.all_us, 0.99));
  }
  return worst_us;
}

/// The worst p99 over the rate errors of boards, on a line that waits at random and, where it has
/// transfers, on one that keeps its pace.
double clock_p99_ms(line_faults::LineDelays line, bool has_transfers) {
  const double at_random_us = clock_p99_us(line, {50.0, -2000.0, 5000.0, -5000.0});
  if (!has_transfers) {
    return at_random_us * 1e-3;
  }
  line.to_host.poll_beats = line.to_robot.poll_beats = true;
  return std::max(at_random_us, clock_p99_us(line, {0.0, 20.0, 50.0, 5000.0})) * 1e-3;
}

void measure_differences(Report& report) {
  const auto result = tests::compare_targets(1'000'000, 1);
  report.add("differential_mismatches", double(result.mismatches), "", result.steps);
}

void measure_clocks(Report& report) {
  report.add("clock_p99_usb_ms", clock_p99_ms(line_faults::usb_line(), true), "ms", 48);
  report.add("clock_p99_ftdi_ms", clock_p99_ms(line_faults::ftdi_line(), true), "ms", 48);
  report.add(
      "clock_p99_bluetooth_ms", clock_p99_ms(line_faults::bluetooth_line(), false), "ms", 24);
}

void measure_ports(Report& report) {
  constexpr int kTries = 100;
  report.add("strangers_bytes", double(tests::measure_strangers_bytes()), "B", 7);
  report.add("hijacks_refused_of_100", tests::measure_refused_hijacks(kTries), "", kTries);
  report.add("replug_of_100", tests::measure_survived_replugs(kTries), "", kTries);
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  using namespace echomap::bench;
  Path json;
  int faults = 200'000;
  std::string board = "uno";
  CLI::App app("Figures of the link and of a board's release image, in simulated time");
  app.add_option("--board", board, "uno, mega, stm32f103, pico or ev3")->capture_default_str();
  app.add_option("--faults", faults, "Line faults of each of the five kinds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  spdlog::set_level(spdlog::level::err);  // a session tells of every reset it has seen
  try {
    Report figures;
    figures.add("overhead_bytes", overhead_bytes<echomap::protocol::Odometry>(), "B");
    const std::string emulator = measure_board(figures, measured_board(board));
    measure_faults(figures, faults);
    measure_clocks(figures);
    measure_ports(figures);
    measure_differences(figures);
    report(figures.figures(), json, {{board, emulator}});
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_link: {}\n", error.what());
    return 1;
  }
  return 0;
}
