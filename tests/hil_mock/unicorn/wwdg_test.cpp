// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/wwdg.hpp"

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

constexpr std::uint64_t kStepCycles = 4096 * 8 * 2;

TEST(Wwdg, WarnsAtItsLastGoodCountAndResetsAStepLaterUnlessKicked) {
  EventQueue queue;
  Nvic nvic;
  Wwdg wwdg(queue, nvic);
  int timeouts = 0;
  wwdg.on_timeout = [&] { ++timeouts; };
  wwdg.reset();
  wwdg.write(0x0, 0xFF);
  wwdg.write(0x4, 0x3FF);
  const auto pass = [&](std::uint64_t steps) {
    queue.spend(steps * kStepCycles);
    queue.call_due();
  };
  pass(60);
  wwdg.write(0x0, 0xFF);
  pass(62);
  EXPECT_EQ(wwdg.read(0x8), 0U);
  pass(1);
  EXPECT_EQ(wwdg.read(0x8), 1U);
  EXPECT_EQ(timeouts, 0);
  pass(1);
  EXPECT_EQ(timeouts, 1);
}

}  // namespace
}  // namespace echomap::unicorn
