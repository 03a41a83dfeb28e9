// SPDX-License-Identifier: MIT
#include "host/tracking/fix_stream.hpp"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "tests/host/tracking/told_stream.hpp"
#include "tests/support/host_times.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::tracking {
namespace {

using ::testing::HasSubstr;
using tests::at_ms;

std::string line(double stamp_s, double sent_s) {
  return "{\"stamp_s\": " + std::to_string(stamp_s) + ", \"sent_s\": " + std::to_string(sent_s) +
         ", \"x_m\": 1, \"y_m\": 2, \"heading_rad\": 0}\n";
}

class FixStreamTest : public ::testing::Test {
 protected:
  std::string bytes;
  FixStream fixes{std::make_unique<tests::ToldStream>(bytes)};
};

TEST_F(FixStreamTest, PlacesPicturesOnTheHostsClock) {
  bytes = line(900.0, 900.1);
  const auto first = fixes.take(at_ms(5000));
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].taken, at_ms(4900));
  bytes = line(901.0, 901.1);
  EXPECT_EQ(fixes.take(at_ms(6300))[0].taken, at_ms(5900)) << "200 ms more on its way";
}

TEST_F(FixStreamTest, TakesLinesInPiecesAndCountsThoseThatAreNone) {
  const std::string whole = line(900.0, 900.1);
  bytes = "garbage\n" + whole + "{\"stamp_s\": 1}\n" + whole.substr(0, 30);
  EXPECT_EQ(fixes.take(at_ms(1)).size(), 1U);
  bytes = whole.substr(30);
  EXPECT_EQ(fixes.take(at_ms(2)).size(), 1U);
  EXPECT_EQ(fixes.fixes(), 2U);
  EXPECT_EQ(fixes.bad_lines(), 2U);
}

TEST_F(FixStreamTest, LeavesOutALineThatNeverEnds) {
  bytes = std::string(100'000, ' ') + line(1.0, 1.0) + line(2.0, 2.0);
  std::size_t taken = 0;
  while (!bytes.empty()) {
    taken += fixes.take(at_ms(1)).size();
  }
  EXPECT_EQ(taken, 1U);
  EXPECT_EQ(fixes.bad_lines(), 1U);
}

TEST_F(FixStreamTest, ComesBackFromASenderWithoutEnd) {
  bytes = std::string(100'000, '\n');
  fixes.take(at_ms(1));
  EXPECT_EQ(bytes.size(), 100'000U - 64 * 7);
}

TEST_F(FixStreamTest, LosesOneFixByALineOfAnotherClock) {
  for (int i = 0; i < 10; ++i) {
    const double sent_s = i == 3 ? 5000.0 : 900.0 + 0.1 * i;
    bytes = line(sent_s - 0.1, sent_s);
    const auto taken = fixes.take(at_ms(5000 + 100 * i));
    ASSERT_EQ(taken.size(), i == 3 ? 0U : 1U) << i;
    EXPECT_TRUE(taken.empty() || taken[0].taken == at_ms(4900 + 100 * i)) << i;
  }
  EXPECT_EQ(fixes.bad_lines(), 1U);
}

TEST_F(FixStreamTest, FollowsACameraThatWasStarted) {
  bytes = line(900.0, 900.1);
  fixes.take(at_ms(5000));
  std::vector<TimedFix> taken;
  for (int i = 0; i < 3; ++i) {
    bytes = line(0.1 * i, 0.1 * i + 0.1);
    taken = fixes.take(at_ms(9000 + 100 * i));
  }
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].taken, at_ms(9100));
  EXPECT_EQ(fixes.bad_lines(), 2U);
}

TEST(OpenFixes, SaysWhatIsWrongAndWhatToDo) {
  for (const char* wrong :
       {"127.0.0.1:7001", "udp:127.0.0.1", "udp:there:7001", "tcp:127.0.0.1:1"}) {
    const auto text = tests::thrown_text<console::CommandError>([&] { open_fixes(wrong); });
    EXPECT_THAT(text, HasSubstr("next: ")) << wrong;
  }
}

}  // namespace
}  // namespace echomap::tracking
