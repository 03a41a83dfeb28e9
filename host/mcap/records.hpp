// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace echomap::mcap {

/// A block of bytes: the payload of a message, an attachment or a part of a file.
using Bytes = std::vector<std::uint8_t>;

/// Named texts, sorted by name so that equal maps are written as equal bytes.
using TextMap = std::map<std::string, std::string>;

/// What a file says of itself in its first record.
struct HeaderInfo {
  std::string profile;  ///< Convention that channels and schemas follow, as "ros2"; may be empty.
  std::string library;  ///< Program that wrote the file.

  bool operator==(const HeaderInfo&) const = default;
};

/// Definition of the type of a channel's messages.
struct Schema {
  std::string name;      ///< Name of the type, as "std_msgs/msg/String".
  std::string encoding;  ///< Language of `data`, as "ros2msg".
  std::string data;      ///< The definition, a text or bytes.

  bool operator==(const Schema&) const = default;
};

/// What the messages of one topic have in common.
struct ChannelInfo {
  std::string topic;
  std::uint16_t schema_id = 0;   ///< 0: the channel has no schema.
  std::string message_encoding;  ///< Encoding of the payloads, as "cdr".
  TextMap metadata;

  bool operator==(const ChannelInfo&) const = default;
};

/// A channel of a file that is read. `schema` is null where the channel has none.
struct Channel {
  std::uint16_t id = 0;
  ChannelInfo info;
  std::shared_ptr<const Schema> schema;
};

/// One message. Times are in nanoseconds since an epoch that writer and reader agree on; `channel`
/// is never null.
struct Message {
  std::shared_ptr<const Channel> channel;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t publish_time_ns = 0;
  Bytes data;
};

/// A whole file that lies within the MCAP file.
struct Attachment {
  std::uint64_t log_time_ns = 0;
  std::uint64_t create_time_ns = 0;
  std::string name;
  std::string media_type;  ///< As "text/plain".
  Bytes data;

  bool operator==(const Attachment&) const = default;
};

/// A named set of texts about the file.
struct Metadata {
  std::string name;
  TextMap entries;

  bool operator==(const Metadata&) const = default;
};

/// One thing that a reader hands out.
using Record = std::variant<Message, Attachment, Metadata>;

}  // namespace echomap::mcap
