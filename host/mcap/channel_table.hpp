// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "host/mcap/file_layout.hpp"
#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// The schemas and channels that a file has defined so far.
class ChannelTable {
 public:
  /// Takes a schema, a channel or a message, and returns the message; other kinds are ignored.
  /// Throws RecordError where a record does not fit its definition, refers to what is not defined,
  /// or defines an identifier again in another way.
  std::optional<Message> take(Opcode opcode, std::span<const std::uint8_t> content);

 private:
  void take_schema(std::span<const std::uint8_t> content);
  void take_channel(std::span<const std::uint8_t> content);
  Message message_of(std::span<const std::uint8_t> content) const;

  std::map<std::uint16_t, std::shared_ptr<const Schema>> schemas_;
  std::map<std::uint16_t, std::shared_ptr<const Channel>> channels_;
};

}  // namespace echomap::mcap
