// SPDX-License-Identifier: MIT
#include "host/broker/broker_settings.hpp"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::broker {
namespace {

using testing::HasSubstr;

BrokerSettings settings_of_two() {
  BrokerSettings settings;
  settings.users = {{"robot1", "12345678"}, {"hub", "abcdefgh"}};
  return settings;
}

/// What is said of settings after a change.
std::string refusal_after(const std::function<void(BrokerSettings&)>& change) {
  BrokerSettings settings = settings_of_two();
  change(settings);
  try {
    validate(settings);
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kConfigInvalid);
    return error.what();
  }
  return "";
}

TEST(BrokerSettings, DefaultsAreValidAndListenOnLoopback) {
  EXPECT_NO_THROW(validate(settings_of_two()));
  EXPECT_EQ(settings_of_two().address, "127.0.0.1");
}

TEST(BrokerSettings, ANameIsOneLevelOfATopic) {
  EXPECT_THAT(refusal_after([](auto& s) { s.users[0].name = "a/b"; }), HasSubstr("'a/b'"));
  EXPECT_THAT(refusal_after([](auto& s) { s.fleet = "#"; }), HasSubstr("fleet = '#'"));
  EXPECT_THAT(refusal_after([](auto& s) { s.fleet = "Lab"; }), HasSubstr("'Lab' is no name"))
      << "no robot could join it";
}

TEST(BrokerSettings, RefusesWhatWouldBreakAFile) {
  EXPECT_THAT(refusal_after([](auto& s) { s.users[0].password = "1234567"; }), HasSubstr("robot1"));
  EXPECT_NE(refusal_after([](auto& s) { s.users[0].password = "12345678\nx:y"; }), "");
  EXPECT_NE(refusal_after([](auto& s) { s.users[0].password = "1234:5678"; }), "");
  EXPECT_NE(refusal_after([](auto& s) { s.address = "127.0.0.1\nallow_anonymous true"; }), "");
  EXPECT_NE(refusal_after([](auto& s) { s.host_names = {"a,DNS:b"}; }), "");
  EXPECT_NE(refusal_after([](auto& s) { s.users[0].name = "hub"; }), "") << "twice";
  EXPECT_NE(refusal_after([](auto& s) { s.max_payload_bytes = 10; }), "");
  EXPECT_NE(refusal_after([](auto& s) { s.max_queued_bytes = 10; }), "");
  EXPECT_NE(refusal_after([](auto& s) { s.save_interval_s = -1; }), "");
  EXPECT_NE(refusal_after([](auto& s) {
              s.bridge = SiteBridge{"up", 1883, "region", "a/b", "12345678", {}};
            }),
            "");
}

TEST(BrokerSettings, APasswordIsDrawnEachTime) {
  EXPECT_EQ(random_password().size(), 32U);
  EXPECT_NE(random_password(), random_password());
}

}  // namespace
}  // namespace echomap::broker
