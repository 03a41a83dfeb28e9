// SPDX-License-Identifier: MIT
#include "tests/benchmarks/board_measures.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "tests/benchmarks/edge_counts.hpp"
#include "tests/hil/measure/chip_figures.hpp"
#include "tests/hil/measure/image_size.hpp"
#include "tests/hil/measure/line_load.hpp"
#include "tests/hil/measure/loaded_robot.hpp"
#include "tests/hil/measure/robot_on_the_move.hpp"
#include "tests/hil_mock/mock_device/lossy_commands.hpp"
#include "tests/sessions/hijacks.hpp"
#include "tests/sessions/recoveries.hpp"

namespace echomap::bench {
namespace {

class FigureList {
 public:
  void add(const std::string& name, double value, const char* unit = "", std::size_t runs = 1) {
    figures_.push_back({name, value, unit, runs, {}});
  }
  void add_told(const std::string& name, std::optional<double> value, const char* unit) {
    if (value) {
      add(name, *value, unit);
    }
  }
  std::vector<Figure> take() { return std::move(figures_); }

 private:
  std::vector<Figure> figures_;
};

/// Everything that is asked of the line by habit: 100 Hz odometry, sweeps, and a host that drives.
tests::Load habitual_load() {
  tests::Load load;
  load.edges_per_s = 20'000;
  load.odometry_period_ms = 10;
  load.full_line = false;
  load.sweeps_on = true;
  return load;
}

void measure_chip(FigureList& list, const BoardUnderMeasure& board) {
  constexpr double kRunUpS = 1.0;
  constexpr double kSeconds = 10.0;
  tests::LoadedRobot robot(board.elf, habitual_load());
  robot.connect();
  robot.run_s(kRunUpS);
  const auto meter = tests::make_chip_meter(robot.session().board());
  if (meter == nullptr) {
    return;
  }
  robot.run_s(kSeconds);
  list.add("tick_jitter_us", meter->load().tick_jitter_us, "us");
  list.add("cpu_percent_20k", 100.0 * meter->load().busy_share, "%");
}

void measure_size(FigureList& list, const BoardUnderMeasure& board) {
  const tests::ImageSize size = tests::size_of_image(board.elf);
  list.add("flash_bytes_" + board.name, double(size.flash_bytes), "B");
  list.add("static_ram_bytes_" + board.name, double(size.ram_bytes), "B");
}

/// A minute of everything at once.
void measure_load(FigureList& list, const BoardUnderMeasure& board) {
  tests::LoadedRobot robot(board.elf, {.edges_per_s = 40'000, .every_sensor = true});
  robot.connect();
  robot.run_s(61.0);
  const tests::LoadResult loaded = robot.finish();
  if (board.counts_edges) {
    list.add("miscounts_40k", double(loaded.miscounts), "ticks", std::size_t(loaded.comparisons));
    list.add("echo_error_us", loaded.worst_echo_error_us, "us", std::size_t(loaded.echoes));
  }
  if (loaded.min_stack_bytes != UINT16_MAX) {
    list.add("stack_margin_bytes", double(loaded.min_stack_bytes), "B");
  }
}

void measure_safety(FigureList& list, const BoardUnderMeasure& board) {
  list.add("link_loss_stop_ms", tests::measure_link_loss_ms(board.elf), "ms");
  list.add("hang_off_ms", tests::measure_worst_hang_ms(board.elf), "ms");
  list.add_told(board.name + "_crash_off_ms", tests::measure_crash_off_ms(board.elf), "ms");
}

/// The fewest of the four kinds of break.
void measure_reconnects(FigureList& list, const BoardUnderMeasure& board) {
  using tests::Break;
  constexpr int kBreaks = 100;
  int fewest = kBreaks;
  for (const Break kind :
       {Break::kUnplugged, Break::kReplugged, Break::kResetPin, Break::kWatchdogReset}) {
    fewest = std::min(fewest, tests::measure_recoveries(board.elf, kind, kBreaks).recovered);
  }
  list.add("reconnects_of_100", fewest, "", 4UL * kBreaks);
}

void measure_sessions(FigureList& list, const BoardUnderMeasure& board) {
  constexpr int kTries = 100;
  constexpr int kCommands = 10'000;
  measure_reconnects(list, board);
  list.add("second_sessions_refused_of_100",
           tests::measure_hijacks(board.elf, kTries).refused,
           "",
           kTries);
  if (auto owned = tests::make_owned_board(board.elf)) {
    const auto result = mock_device::measure_commands(std::move(owned), kCommands, 0.05);
    list.add("commands_exactly_once_of_10000", result.exactly_once, "", kCommands);
  }
}

/// Without jitter and with.
std::vector<EdgeCount> count_edges(const BoardUnderMeasure& board, int rate_k) {
  constexpr double kSeconds = 5.0;
  std::vector<EdgeCount> counts;
  for (const int jitter_percent : kJittersPercent) {
    tests::LoadedRobot robot(
        board.elf, {.edges_per_s = 1000.0 * rate_k, .edge_jitter = 0.01 * jitter_percent});
    robot.connect();
    robot.run_s(kSeconds);
    const tests::LoadResult result = robot.finish();
    counts.push_back({rate_k,
                      jitter_percent,
                      result.comparisons,
                      result.miscounts,
                      result.encoder_errors,
                      result.resets});
  }
  return counts;
}

void measure_edges(FigureList& list,
                   const BoardUnderMeasure& board,
                   const std::vector<int>& rates_k) {
  if (!board.counts_edges) {
    return;
  }
  for (const int rate_k : rates_k) {
    const std::vector<EdgeCount> counts = count_edges(board, rate_k);
    for (const Figure& figure : figures_of(counts)) {
      list.add(figure.name, figure.value, figure.unit.c_str(), figure.runs);
    }
    list.add(board.name + "_miscounts_" + std::to_string(rate_k) + "k",
             worst_miscounts(counts),
             "ticks",
             counts.size());
  }
}

}  // namespace

std::string emulator_of(const BoardUnderMeasure& board) {
  return tests::make_emulated_board(board.elf)->pins().emulator_name();
}

std::vector<Figure> measure_board_link(const BoardUnderMeasure& board) {
  FigureList list;
  list.add("line_load_percent_115200", 100.0 * tests::measure_usual_line(board.elf).share, "%");
  measure_load(list, board);
  list.add_told("sample_to_pwm_us", tests::measure_sample_to_pwm_us(board.elf), "us");
  list.add("pings_per_s", tests::measure_pings_per_s(board.elf), "/s");
  measure_chip(list, board);
  measure_size(list, board);
  measure_safety(list, board);
  list.add("bump_stop_ms", tests::measure_bump_ms(board.elf), "ms", 20);
  measure_sessions(list, board);
  measure_edges(list, board, {200});
  return list.take();
}

std::vector<Figure> measure_board_table(const BoardUnderMeasure& board) {
  FigureList list;
  measure_size(list, board);
  measure_chip(list, board);
  measure_safety(list, board);
  measure_load(list, board);
  measure_edges(list, board, {kRatesK.begin(), kRatesK.end()});
  return list.take();
}

}  // namespace echomap::bench
