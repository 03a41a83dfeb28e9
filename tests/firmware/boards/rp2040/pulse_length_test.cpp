// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/pulse_length.hpp"

#include <gtest/gtest.h>

namespace echomap::boards {
namespace {

TEST(EchoLength, IsTheCountedOneHoweverLateTheInterruptsCome) {
  for (const std::uint32_t exact : {0U, 1U, 232U, 11'600U, 65'535U, 65'536U, 76'000U, 400'000U}) {
    for (const std::int32_t late : {-200, -1, 0, 1, 200, 20'000}) {
      const auto by_clock = static_cast<std::int64_t>(exact) + late;
      if (by_clock >= 0) {
        EXPECT_EQ(echo_length_half_us(static_cast<std::uint32_t>(by_clock),
                                      static_cast<std::uint16_t>(exact)),
                  exact)
            << late;
      }
    }
  }
}

TEST(EchoLength, IsNeverNegative) { EXPECT_EQ(echo_length_half_us(2, 65'530), 65'530U); }

}  // namespace
}  // namespace echomap::boards
