// SPDX-License-Identifier: MIT
#include "host/robot_link/command.hpp"

#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "protocol/messages.hpp"

namespace echomap::robot_link {
namespace {

TEST(CommandOutcome, HasANameOfItsOwnForEach) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(CommandOutcome::kRobotReset); ++i) {
    names.insert(to_string(static_cast<CommandOutcome>(i)));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(CommandOutcome::kRobotReset) + 1);
  EXPECT_FALSE(names.contains("unknown"));
}

struct CountCommands {
  int count = 0;
  template <class Message>
  void operator()(const Message* /*tag*/) {
    count += Message::message_class() == protocol::MessageClass::kCommand ? 1 : 0;
  }
};

TEST(Command, HoldsEveryCommandOfTheProtocol) {
  CountCommands counter;
  protocol::AllMessages::for_each(counter);
  EXPECT_EQ(std::variant_size_v<Command>, static_cast<std::size_t>(counter.count));
}

}  // namespace
}  // namespace echomap::robot_link
