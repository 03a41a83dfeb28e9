// SPDX-License-Identifier: MIT
#include "host/papers/paper_list.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::papers {
namespace {

TEST(PaperList, KnowsItsPapersByTheirNumbers) {
  EXPECT_THAT(paper_numbers(), testing::Contains("000"));
  EXPECT_THROW(repeat_paper("999", {}), std::out_of_range);
  PaperSettings none;
  none.runs = 0;
  EXPECT_THROW(repeat_paper("000", none), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::papers
