// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/configuration.hpp"

namespace echomap {
namespace protocol {

/// FNV-1a over the bytes of a configuration, the same on both sides when the same one holds.
inline uint32_t config_digest(const Configuration& configuration) {
  const ConfigurationBytes bytes = configuration_bytes(configuration);
  SchemaHash hash;
  for (uint8_t i = 0; i < ConfigurationBytes::kSize; ++i) {
    hash.add(static_cast<char>(bytes.bytes[i]));
  }
  return hash.value();
}

}  // namespace protocol
}  // namespace echomap
