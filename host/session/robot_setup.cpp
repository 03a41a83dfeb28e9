// SPDX-License-Identifier: MIT
#include "host/session/robot_setup.hpp"

#include <string_view>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/boards/boards.hpp"
#include "host/session/motor_driver_profile.hpp"
#include "host/session/scalar_profile.hpp"

namespace echomap::session {
namespace {

using robot_link::BulkStatus;
using robot_link::CommandOutcome;

/// Started again when the board was reset in the middle of it, which a servo's first start on a
/// weak supply does, and when the link was lost.
constexpr int kTries = 5;
/// New pins may switch off a sensor that the board held as wanted before: what differs then is sent
/// once more, to be taken or refused.
constexpr int kRounds = 2;

std::string_view words_of(BulkStatus status) {
  switch (status) {
    case BulkStatus::kNotThere:
      return "the firmware reports none";
    case BulkStatus::kInconsistent:
      return "it changed while it was read";
    case BulkStatus::kWhole:
      return "it is of another firmware";
    case BulkStatus::kNoAnswer:
      break;
  }
  return "no answer";
}

}  // namespace

bool RobotSetup::set_up() {
  const auto resets = [this] { return line_.link().statistics().resets_seen; };
  const std::uint64_t resets_before = resets();
  for (int i = 0; i < kTries && line_.wait_until_ready(); ++i) {
    if (try_to_set_up()) {
      return true;
    }
  }
  line_.end(SessionEnd::kLinkLost, reason_of_failure(resets() - resets_before));
  return false;
}

std::string RobotSetup::reason_of_failure(std::uint64_t resets) const {
  if (resets > 1) {
    return fmt::format(
        "the robot on {} was reset again and again: {} times while it was configured\n"
        "  next: give servo and motors their own supply, or fresh batteries",
        line_.name(),
        resets);
  }
  return fmt::format(
      "the robot on {} could not be configured in {} tries; the last one failed: {}\n"
      "  next: check its cable and its supply, press its reset button and start again",
      line_.name(),
      kTries,
      failure_);
}

bool RobotSetup::try_to_set_up() {
  line_.forget_resets();
  failure_ = "the robot was reset meanwhile";
  return configure() && arm() && !line_.was_reset();
}

bool RobotSetup::configure() {
  const protocol::Configuration& wanted = profile_.configuration;
  const ConfigurationExtent extent = extent_of(line_.link().difference());
  if (!knows_what_is_wanted(extent)) {
    return false;
  }
  const auto& robot = line_.link().robot();
  if (robot && robot->config_digest == digest_of(wanted, extent)) {
    spdlog::debug("the board already has the configuration of profile '{}'", profile_.name);
    return true;
  }
  auto held = read_configuration(extent);
  for (int i = 0; i < kRounds; ++i) {
    for (const robot_link::Command& command : commands_between(held, wanted, extent)) {
      if (!send(command)) {
        return false;
      }
    }
    held = read_configuration(extent);
    if (!held) {
      return false;
    }
    if (first_difference(*held, wanted).empty()) {
      return !line_.was_reset();
    }
  }
  line_.end(
      SessionEnd::kConfigInvalid,
      "the board's configuration differs from what was sent: " +
          // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop leaves where it is empty
          first_difference(*held, wanted) + "\n  next: ./run flash --port " + line_.name());
  return false;
}

bool RobotSetup::knows_what_is_wanted(ConfigurationExtent extent) {
  std::string lack;
  if (extent == ConfigurationExtent::kWithoutWiring && !is_usual(profile_.configuration.wiring)) {
    lack = "1.3: it knows phase/enable motor drivers and contacts that close, and profile '" +
           profile_.name + "' has others";
  } else if (extent != ConfigurationExtent::kWhole && wants_scalar(profile_.configuration)) {
    lack = "1.4: it knows no scalar sensor, and profile '" + profile_.name + "' has one";
  }
  if (!lack.empty()) {
    line_.end(SessionEnd::kFirmwareMismatch,
              "the firmware of the robot on " + line_.name() + " is older than protocol " + lack +
                  "\n  next: ./run flash --port " + line_.name());
  }
  return lack.empty();
}

bool RobotSetup::arm() {
  const auto armed = line_.perform(protocol::Arm{0, 1});
  if (armed && armed->outcome == CommandOutcome::kBlocked) {
    line_.end(SessionEnd::kSafetyStop,
              "the board does not arm: a wheel is off the floor\n"
              "  next: put the robot on the floor and start again");
  }
  return is_accepted(protocol::Arm{}, armed);
}

bool RobotSetup::send(const robot_link::Command& command) {
  const auto result = line_.perform(command);
  if (result && result->outcome == CommandOutcome::kOutOfRange) {
    line_.end(SessionEnd::kConfigInvalid, "the board refuses " + words_of_refusal(command));
  }
  return is_accepted(command, result);
}

std::string RobotSetup::words_of_refusal(const robot_link::Command& command) const {
  const std::string of_profile = " of profile '" + profile_.name + "': ";
  if (const auto* const wiring = std::get_if<protocol::ConfigureWiring>(&command)) {
    return "the motor driver" + of_profile + advice_on_refused_bridge(*wiring);
  }
  const auto& robot = line_.link().robot();
  if (std::holds_alternative<protocol::ConfigurePins>(command) &&
      wants_scalar(profile_.configuration)) {
    return "the pins" + of_profile + advice_on_refused_scalar(robot ? robot->capabilities : 0);
  }
  return name_of(command) + of_profile +
         "it has no such pins or sensors, or a value is out of range: the profile is of another "
         "board, or wrong\n"
         "  next: name the robot on this board with --robot, usually " +
         boards::robots_of_boards() +
         ", compare the profile with the board's page in docs/hardware, or update the firmware: "
         "./run flash --port " +
         line_.name();
}

bool RobotSetup::is_accepted(const robot_link::Command& command,
                             const std::optional<robot_link::CommandResult>& result) {
  if (result && result->outcome == CommandOutcome::kAccepted) {
    return true;
  }
  failure_ =
      fmt::format("{}: {}", name_of(command), result ? to_string(result->outcome) : "no answer");
  return false;
}

std::optional<protocol::Configuration> RobotSetup::read_configuration(ConfigurationExtent extent) {
  const auto bulk = line_.read(protocol::BulkContent::kConfiguration);
  const auto configuration = bulk ? configuration_in(*bulk, extent) : std::nullopt;
  if (!configuration) {
    failure_ = fmt::format("reading its configuration: {}",
                           words_of(bulk ? bulk->status : BulkStatus::kNoAnswer));
  }
  return configuration;
}

}  // namespace echomap::session
