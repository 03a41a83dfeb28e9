// SPDX-License-Identifier: MIT
#include "host/session/configuration_check.hpp"

#include <gmock/gmock.h>

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
                          "ConfigureSensors",
                          "ConfigureSafety",
                          "ConfigureWiring"));
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
