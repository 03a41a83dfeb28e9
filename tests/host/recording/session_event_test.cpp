// SPDX-License-Identifier: MIT
#include "host/recording/session_event.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace echomap::recording {
namespace {

TEST(SessionEventTest, EveryKindHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(SessionEventKind::kEndMaps); ++i) {
    const auto kind = static_cast<SessionEventKind>(i);
    EXPECT_EQ(event_kind(name_of(kind)), kind);
    names.insert(name_of(kind));
  }
  EXPECT_EQ(names.size(), 9U);
}

TEST(SessionEventTest, AnotherNameIsNone) { EXPECT_FALSE(event_kind("begin-scans")); }

}  // namespace
}  // namespace echomap::recording
