// SPDX-License-Identifier: MIT
#include "host/session/configuration_check.hpp"

#include <gmock/gmock.h>

#include "protocol/config_digest.hpp"

namespace echomap::session {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

protocol::Configuration some_configuration() {
  protocol::Configuration configuration{};
  configuration.drive.max_ticks_per_s = 1234;
  configuration.pan.min_cdeg = -36000;
  configuration.pins.pin_15 = 23;
  return configuration;
}

std::vector<std::string> names_of(const std::vector<robot_link::Command>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const auto& command : commands) {
    names.push_back(name_of(command));
  }
  return names;
}

robot_link::BulkResult bulk_of(const protocol::Configuration& configuration) {
  const protocol::ConfigurationBytes bytes = protocol::configuration_bytes(configuration);
  return {protocol::BulkContent::kConfiguration,
          robot_link::BulkStatus::kWhole,
          {std::begin(bytes.bytes), std::end(bytes.bytes)}};
}

TEST(ConfigurationCheck, ReadsWhatABoardTells) {
  const auto held = configuration_in(bulk_of(some_configuration()));
  ASSERT_TRUE(held);
  EXPECT_EQ(first_difference(*held, some_configuration()), "");
  EXPECT_EQ(held->pan.min_cdeg, -36000);
}

TEST(ConfigurationCheck, ReadsNoneFromWhatIsNone) {
  auto bulk = bulk_of(some_configuration());
  bulk.bytes.pop_back();
  EXPECT_FALSE(configuration_in(bulk));
  bulk = bulk_of(some_configuration());
  bulk.bytes[0] ^= 1U;
  EXPECT_FALSE(configuration_in(bulk));
  bulk = bulk_of(some_configuration());
  bulk.status = robot_link::BulkStatus::kNoAnswer;
  EXPECT_FALSE(configuration_in(bulk));
}

TEST(ConfigurationCheck, SendsWhatDiffersAndAllToAnUnknownBoard) {
  const auto wanted = some_configuration();
  EXPECT_THAT(names_of(commands_between(wanted, wanted)), IsEmpty());
  auto held = wanted;
  held.pins.pin_15 = 0;
  held.drive.integral = 9;
  EXPECT_THAT(names_of(commands_between(held, wanted)),
              ElementsAre("ConfigureDrive", "ConfigurePins"));
  EXPECT_THAT(names_of(commands_between({}, wanted)),
              ElementsAre("ConfigureDrive",
                          "ConfigureSonar",
                          "ConfigurePan",
                          "ConfigurePins",
                          "ConfigureWiring",
                          "ConfigurePins",
                          "ConfigureSensors",
                          "ConfigureSafety",
                          "ConfigureScalar"));
}

TEST(ConfigurationCheck, FreesThePinsBeforeBridgesTakeThemAndUsesThemAfterwards) {
  const auto held = some_configuration();
  auto wanted = held;
  wanted.pins.pin_15 = 1;
  wanted.wiring.bridge = 1;
  const auto commands = commands_between(held, wanted);
  ASSERT_THAT(names_of(commands), ElementsAre("ConfigurePins", "ConfigureWiring", "ConfigurePins"));
  EXPECT_EQ(std::get<protocol::ConfigurePins>(commands[0]).pin_15, protocol::kPinUnused);
  EXPECT_EQ(std::get<protocol::ConfigurePins>(commands[2]).pin_15, 1);
  wanted.pins = held.pins;
  EXPECT_THAT(names_of(commands_between(held, wanted)), ElementsAre("ConfigureWiring"));
}

TEST(ConfigurationCheck, ReadsOlderRobotsAsOnesWithTheUsualWiring) {
  constexpr auto kOlder = ConfigurationExtent::kWithoutWiring;
  auto bulk = bulk_of(some_configuration());
  EXPECT_FALSE(configuration_in(bulk, kOlder));
  bulk.bytes.resize(bulk.bytes.size() - protocol::payload_size_of<protocol::ConfigureWiring>() -
                    protocol::payload_size_of<protocol::ConfigureScalar>());
  const auto held = configuration_in(bulk, kOlder);
  ASSERT_TRUE(held);
  EXPECT_TRUE(is_usual(held->wiring));
  EXPECT_THAT(commands_between(held, some_configuration(), kOlder), IsEmpty());
  EXPECT_FALSE(configuration_in(bulk));
  EXPECT_THAT(names_of(commands_between({}, some_configuration(), kOlder)),
              ElementsAre("ConfigureDrive",
                          "ConfigureSonar",
                          "ConfigurePan",
                          "ConfigurePins",
                          "ConfigureSensors",
                          "ConfigureSafety"));
}

TEST(ConfigurationCheck, ReadsRobotsBeforeTheScalarSensorAsOnesWithout) {
  constexpr auto kBefore = ConfigurationExtent::kWithoutScalar;
  auto wired = some_configuration();
  wired.wiring.bridge = 2;
  auto bulk = bulk_of(wired);
  EXPECT_FALSE(configuration_in(bulk, kBefore));
  bulk.bytes.resize(bulk.bytes.size() - protocol::payload_size_of<protocol::ConfigureScalar>());
  const auto held = configuration_in(bulk, kBefore);
  ASSERT_TRUE(held);
  EXPECT_EQ(held->wiring.bridge, 2);
  EXPECT_EQ(held->scalar.period_ms, 0);
  auto wanted = wired;
  wanted.scalar.period_ms = 50;
  EXPECT_THAT(commands_between(held, wanted, kBefore), IsEmpty());
  EXPECT_EQ(digest_of(wanted, kBefore), digest_of(wired, kBefore));
  wanted.wiring.bridge = 1;
  EXPECT_NE(digest_of(wanted, kBefore), digest_of(wired, kBefore));
}

TEST(ConfigurationCheck, DigestsAsMuchAsTheRobotHolds) {
  auto configuration = some_configuration();
  EXPECT_EQ(digest_of(configuration, ConfigurationExtent::kWhole),
            protocol::config_digest(configuration));
  const auto older = digest_of(configuration, ConfigurationExtent::kWithoutWiring);
  configuration.wiring.bridge = 2;
  EXPECT_EQ(digest_of(configuration, ConfigurationExtent::kWithoutWiring), older);
  configuration.safety.stall_ms = 77;
  EXPECT_NE(digest_of(configuration, ConfigurationExtent::kWithoutWiring), older);
}

TEST(ConfigurationCheck, NamesTheFirstFieldThatDiffers) {
  const auto wanted = some_configuration();
  auto held = wanted;
  held.safety.stall_ms = 5;
  held.pan.min_cdeg = 9000;
  EXPECT_EQ(first_difference(held, wanted), "ConfigurePan.min_cdeg is 9000, not -36000");
}

TEST(ConfigurationCheck, DoesNotCareForCommandIds) {
  const auto wanted = some_configuration();
  auto held = wanted;
  held.sonar.command_id = 77;
  EXPECT_EQ(first_difference(held, wanted), "");
  EXPECT_THAT(commands_between(held, wanted), IsEmpty());
}

}  // namespace
}  // namespace echomap::session
