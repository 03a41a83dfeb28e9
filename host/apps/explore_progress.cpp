// SPDX-License-Identifier: MIT
#include "host/apps/explore_progress.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace echomap::apps {
namespace {

constexpr double kLinePeriodS = 30.0;

/// Minutes and seconds, "1:05".
std::string minutes_of(double duration_s) {
  const auto seconds = std::lround(duration_s);
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

}  // namespace

std::optional<double> longest_left_s(const ExploreProgress& progress) {
  if (progress.max_s) {
    return std::max(0.0, *progress.max_s - progress.elapsed_s);
  }
  const std::size_t stops = progress.stops + progress.stops_elsewhere;
  if (!progress.max_stops || stops == 0) {
    return std::nullopt;
  }
  const double per_stop_s = progress.elapsed_s / static_cast<double>(stops);
  const std::size_t left = *progress.max_stops - std::min(*progress.max_stops, stops);
  return per_stop_s * static_cast<double>(left);
}

std::string line_of(const ExploreProgress& progress) {
  std::string line = fmt::format("{} stop{}, {:.1f} m² mapped, {:.1f} m driven in {}",
                                 progress.stops,
                                 progress.stops == 1 ? "" : "s",
                                 progress.floor_m2,
                                 progress.travelled_m,
                                 minutes_of(progress.elapsed_s));
  if (const auto left_s = longest_left_s(progress)) {
    line += fmt::format(", {} left at most", minutes_of(*left_s));
  }
  return line;
}

ProgressReporter::ProgressReporter(std::FILE* out, bool enabled)
    : out_(out), enabled_(enabled), bar_(out, enabled), next_line_s_(kLinePeriodS) {}

void ProgressReporter::report(double elapsed_s, const MakeLine& make_line) {
  if (bar_.is_active()) {
    if (bar_.is_due()) {
      bar_.show(make_line());
    }
  } else if (enabled_ && elapsed_s >= next_line_s_) {
    next_line_s_ = elapsed_s + kLinePeriodS;
    fmt::print(out_, "{}\n", make_line());
    std::fflush(out_);
  }
}

}  // namespace echomap::apps
