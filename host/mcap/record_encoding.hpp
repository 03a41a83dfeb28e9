// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "host/mcap/records.hpp"

namespace echomap::mcap {

/// The fields of a message record; `data` is the payload, which somebody else owns.
struct MessageFields {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t publish_time_ns = 0;
  std::span<const std::uint8_t> data;
};

/// Each function appends one record of the data section to `out`, as https://mcap.dev/spec lays it
/// out.
void append_header(Bytes& out, const HeaderInfo& header);
void append_schema(Bytes& out, std::uint16_t id, const Schema& schema);
void append_channel(Bytes& out, std::uint16_t id, const ChannelInfo& channel);
void append_message(Bytes& out, const MessageFields& message);
void append_attachment(Bytes& out, const Attachment& attachment);
void append_metadata(Bytes& out, const Metadata& metadata);
void append_data_end(Bytes& out, std::uint32_t data_crc);

}  // namespace echomap::mcap
