// SPDX-License-Identifier: MIT
#include "host/mcap/record_encoding.hpp"

#include "host/mcap/record_writer.hpp"

namespace echomap::mcap {

void append_header(Bytes& out, const HeaderInfo& header) {
  RecordWriter record(out, Opcode::kHeader);
  record.text(header.profile);
  record.text(header.library);
}

void append_schema(Bytes& out, std::uint16_t id, const Schema& schema) {
  RecordWriter record(out, Opcode::kSchema);
  record.number(id);
  record.text(schema.name);
  record.text(schema.encoding);
  record.text(schema.data);
}

void append_channel(Bytes& out, std::uint16_t id, const ChannelInfo& channel) {
  RecordWriter record(out, Opcode::kChannel);
  record.number(id);
  record.number(channel.schema_id);
  record.text(channel.topic);
  record.text(channel.message_encoding);
  record.text_map(channel.metadata);
}

void append_message(Bytes& out, const MessageFields& message) {
  RecordWriter record(out, Opcode::kMessage);
  record.number(message.channel_id);
  record.number(message.sequence);
  record.number(message.log_time_ns);
  record.number(message.publish_time_ns);
  record.bytes(message.data);
}

void append_attachment(Bytes& out, const Attachment& attachment) {
  RecordWriter record(out, Opcode::kAttachment);
  record.number(attachment.log_time_ns);
  record.number(attachment.create_time_ns);
  record.text(attachment.name);
  record.text(attachment.media_type);
  record.number(std::uint64_t{attachment.data.size()});
  record.bytes(attachment.data);
  record.number(record.crc());
}

void append_metadata(Bytes& out, const Metadata& metadata) {
  RecordWriter record(out, Opcode::kMetadata);
  record.text(metadata.name);
  record.text_map(metadata.entries);
}

void append_data_end(Bytes& out, std::uint32_t data_crc) {
  RecordWriter record(out, Opcode::kDataEnd);
  record.number(data_crc);
}

}  // namespace echomap::mcap
