// SPDX-License-Identifier: MIT
#include "host/terminal_view/terminal_screen.hpp"

#include <cstdio>

#include <gtest/gtest.h>
#include <sys/ioctl.h>

#include "tests/host/console/terminal.hpp"

namespace echomap::terminal_view {
namespace {

using console::Terminal;
using std::chrono::milliseconds;

class Screen : public testing::Test {
 protected:
  ScreenSurroundings surroundings(TerminalKind kind = {Glyphs::kAscii, true}) {
    return {[this] { return size; }, [this] { return now; }, kind};
  }
  void wait(milliseconds time) { now += time; }

  Terminal terminal;
  TextSize size{40, 16};
  std::chrono::steady_clock::time_point now{};
};

TEST_F(Screen, DrawsOverItsLastFrameWhatHasChanged) {
  TerminalScreen screen(terminal.file(), true, surroundings());
  screen.show({"map", "1 stop"});
  wait(milliseconds(200));
  screen.show({"map", "2 stops"});
  wait(milliseconds(200));
  screen.show({"map", "2 stops"});
  EXPECT_EQ(terminal.shown(), "map\n1 stop\n\r\033[2A\n2 stops\033[K\n");
}

TEST_F(Screen, DrawsFiveFramesASecondAtMost) {
  TerminalScreen screen(terminal.file(), true, surroundings());
  int frames = 0;
  for (int i = 0; i < 1000; ++i) {
    frames += screen.is_due() ? 1 : 0;
    screen.show({std::to_string(i)});
    wait(milliseconds(1));
  }
  EXPECT_EQ(frames, 5);
}

TEST_F(Screen, MakesWayForALineAndComesBackBelowIt) {
  TerminalScreen screen(terminal.file(), true, surroundings());
  screen.show({"map", "1 stop"});
  console::make_way_for_a_line();
  console::make_way_for_a_line();
  std::fputs("a line\n", terminal.file());
  wait(milliseconds(200));
  screen.show({"map", "2 stops"});
  EXPECT_EQ(terminal.shown(), "map\n1 stop\n\r\033[2A\033[Ja line\nmap\n2 stops\n");
}

TEST_F(Screen, WipesAFrameOfAnotherHeight) {
  TerminalScreen screen(terminal.file(), true, surroundings());
  screen.show({"map", "map", "1 stop"});
  wait(milliseconds(200));
  screen.show({"1 stop"});
  EXPECT_EQ(terminal.shown(), "map\nmap\n1 stop\n\r\033[3A\033[J1 stop\n");
}

TEST_F(Screen, WipesTheLinesThatANarrowerTerminalHasWrapped) {
  TerminalScreen screen(terminal.file(), true, surroundings());
  screen.show({"12345678", "1"});
  size.columns = 4;
  EXPECT_EQ(screen.room().columns, 3);
  wait(milliseconds(200));
  screen.show({"123", "1"});
  EXPECT_EQ(terminal.shown(), "12345678\n1\n\r\033[3A\033[J123\n1\n");
}

TEST_F(Screen, LeavesItsLastFrameAndPrintsBelow) {
  {
    TerminalScreen screen(terminal.file(), true, surroundings());
    screen.show({"1 stop"});
    screen.finish({"2 stops"});
    console::make_way_for_a_line();
  }
  console::make_way_for_a_line();
  EXPECT_EQ(terminal.shown(), "1 stop\n\r\033[1A2 stops\033[K\n") << "not due, and drawn";
}

TEST_F(Screen, LeavesTheFrameWhereAnExceptionEndsIt) {
  { TerminalScreen(terminal.file(), true, surroundings()).show({"1 stop"}); }
  console::make_way_for_a_line();
  EXPECT_EQ(terminal.shown(), "1 stop\n") << "the cursor is below, and was never hidden";
}

TEST_F(Screen, PrintsFramesWithoutEscapesOnADumbTerminal) {
  TerminalScreen screen(terminal.file(), true, surroundings({Glyphs::kAscii, false}));
  screen.show({"1 stop"});
  wait(milliseconds(29999));
  screen.show({"2 stops"});
  wait(milliseconds(1));
  screen.show({"3 stops"});
  console::make_way_for_a_line();
  EXPECT_EQ(terminal.shown(), "1 stop\n3 stops\n");
}

TEST_F(Screen, LeavesAQuarterOfTheTerminalToTheLog) {
  const TerminalScreen screen(terminal.file(), true, surroundings());
  EXPECT_EQ(screen.room(), (TextSize{39, 12}));
  size = {1, 1};
  EXPECT_EQ(screen.room(), (TextSize{1, 1}));
}

TEST_F(Screen, SaysNothingWhereItMustNot) {
  TerminalScreen screen(terminal.file(), false, surroundings());
  screen.show({"1 stop"});
  screen.finish({"1 stop"});
  EXPECT_EQ(terminal.shown(), "");
}

TEST_F(Screen, SaysNothingWhereNoTerminalIs) {
  std::FILE* file = std::tmpfile();
  {
    TerminalScreen screen(file, true, surroundings());
    EXPECT_FALSE(screen.is_active());
    screen.show({"1 stop"});
    screen.finish({"1 stop"});
  }
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
}

TEST(TerminalSize, FollowsTheTerminal) {
  const Terminal terminal;
  EXPECT_EQ(terminal_size(terminal.file()), TextSize()) << "it does not know its own";
  const winsize size{50, 132, 0, 0};
  ASSERT_EQ(::ioctl(::fileno(terminal.file()), TIOCSWINSZ, &size), 0);
  EXPECT_EQ(terminal_size(terminal.file()), (TextSize{132, 50}));
}

}  // namespace
}  // namespace echomap::terminal_view
