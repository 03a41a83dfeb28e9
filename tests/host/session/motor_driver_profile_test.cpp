// SPDX-License-Identifier: MIT
#include "host/session/motor_driver_profile.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::session {
namespace {

using protocol::kBrakeAtZero;
using protocol::kSlowPwm;
using protocol::MotorBridgeKind;
using ::testing::HasSubstr;

protocol::ConfigureWiring wiring_in(const std::string& text) {
  protocol::ConfigureWiring wiring{};
  read_motor_driver(files::TomlReader::parse(text, "robot.toml"), wiring);
  return wiring;
}

std::string driver_error(const std::string& text) {
  try {
    wiring_in(text);
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "no error";
}

struct KnownDriver {
  const char* name;
  MotorBridgeKind kind;
  unsigned options;
};

TEST(MotorDriverProfile, KnowsTheChipsAndKitsThatPeopleBuy) {
  constexpr KnownDriver kDrivers[] = {{"phase-enable", MotorBridgeKind::kPhaseEnable, 0},
                                      {"drv8835", MotorBridgeKind::kPhaseEnable, 0},
                                      {"tb6612fng", MotorBridgeKind::kIn1In2Pwm, 0},
                                      {"l298n", MotorBridgeKind::kIn1In2Pwm, 0},
                                      {"l293d", MotorBridgeKind::kIn1In2Pwm, kSlowPwm},
                                      {"drv8833", MotorBridgeKind::kTwoPwm, 0},
                                      {"drv8835-in-in", MotorBridgeKind::kTwoPwm, 0},
                                      {"mdd3a", MotorBridgeKind::kTwoPwm, 0},
                                      {"mx1508", MotorBridgeKind::kTwoPwm, kSlowPwm},
                                      {"servo", MotorBridgeKind::kServo, 0}};
  for (const KnownDriver& driver : kDrivers) {
    const auto wiring = wiring_in(std::string("driver = '") + driver.name + "'");
    EXPECT_EQ(wiring.bridge, static_cast<int>(driver.kind)) << driver.name;
    EXPECT_EQ(wiring.bridge_options, driver.options) << driver.name;
  }
}

TEST(MotorDriverProfile, IsPhaseEnableWithoutAWord) {
  const auto wiring = wiring_in("");
  EXPECT_EQ(wiring.bridge, 0);
  EXPECT_EQ(wiring.bridge_options, 0);
}

TEST(MotorDriverProfile, StopsByCoastingUnlessToldToBrake) {
  EXPECT_EQ(wiring_in("driver = 'l293d'\nstop = 'coast'").bridge_options, kSlowPwm);
  EXPECT_EQ(wiring_in("driver = 'l293d'\nstop = 'brake'").bridge_options, kSlowPwm | kBrakeAtZero);
  EXPECT_EQ(wiring_in("driver = 'servo'\nstop = 'brake'").bridge_options, kBrakeAtZero);
}

TEST(MotorDriverProfile, PlacesAnUnknownWordAndTellsTheNearest) {
  const std::string error = driver_error("\ndriver = 'TB6612FN'");
  EXPECT_THAT(error, HasSubstr("robot.toml:2:"));
  EXPECT_THAT(error, HasSubstr("no motor driver is called 'TB6612FN'; did you mean 'tb6612fng'?"));
  EXPECT_THAT(driver_error("driver = 'vnh2sp30'"), HasSubstr("l298n"));
  EXPECT_THAT(driver_error("driver = 'l298n'\nstop = 'break'"), HasSubstr("did you mean 'brake'?"));
}

TEST(MotorDriverProfile, LeavesItToAPhaseEnableChipHowItStops) {
  EXPECT_THAT(driver_error("stop = 'brake'"), HasSubstr("its chip decides"));
  EXPECT_THAT(driver_error("driver = 'drv8835'\nstop = 'coast'"), HasSubstr("leave 'stop' out"));
}

TEST(MotorDriverProfile, TellsWhatToDoAboutARefusal) {
  EXPECT_THAT(advice_on_refused_bridge(wiring_in("driver = 'servo'")), HasSubstr("Mega"));
  EXPECT_THAT(advice_on_refused_bridge(wiring_in("driver = 'servo'")), HasSubstr("Pico"));
  EXPECT_THAT(advice_on_refused_bridge(wiring_in("driver = 'l298n'")), HasSubstr("D11, D12"));
  EXPECT_THAT(advice_on_refused_bridge(wiring_in("driver = 'l298n'")),
              HasSubstr("an EV3 has no driver but its own"));
}

}  // namespace
}  // namespace echomap::session
