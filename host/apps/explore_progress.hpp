// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include "host/apps/commands.hpp"
#include "host/console/progress_bar.hpp"
#include "host/terminal_view/run_view.hpp"
#include "host/terminal_view/terminal_screen.hpp"

namespace echomap::apps {

/// How far an exploration has come, and what ends it at the latest.
struct ExploreProgress {
  std::size_t stops = 0;            ///< In the map.
  std::size_t stops_elsewhere = 0;  ///< Those that are not in it, of a robot that was carried off.
  double floor_m2 = 0.0;            ///< Known to be free.
  double travelled_m = 0.0;
  double elapsed_s = 0.0;  ///< Of the robot's time.
  /// The most stops that it makes, in whichever map; empty where its strategy counts none.
  std::optional<std::size_t> max_stops{};
  /// How long it drives; empty where that is not known before.
  std::optional<double> max_s{};
};

/// How long it can still go on: to the end of its time, or its last stop at the pace of those so
/// far. Empty where nothing tells. How much of a room is left, nobody knows.
std::optional<double> longest_left_s(const ExploreProgress& progress);

/// "4 stops, 5.3 m2 of floor, 6.1 m driven in 1:34, 6:16 left at most".
std::string line_of(const ExploreProgress& progress);

/// What is shown of a run while it goes on.
enum class ProgressDisplay : std::uint8_t { kNone, kLine, kMap };

/// What `--view` and `--headless` ask for; nothing where the log has errors only.
ProgressDisplay progress_display(const RunOptions& run);

/// What there is to show of a run now.
class ProgressSource {
 public:
  virtual ~ProgressSource() = default;
  /// Empty for none.
  virtual std::string line() = 0;
  virtual terminal_view::RunView view() = 0;
  /// Robot's time since the run began.
  virtual double elapsed_s() const = 0;
};

/// Shows how a run gets on: on a terminal a line or a map that is drawn again in place, elsewhere a
/// line for every half minute of the robot's time.
class ProgressReporter {
 public:
  ProgressReporter(std::FILE* out, ProgressDisplay display);

  /// `source` is asked where something is due.
  void report(ProgressSource& source);
  /// Wipes the line of a terminal, for other output; leaves the map there as it is at last.
  void finish(ProgressSource& source);

 private:
  std::FILE* out_;
  ProgressDisplay display_;
  console::ProgressBar bar_;
  terminal_view::TerminalScreen screen_;
  double next_line_s_;
};

}  // namespace echomap::apps
