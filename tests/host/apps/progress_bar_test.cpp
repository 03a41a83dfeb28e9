// SPDX-License-Identifier: MIT
#include "host/apps/progress_bar.hpp"

#include <cstdio>

#include <gtest/gtest.h>

namespace echomap::apps {
namespace {

TEST(ProgressBar, DrawsItsShare) {
  EXPECT_EQ(bar_of(0.0, 10), "[          ]");
  EXPECT_EQ(bar_of(0.5, 10), "[====>     ]");
  EXPECT_EQ(bar_of(1.0, 10), "[==========]");
  EXPECT_EQ(bar_of(7.0, 4), "[====]");
}

TEST(ProgressBar, SaysNothingWhereNobodyLooks) {
  std::FILE* file = std::tmpfile();
  {
    ProgressBar bar(file);
    bar.show(0.5, "half");
  }
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
}

}  // namespace
}  // namespace echomap::apps
