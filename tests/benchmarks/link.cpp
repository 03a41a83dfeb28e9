// SPDX-License-Identifier: MIT
// Link and firmware: the release images in their emulator and the host's own code, in simulated
// time.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "hil_mock/emulator/simavr_board.hpp"
#include "hil_mock/line_faults/delay_model.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/hil/measure/differential.hpp"
#include "tests/hil/measure/image_size.hpp"
#include "tests/hil/measure/line_load.hpp"
#include "tests/hil/measure/loaded_robot.hpp"
#include "tests/hil/measure/planted_hangs.hpp"
#include "tests/hil/measure/robot_on_the_move.hpp"
#include "tests/hil/measure/timing.hpp"
#include "tests/hil_mock/line_faults/clock_errors.hpp"
#include "tests/hil_mock/line_faults/fault_stretches.hpp"
#include "tests/hil_mock/mock_device/lossy_commands.hpp"
#include "tests/ports/hijacks.hpp"
#include "tests/ports/replugs.hpp"
#include "tests/ports/staged_desk.hpp"
#include "tests/sessions/hijacks.hpp"
#include "tests/sessions/recoveries.hpp"

namespace echomap::bench {
namespace {

using Path = std::filesystem::path;

class Report {
 public:
  void add(const char* name, double value, const char* unit = "", std::size_t runs = 1) {
    figures_.push_back({name, value, unit, runs, {}});
  }
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

void measure_wire(Report& report, const Path& elf) {
  report.add("overhead_bytes", overhead_bytes<protocol::Odometry>(), "B");
  report.add("line_load_percent_115200", 100.0 * tests::measure_usual_line(elf).share, "%");
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

void measure_load(Report& report, const Path& elf) {
  tests::LoadedRobot robot(elf, {.edges_per_s = 40'000, .every_sensor = true});
  robot.connect();
  robot.run_s(61.0);
  const tests::LoadResult loaded = robot.finish();
  const tests::TimingFigures usual = tests::measure_timing(elf, tests::usual_load(20'000), 10.0);
  report.add("miscounts_40k", double(loaded.miscounts), "ticks", std::size_t(loaded.comparisons));
  report.add("tick_jitter_us", usual.tick_jitter_us, "us");
  report.add(
      "sample_to_pwm_us", tests::measure_control(elf, {.edges_per_s = 40'000}, 4.0).max_us, "us");
  report.add("echo_error_us", loaded.worst_echo_error_us, "us", std::size_t(loaded.echoes));
  report.add("pings_per_s", tests::measure_pings_per_s(elf), "/s");
  report.add("cpu_percent_20k", 100.0 * usual.busy_share(), "%");
  const tests::ImageSize size = tests::size_of_image(elf);
  report.add("flash_bytes_uno", double(size.flash_bytes), "B");
  report.add("static_ram_bytes_uno", double(size.ram_bytes), "B");
  report.add("stack_margin_bytes", double(loaded.min_stack_bytes), "B");
}

void measure_safety(Report& report, const Path& elf) {
  report.add("link_loss_stop_ms", tests::measure_link_loss_ms(elf), "ms");
  report.add("hang_off_ms", tests::measure_hang_ms(elf), "ms");
  report.add("bump_stop_ms", tests::measure_bump_ms(elf), "ms", 20);
}

/// The fewest of the four kinds of break.
void measure_reconnects(Report& report, const Path& elf) {
  using tests::Break;
  constexpr int kBreaks = 100;
  int fewest = kBreaks;
  for (const Break kind :
       {Break::kUnplugged, Break::kReplugged, Break::kResetPin, Break::kWatchdogReset}) {
    fewest = std::min(fewest, tests::measure_recoveries(elf, kind, kBreaks).recovered);
  }
  report.add("reconnects_of_100", fewest, "", 4UL * kBreaks);
}

void measure_second_sessions(Report& report, const Path& elf) {
  constexpr int kTries = 100;
  report.add(
      "second_sessions_refused_of_100", tests::measure_hijacks(elf, kTries).refused, "", kTries);
}

void measure_commands(Report& report, const Path& elf) {
  constexpr int kCommands = 10'000;
  auto board = std::make_unique<emulator::SimavrBoard>(elf);
  const auto result = mock_device::measure_commands(std::move(board), kCommands, 0.05);
  report.add("commands_exactly_once_of_10000", result.exactly_once, "", kCommands);
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
  CLI::App app("Figures of the link and of the Uno's release image, in simulated time");
  app.add_option("--faults", faults, "Line faults of each of the five kinds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  spdlog::set_level(spdlog::level::err);  // a session tells of every reset it has seen
  const Path elf = ECHOMAP_BINARY_DIR "/firmware/echomap-uno.elf";
  Report figures;
  measure_wire(figures, elf);
  measure_faults(figures, faults);
  measure_load(figures, elf);
  measure_safety(figures, elf);
  measure_reconnects(figures, elf);
  measure_second_sessions(figures, elf);
  measure_commands(figures, elf);
  measure_clocks(figures);
  measure_ports(figures);
  measure_differences(figures);
  report(figures.figures(), json);
}
