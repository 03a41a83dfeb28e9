// SPDX-License-Identifier: MIT
#include "host/console/progress_bar.hpp"

#include <cstdio>

#include <gtest/gtest.h>

#include "tests/host/console/terminal.hpp"

namespace echomap::console {
namespace {

TEST(ProgressBar, DrawsItsShare) {
  EXPECT_EQ(bar_of(0.0, 10), "[          ]");
  EXPECT_EQ(bar_of(0.5, 10), "[====>     ]");
  EXPECT_EQ(bar_of(1.0, 10), "[==========]");
  EXPECT_EQ(bar_of(7.0, 4), "[====]");
}

TEST(ProgressBar, KeepsItsLineWithinTheTerminal) {
  EXPECT_EQ(clipped("4 stops", 5), "4 sto");
  EXPECT_EQ(clipped("4 stops", 80), "4 stops");
  EXPECT_EQ(clipped("4 stops", 0), "4 stops") << "nobody knows how wide it is";
}

TEST(ProgressBar, SaysNothingWhereNobodyLooks) {
  std::FILE* file = std::tmpfile();
  {
    ProgressBar bar(file);
    bar.show(0.5, "half");
    bar.show("so far");
  }
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
}

TEST(ProgressBar, MakesWayForALineAndComesBackAtOnce) {
  const Terminal terminal;
  make_way_for_a_line();
  ProgressBar bar(terminal.file());
  bar.show("4 stops");
  make_way_for_a_line();
  make_way_for_a_line();
  std::fputs("a line\n", terminal.file());
  bar.show("5 stops");
  EXPECT_EQ(terminal.shown(), "\r\033[K4 stops\r\033[Ka line\n\r\033[K5 stops");
}

TEST(ProgressBar, MakesNoWayWhereItIsGone) {
  const Terminal terminal;
  { ProgressBar(terminal.file()).show("4 stops"); }
  make_way_for_a_line();
  EXPECT_EQ(terminal.shown(), "\r\033[K4 stops\r\033[K");
}

}  // namespace
}  // namespace echomap::console
