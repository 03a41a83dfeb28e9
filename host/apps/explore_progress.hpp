// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

#include "host/console/progress_bar.hpp"

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

/// Reports how an exploration gets on: on a terminal a line that is drawn again in place,
/// elsewhere a line for every half minute of the robot's time.
class ProgressReporter {
 public:
  using MakeLine = std::function<std::string()>;

  explicit ProgressReporter(std::FILE* out, bool enabled);

  /// `make_line` is called where a line is due.
  void report(double elapsed_s, const MakeLine& make_line);
  /// Wipes the line of a terminal, for other output.
  void clear() { bar_.clear(); }

 private:
  std::FILE* out_;
  bool enabled_;
  console::ProgressBar bar_;
  double next_line_s_;
};

}  // namespace echomap::apps
