// SPDX-License-Identifier: MIT
#include "host/mcap/record_decoding.hpp"

#include "host/mcap/crc32.hpp"
#include "host/mcap/record_reader.hpp"

namespace echomap::mcap {

HeaderInfo decode_header(std::span<const std::uint8_t> content) {
  RecordReader reader(content);
  HeaderInfo header;
  header.profile = reader.text();
  header.library = reader.text();
  return header;
}

std::pair<std::uint16_t, Schema> decode_schema(std::span<const std::uint8_t> content) {
  RecordReader reader(content);
  std::pair<std::uint16_t, Schema> schema;
  schema.first = reader.number<std::uint16_t>();
  schema.second.name = reader.text();
  schema.second.encoding = reader.text();
  schema.second.data = reader.text();
  return schema;
}

std::pair<std::uint16_t, ChannelInfo> decode_channel(std::span<const std::uint8_t> content) {
  RecordReader reader(content);
  std::pair<std::uint16_t, ChannelInfo> channel;
  channel.first = reader.number<std::uint16_t>();
  channel.second.schema_id = reader.number<std::uint16_t>();
  channel.second.topic = reader.text();
  channel.second.message_encoding = reader.text();
  channel.second.metadata = reader.text_map();
  return channel;
}

MessageFields decode_message(std::span<const std::uint8_t> content) {
  RecordReader reader(content);
  MessageFields message;
  message.channel_id = reader.number<std::uint16_t>();
  message.sequence = reader.number<std::uint32_t>();
  message.log_time_ns = reader.number<std::uint64_t>();
  message.publish_time_ns = reader.number<std::uint64_t>();
  message.data = reader.rest();
  return message;
}

ChunkFields decode_chunk(std::span<const std::uint8_t> content) {
  RecordReader reader(content);
  ChunkFields chunk;
  reader.bytes(2 * sizeof(std::uint64_t));  // The first and the last log time.
  chunk.uncompressed_bytes = reader.number<std::uint64_t>();
  chunk.uncompressed_crc = reader.number<std::uint32_t>();
  chunk.compression = reader.text();
  chunk.records = reader.bytes(reader.number<std::uint64_t>());
  return chunk;
}

Attachment decode_attachment(std::span<const std::uint8_t> content) {
  RecordReader reader(content);
  Attachment attachment;
  attachment.log_time_ns = reader.number<std::uint64_t>();
  attachment.create_time_ns = reader.number<std::uint64_t>();
  attachment.name = reader.text();
  attachment.media_type = reader.text();
  const auto data = reader.bytes(reader.number<std::uint64_t>());
  attachment.data.assign(data.begin(), data.end());
  const auto checked = content.first(content.size() - reader.rest().size());
  const std::uint32_t crc = reader.number<std::uint32_t>();
  if (crc != 0 && crc != crc32_of(checked)) {
    throw RecordError("the checksum of attachment '" + printable_name(attachment.name) +
                      "' differs");
  }
  return attachment;
}

Metadata decode_metadata(std::span<const std::uint8_t> content) {
  RecordReader reader(content);
  Metadata metadata;
  metadata.name = reader.text();
  metadata.entries = reader.text_map();
  return metadata;
}

std::uint32_t decode_data_end(std::span<const std::uint8_t> content) {
  return RecordReader(content).number<std::uint32_t>();
}

}  // namespace echomap::mcap
