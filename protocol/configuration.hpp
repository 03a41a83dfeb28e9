// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/command_messages.hpp"
#include "protocol/message_codec.hpp"

namespace echomap {
namespace protocol {

/// Everything that a host configures: one message of each kind, in the order of their ids.
struct Configuration {
  ConfigureDrive drive;
  ConfigureSonar sonar;
  ConfigurePan pan;
  ConfigurePins pins;
  ConfigureSensors sensors;
  ConfigureSafety safety;
  ConfigureWiring wiring;
  ConfigureScalar scalar;

  /// Calls `visitor(message)` for each, in this order.
  template <class C, class V>
  static void each(C& configuration, V& visitor) {
    visitor(configuration.drive);
    visitor(configuration.sonar);
    visitor(configuration.pan);
    visitor(configuration.pins);
    visitor(configuration.sensors);
    visitor(configuration.safety);
    visitor(configuration.wiring);
    visitor(configuration.scalar);
  }
};

/// A configuration as it goes over the wire (BulkContent::kConfiguration) and into its digest: for
/// each message its id, then its payload without the command_id.
struct ConfigurationBytes {
  static constexpr uint8_t kSize =
      payload_size_of<ConfigureDrive>() + payload_size_of<ConfigureSonar>() +
      payload_size_of<ConfigurePan>() + payload_size_of<ConfigurePins>() +
      payload_size_of<ConfigureSensors>() + payload_size_of<ConfigureSafety>() +
      payload_size_of<ConfigureWiring>() + payload_size_of<ConfigureScalar>();
  uint8_t bytes[kSize];
};

/// The bytes of a configuration; its command_ids do not show in them.
ConfigurationBytes configuration_bytes(const Configuration& configuration);

/// Reads a configuration, with command_ids of 0; false where an id is not the expected one.
bool read_configuration(const ConfigurationBytes& bytes, Configuration& configuration);

}  // namespace protocol
}  // namespace echomap
