// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/robot_link/bulk_reader.hpp"
#include "host/robot_link/command.hpp"
#include "protocol/configuration.hpp"

namespace echomap::session {

/// The configuration in a bulk content; empty where it is none, or of other messages than ours.
std::optional<protocol::Configuration> configuration_in(const robot_link::BulkResult& result);

/// The commands that bring a robot from what it holds to what it shall hold, in the order of their
/// ids; all of them where it is not known what it holds.
std::vector<robot_link::Command> commands_between(
    const std::optional<protocol::Configuration>& held, const protocol::Configuration& wanted);

/// The first field that is not as wanted, in words: "ConfigurePan.max_cdeg is 9000, not 36000";
/// empty where all are.
std::string first_difference(const protocol::Configuration& held,
                             const protocol::Configuration& wanted);

/// "ConfigurePan" for such a command.
std::string name_of(const robot_link::Command& command);

}  // namespace echomap::session
