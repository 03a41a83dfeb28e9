// SPDX-License-Identifier: MIT
#include "host/apps/explore_progress.hpp"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/console/terminal.hpp"

namespace echomap::apps {
namespace {

std::string text_of(std::FILE* file) {
  std::rewind(file);
  std::array<char, 200> text{};
  const std::size_t size = std::fread(text.data(), 1, text.size(), file);
  return {text.data(), size};
}

TEST(ExploreProgress, TellsWhatIsCoveredAndDriven) {
  EXPECT_EQ(line_of({.stops = 1, .floor_m2 = 1.25, .travelled_m = 0.0, .elapsed_s = 14.4}),
            "1 stop, 1.2 m² mapped, 0.0 m driven in 0:14");
  EXPECT_EQ(line_of({.stops = 12, .floor_m2 = 8.9, .travelled_m = 10.31, .elapsed_s = 125.0}),
            "12 stops, 8.9 m² mapped, 10.3 m driven in 2:05");
}

TEST(ExploreProgress, TellsTheTimeThatALimitLeaves) {
  ExploreProgress progress{.stops = 4, .floor_m2 = 5.3, .travelled_m = 6.1, .elapsed_s = 94.0};
  progress.max_stops = 20;
  EXPECT_DOUBLE_EQ(*longest_left_s(progress), 376.0) << "sixteen stops of 23.5 s";
  EXPECT_EQ(line_of(progress), "4 stops, 5.3 m² mapped, 6.1 m driven in 1:34, 6:16 left at most");
  progress.max_s = 120.0;
  EXPECT_DOUBLE_EQ(*longest_left_s(progress), 26.0);
  progress.elapsed_s = 121.0;
  EXPECT_EQ(*longest_left_s(progress), 0.0);
}

TEST(ExploreProgress, CountsStopsThatAreNotInTheMap) {
  ExploreProgress progress{.stops = 1, .stops_elsewhere = 9, .elapsed_s = 200.0};
  progress.max_stops = 20;
  EXPECT_DOUBLE_EQ(*longest_left_s(progress), 200.0) << "ten stops of 20 s";
  progress.stops = 0;
  progress.stops_elsewhere = 10;
  EXPECT_DOUBLE_EQ(*longest_left_s(progress), 200.0);
}

TEST(ExploreProgress, InventsNoTime) {
  EXPECT_FALSE(longest_left_s({.stops = 3, .elapsed_s = 60.0}));
  ExploreProgress first{.stops = 0, .elapsed_s = 3.0};
  first.max_stops = 20;
  EXPECT_FALSE(longest_left_s(first)) << "no stop has told its pace yet";
}

class CountedLines final : public ProgressSource {
 public:
  std::string line() override { return silent ? "" : "line " + std::to_string(++made); }
  terminal_view::RunView view() override {
    terminal_view::RunView view{mapping::RasterMap(1, 1, 0.1, {0.0, 0.0}), {}, {}};
    view.status.mode = "exploring";
    return view;
  }
  double elapsed_s() const override { return now_s; }

  double now_s = 0.0;
  bool silent = false;
  int made = 0;
};

std::string reported_to_a_file(ProgressDisplay display, bool silent = false) {
  std::FILE* file = std::tmpfile();
  ProgressReporter reporter(file, display);
  CountedLines source;
  source.silent = silent;
  for (; source.now_s < 70.0; source.now_s += 0.1) {
    reporter.report(source);
  }
  reporter.finish(source);
  const std::string text = text_of(file);
  std::fclose(file);
  return text;
}

TEST(ProgressReporter, SaysALineForEveryHalfMinuteWhereNoTerminalIs) {
  EXPECT_EQ(reported_to_a_file(ProgressDisplay::kLine), "line 1\nline 2\n");
  EXPECT_EQ(reported_to_a_file(ProgressDisplay::kMap), "line 1\nline 2\n");
  EXPECT_EQ(reported_to_a_file(ProgressDisplay::kMap, true), "") << "there is no line to say";
}

TEST(ProgressReporter, SaysNothingWhereItMustNot) {
  EXPECT_EQ(reported_to_a_file(ProgressDisplay::kNone), "");
}

TEST(ProgressReporter, WipesALineAndLeavesAMapOnATerminal) {
  CountedLines source;
  const console::Terminal terminal;
  ProgressReporter line(terminal.file(), ProgressDisplay::kLine);
  line.report(source);
  line.finish(source);
  EXPECT_EQ(terminal.shown(), "\r\033[Kline 1\r\033[K");
  ProgressReporter map(terminal.file(), ProgressDisplay::kMap);
  map.report(source);
  map.finish(source);
  const std::string shown = terminal.shown();
  EXPECT_THAT(shown, testing::HasSubstr("exploring"));
  EXPECT_EQ(shown.back(), '\n');
}

TEST(ProgressDisplay, IsWhatTheOptionsSay) {
  RunOptions run;
  EXPECT_EQ(progress_display(run), ProgressDisplay::kLine);
  run.view = "map";
  EXPECT_EQ(progress_display(run), ProgressDisplay::kMap);
  run.headless = true;
  EXPECT_EQ(progress_display(run), ProgressDisplay::kNone);
  run.headless = false;
  run.view = "none";
  EXPECT_EQ(progress_display(run), ProgressDisplay::kNone);
}

}  // namespace
}  // namespace echomap::apps
