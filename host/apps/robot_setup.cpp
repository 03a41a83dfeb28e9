// SPDX-License-Identifier: MIT
#include "host/apps/robot_setup.hpp"

#include <string>

#include <spdlog/spdlog.h>

#include "host/apps/configuration_check.hpp"
#include "host/apps/exit_code.hpp"
#include "protocol/config_digest.hpp"

namespace echomap::apps {
namespace {

using robot_link::CommandOutcome;

/// Begun anew when the board was reset in the middle of it, which a servo's first start on a weak
/// supply does.
constexpr int kTries = 5;

}  // namespace

bool RobotSetup::set_up() {
  for (int i = 0; i < kTries && !line_.end(); ++i) {
    if (try_to_set_up()) {
      return true;
    }
  }
  line_.end(SessionEnd::kLinkLost, "the robot on " + line_.name() + " is reset again and again");
  return false;
}

bool RobotSetup::try_to_set_up() {
  line_.forget_resets();
  if (!configure()) {
    return false;
  }
  const auto armed = line_.perform(protocol::Arm{0, 1});
  if (armed && armed->outcome == CommandOutcome::kBlocked) {
    line_.end(SessionEnd::kSafetyStop, "the board does not arm: a wheel hangs in the air");
  }
  return armed && armed->outcome == CommandOutcome::kAccepted && !line_.was_reset();
}

bool RobotSetup::configure() {
  const protocol::Configuration& wanted = profile_.configuration;
  const auto& robot = line_.link().robot();
  if (robot && robot->config_digest == protocol::config_digest(wanted)) {
    spdlog::debug("the board holds the configuration of profile '{}' already", profile_.name);
    return true;
  }
  const auto before = read_configuration();
  for (const robot_link::Command& command : commands_between(before, wanted)) {
    if (!send(command)) {
      return false;
    }
  }
  const auto after = read_configuration();
  if (!after) {
    return false;
  }
  if (const std::string difference = first_difference(*after, wanted); !difference.empty()) {
    throw CommandError(ExitCode::kConfigInvalid,
                       "the board does not hold what it was sent: " + difference +
                           "\n  next: ./run flash --port " + line_.name());
  }
  return !line_.was_reset();
}

bool RobotSetup::send(const robot_link::Command& command) {
  const auto result = line_.perform(command);
  if (result && result->outcome == CommandOutcome::kOutOfRange) {
    throw CommandError(ExitCode::kConfigInvalid,
                       "the board refuses " + name_of(command) + " of profile '" + profile_.name +
                           "': it has no such pins or sensors, or a number is out of its range\n"
                           "  next: compare the profile with the board's page in docs/hardware, or "
                           "update the firmware: ./run flash --port " +
                           line_.name());
  }
  return result && result->outcome == CommandOutcome::kAccepted;
}

std::optional<protocol::Configuration> RobotSetup::read_configuration() {
  const auto bulk = line_.read(protocol::BulkContent::kConfiguration);
  return bulk ? configuration_in(*bulk) : std::nullopt;
}

}  // namespace echomap::apps
