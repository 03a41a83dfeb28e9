// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/robot_link/bulk_reader.hpp"
#include "host/robot_link/command.hpp"
#include "host/robot_link/robot_schema.hpp"
#include "protocol/configuration.hpp"

namespace echomap::session {

/// How much of a configuration a robot holds.
enum class ConfigurationExtent : std::uint8_t {
  kWhole,
  kWithoutScalar,  ///< Before protocol 1.4: no scalar sensor, which is a ConfigureScalar of zeros.
  /// Before protocol 1.3: neither that nor ConfigureWiring. Bridges are phase/enable and
  /// contacts close, which is what one of zeros says.
  kWithoutWiring,
};

/// Of the firmware that differs so from this host, or not at all.
ConfigurationExtent extent_of(const std::optional<robot_link::SchemaDifference>& difference);

/// True for phase/enable bridges and contacts that close.
bool is_usual(const protocol::ConfigureWiring& wiring);

/// The digest that a robot tells which holds this configuration, as far as it goes.
std::uint32_t digest_of(const protocol::Configuration& configuration, ConfigurationExtent extent);

/// The configuration in a bulk content; empty where it is none, or of other messages than ours.
std::optional<protocol::Configuration> configuration_in(
    const robot_link::BulkResult& result, ConfigurationExtent extent = ConfigurationExtent::kWhole);

/// The commands that bring a robot from what it holds to what it shall hold, in an order in which
/// it can take them; all of them where it is not known what it holds.
std::vector<robot_link::Command> commands_between(
    const std::optional<protocol::Configuration>& held,
    const protocol::Configuration& wanted,
    ConfigurationExtent extent = ConfigurationExtent::kWhole);

/// The first field that is not as wanted, in words: "ConfigurePan.max_cdeg is 9000, not 36000";
/// empty where all are.
std::string first_difference(const protocol::Configuration& held,
                             const protocol::Configuration& wanted);

/// "ConfigurePan" for such a command.
std::string name_of(const robot_link::Command& command);

}  // namespace echomap::session
