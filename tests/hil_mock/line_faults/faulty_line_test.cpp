// SPDX-License-Identifier: MIT
#include "hil_mock/line_faults/faulty_line.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/thrown_text.hpp"

namespace echomap::line_faults {
namespace {

std::string complaint(const std::string& text) {
  return tests::thrown_text<std::invalid_argument>([&] { parse_line_faults(text); });
}

TEST(LineFaults, AreReadInAnyOrder) {
  const LineFaults faults = parse_line_faults("seed=3,loss=0.01,cut=1e-5,flip=1e-4");
  EXPECT_EQ(faults.rates.flip, 1e-4);
  EXPECT_EQ(faults.rates.drop, 0.0);
  EXPECT_EQ(faults.rates.cut, 1e-5);
  EXPECT_EQ(faults.loss, 0.01);
  EXPECT_EQ(faults.seed, 3U);
}

TEST(LineFaults, NothingPassesDuringAnAbsence) {
  const LineFaults faults = parse_line_faults("away=60:5,away=80:0.5");
  EXPECT_FALSE(is_away(faults, 59.999));
  EXPECT_TRUE(is_away(faults, 60.0));
  EXPECT_TRUE(is_away(faults, 64.999));
  EXPECT_FALSE(is_away(faults, 65.0));
  EXPECT_TRUE(is_away(faults, 80.4));
}

TEST(LineFaults, ComplainInWords) {
  using testing::HasSubstr;
  EXPECT_THAT(complaint("flop=1"), HasSubstr("'flop=1': expected flip, drop"));
  EXPECT_THAT(complaint("flip"), HasSubstr("flip=: not a number"));
  EXPECT_THAT(complaint("flip=1e-4x"), HasSubstr("not a number"));
  EXPECT_THAT(complaint("drop=2"), HasSubstr("drop=2: it must be in 0 .. 1"));
  EXPECT_THAT(complaint("drop=nan"), HasSubstr("0 .. 1"));
  EXPECT_THAT(complaint("seed=-1"), HasSubstr("seed=-1: not a number"));
  EXPECT_THAT(complaint("away=60"), HasSubstr("away=: not a number"));
  EXPECT_THAT(complaint("away=-1:5"), HasSubstr("AT:FOR in seconds"));
  EXPECT_THAT(complaint("flip=0.7,cut=0.7"), HasSubstr("sum"));
}

TEST(FaultyLine, RepeatsWithItsSeedAndDiffersByDirection) {
  const LineFaults faults = parse_line_faults("flip=0.01,drop=0.01,loss=0.1,seed=7");
  const std::vector<std::uint8_t> bytes(5000, 0x55);
  FaultyLine line(faults, Direction::kToHost);
  const auto passed = line.pass(bytes);
  EXPECT_NE(passed, bytes);
  EXPECT_EQ(FaultyLine(faults, Direction::kToHost).pass(bytes), passed);
  EXPECT_NE(FaultyLine(faults, Direction::kToRobot).pass(bytes), passed);
}

}  // namespace
}  // namespace echomap::line_faults
