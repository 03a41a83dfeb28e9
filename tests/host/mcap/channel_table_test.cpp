// SPDX-License-Identifier: MIT
#include "host/mcap/channel_table.hpp"

#include <span>

#include <gtest/gtest.h>

#include "host/mcap/record_encoding.hpp"
#include "host/mcap/record_reader.hpp"
#include "tests/host/mcap/small_file.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::mcap {
namespace {

/// Takes one record, its head included.
std::optional<Message> take_whole(ChannelTable& table, const Bytes& record) {
  return table.take(static_cast<Opcode>(record[0]), std::span(record).subspan(kRecordHeadBytes));
}

Bytes schema_record(std::uint16_t id, const Schema& schema) {
  Bytes record;
  append_schema(record, id, schema);
  return record;
}

Bytes channel_record(std::uint16_t id, const ChannelInfo& info) {
  Bytes record;
  append_channel(record, id, info);
  return record;
}

TEST(ChannelTable, GivesAMessageItsChannelAndSchema) {
  ChannelTable table;
  EXPECT_FALSE(take_whole(table, schema_record(2, {"Pose", "ros2msg", "float64 x"})));
  EXPECT_FALSE(take_whole(table, channel_record(5, {"/pose", 2, "cdr", {}})));
  Bytes record;
  const Bytes payload = bytes_of("payload");
  append_message(record, {5, 1, 2, 3, payload});
  const auto message = take_whole(table, record);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->channel->id, 5U);
  EXPECT_EQ(message->channel->info.topic, "/pose");
  EXPECT_EQ(message->channel->schema->name, "Pose");
  EXPECT_EQ(message->sequence, 1U);
  EXPECT_EQ(message->log_time_ns, 2U);
  EXPECT_EQ(message->publish_time_ns, 3U);
  EXPECT_EQ(message->data, payload);
}

TEST(ChannelTable, AllowsAChannelWithoutSchema) {
  ChannelTable table;
  take_whole(table, channel_record(0, {"/log", 0, "text", {}}));
  Bytes record;
  append_message(record, {0, 0, 0, 0, {}});
  const auto message = take_whole(table, record);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->channel->schema, nullptr);
}

TEST(ChannelTable, RefusesWhatIsNotDefined) {
  ChannelTable table;
  const auto error_of = [&](const Bytes& record) {
    return tests::thrown_text<RecordError>([&] { take_whole(table, record); });
  };
  EXPECT_EQ(error_of(channel_record(1, {"/log", 9, "", {}})), "channel 1 has the unknown schema 9");
  Bytes record;
  append_message(record, {1, 0, 0, 0, {}});
  EXPECT_EQ(error_of(record), "a message of the unknown channel 1");
}

TEST(ChannelTable, RefusesAnotherDefinitionOfTheSame) {
  ChannelTable table;
  for (int i = 0; i < 2; ++i) {
    take_whole(table, schema_record(1, {"Pose", "ros2msg", "float64 x"}));
    take_whole(table, channel_record(1, {"/pose", 1, "cdr", {}}));
  }
  EXPECT_THROW(take_whole(table, schema_record(1, {"Pose", "ros2msg", "float64 y"})), RecordError);
  EXPECT_THROW(take_whole(table, channel_record(1, {"/pose", 1, "json", {}})), RecordError);
}

}  // namespace
}  // namespace echomap::mcap
