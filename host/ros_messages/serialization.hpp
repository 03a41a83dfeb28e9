// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/ros_messages/cdr_reader.hpp"
#include "host/ros_messages/cdr_writer.hpp"
#include "host/ros_messages/field_types.hpp"

namespace echomap::ros_messages {

/// Replaces the content of `bytes` with the message in CDR; the vector keeps its memory from one
/// message to the next.
template <Message M>
void serialize(const M& message, std::vector<std::uint8_t>& bytes) {
  CdrWriter writer(bytes);
  M::fields(message, writer);
}

/// The message in CDR, as `rmw_serialize` of ROS 2 makes it.
template <Message M>
std::vector<std::uint8_t> serialize(const M& message) {
  std::vector<std::uint8_t> bytes;
  serialize(message, bytes);
  return bytes;
}

/// The message that `bytes` hold in CDR of either byte order. Bytes behind the last field are
/// permitted: a newer version of a type appends fields. Throws CdrError.
template <Message M>
M deserialize(std::span<const std::uint8_t> bytes) {
  CdrReader reader(bytes, M::kName);
  M message;
  M::fields(message, reader);
  return message;
}

}  // namespace echomap::ros_messages
