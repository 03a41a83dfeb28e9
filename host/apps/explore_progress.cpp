// SPDX-License-Identifier: MIT
#include "host/apps/explore_progress.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace echomap::apps {

using terminal_view::minutes_text;

namespace {

constexpr double kLinePeriodS = 30.0;

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
                                 minutes_text(progress.elapsed_s));
  if (const auto left_s = longest_left_s(progress)) {
    line += fmt::format(", {} left at most", minutes_text(*left_s));
  }
  return line;
}

ProgressDisplay progress_display(const RunOptions& run) {
  if (run.headless || run.view == "none" || !spdlog::should_log(spdlog::level::info)) {
    return ProgressDisplay::kNone;
  }
  return run.view == "map" ? ProgressDisplay::kMap : ProgressDisplay::kLine;
}

ProgressReporter::ProgressReporter(std::FILE* out, ProgressDisplay display)
    : out_(out),
      display_(display),
      bar_(out, display == ProgressDisplay::kLine),
      screen_(out, display == ProgressDisplay::kMap),
      next_line_s_(kLinePeriodS) {}

void ProgressReporter::report(ProgressSource& source) {
  if (screen_.is_active()) {
    if (screen_.is_due()) {
      screen_.show(lines_of(source.view(), screen_.room(), screen_.glyphs()));
    }
  } else if (bar_.is_active()) {
    if (bar_.is_due()) {
      bar_.show(source.line());
    }
  } else if (display_ != ProgressDisplay::kNone && source.elapsed_s() >= next_line_s_) {
    next_line_s_ = source.elapsed_s() + kLinePeriodS;
    if (const std::string line = source.line(); !line.empty()) {
      fmt::print(out_, "{}\n", line);
      std::fflush(out_);
    }
  }
}

void ProgressReporter::finish(ProgressSource& source) {
  if (screen_.is_active()) {
    screen_.finish(lines_of(source.view(), screen_.room(), screen_.glyphs()));
  }
  bar_.clear();
}

}  // namespace echomap::apps
