// SPDX-License-Identifier: MIT
#include "host/mqtt/reason.hpp"

#include <set>

#include <gtest/gtest.h>

namespace echomap::mqtt {
namespace {

TEST(Reason, NamesTheCodesOfTheStandard) {
  EXPECT_EQ(reason_of_code(0x00), Reason::kNone);
  EXPECT_EQ(reason_of_code(0x10), Reason::kNone) << "nobody subscribes is no error";
  EXPECT_EQ(reason_of_code(0x87), Reason::kNotAuthorized);
  EXPECT_EQ(reason_of_code(0x95), Reason::kTooLarge);
  EXPECT_EQ(reason_of_code(0x8e), Reason::kTakenOver);
  EXPECT_EQ(reason_of_code(0x8b), Reason::kShuttingDown);
  EXPECT_EQ(reason_of_code(0x82), Reason::kProtocolError);
  EXPECT_EQ(reason_of_code(0x9f), Reason::kRefused);
}

TEST(Reason, OfAConnackNotAuthorizedIsAWrongPassword) {
  EXPECT_EQ(reason_of_connack(0), Reason::kNone);
  EXPECT_EQ(reason_of_connack(0x86), Reason::kWrongPassword);
  EXPECT_EQ(reason_of_connack(0x87), Reason::kWrongPassword);
  EXPECT_EQ(reason_of_connack(5), Reason::kWrongPassword) << "MQTT 3.1.1";
  EXPECT_EQ(reason_of_connack(2), Reason::kRefused);
  EXPECT_EQ(reason_of_connack(0x89), Reason::kRefused);
}

TEST(Reason, EachHasATextOfItsOwn) {
  std::set<std::string_view> texts;
  for (int i = 0; i <= static_cast<int>(Reason::kLost); ++i) {
    const auto text = text_of(static_cast<Reason>(i));
    EXPECT_FALSE(text.empty());
    EXPECT_TRUE(texts.insert(text).second) << text;
  }
}

}  // namespace
}  // namespace echomap::mqtt
