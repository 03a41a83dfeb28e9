// SPDX-License-Identifier: MIT
#include "host/transport/bounded_call.hpp"

#include <memory>

#include <gtest/gtest.h>

namespace echomap::transport {
namespace {

TEST(BoundedCall, AnswersWhatTheWorkReturns) {
  EXPECT_EQ(finish_within(std::chrono::seconds(60), [] { return 42; }), 42);
}

TEST(BoundedCall, LeavesWorkToItselfThatDoesNotEnd) {
  const auto never = std::make_shared<std::promise<int>>();
  EXPECT_FALSE(
      finish_within(std::chrono::milliseconds(20),
                    [never, result = never->get_future().share()] { return result.get(); }));
  never->set_value(1);
}

}  // namespace
}  // namespace echomap::transport
