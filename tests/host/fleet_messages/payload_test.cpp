// SPDX-License-Identifier: MIT
#include "host/fleet_messages/payload.hpp"

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "host/fleet_messages/body_packing.hpp"
#include "tests/support/random_fleet_message.hpp"

namespace echomap::fleet_messages {
namespace {

using tests::random_fleet_message;

constexpr std::size_t kKinds = std::variant_size_v<MessageBody>;

template <class Decoded>
std::string outcome(const Decoded& decoded) {
  const auto* reason = std::get_if<RefusedReason>(&decoded);
  return reason == nullptr ? "accepted" : std::string(name_of(*reason));
}

/// Any bytes before the check, with the right check behind them.
std::string with_check(const std::string& bytes) {
  const ContentHash hash = content_hash(bytes);
  return bytes + std::string(hash.bytes.begin(), hash.bytes.begin() + 4);
}

FleetMessage a_claim() {
  return {{"r1", 7, 42}, ClaimMessage{3, {{1200, -300, 45000, 2100}}, {{"r2"}}}};
}

TEST(FleetPayload, OfEveryKindIsReadBack) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      const FleetMessage message = random_fleet_message(random, kind);
      const auto payload = encode(message);
      ASSERT_TRUE(payload) << name_of(kind_of(message.body));
      const auto decoded = decode(*payload);
      ASSERT_EQ(outcome(decoded), "accepted") << name_of(kind_of(message.body));
      EXPECT_EQ(std::get<FleetMessage>(decoded), message) << name_of(kind_of(message.body));
    }
  }
}

// A grid is made of what a robot tells, and a mapper of what it is like.
TEST(FleetPayload, HasNothingThatNoRobotIsOrReaches) {
  PresenceMessage presence;
  presence.beam_half_angle = 0;
  EXPECT_FALSE(encode({{"r1", 7, 42}, presence}));
  presence.beam_half_angle = 8193;
  EXPECT_FALSE(encode({{"r1", 7, 42}, presence}));
  SubmapMessage submap;
  submap.readings.resize(2);
  submap.readings[0].T_odom_robot.x_mm = INT32_MIN;
  submap.readings[1].T_odom_robot.x_mm = INT32_MAX;
  EXPECT_FALSE(encode({{"r1", 0, 0}, submap})) << "more than an int32 apart";
  submap.readings[1].T_odom_robot.x_mm = INT32_MIN + 30'000;
  EXPECT_TRUE(encode({{"r1", 0, 0}, submap}));
  submap.contacts = {{{INT32_MIN, 30'001, 0}, 1}};
  EXPECT_FALSE(encode({{"r1", 0, 0}, submap}));
  EXPECT_TRUE(encode({{"r1", 7, 42}, GraphMessage{0, {}, {{100'000, 0, 0}}}}));
  EXPECT_FALSE(encode({{"r1", 7, 42}, GraphMessage{0, {}, {{0, -100'001, 0}}}}));
  EXPECT_TRUE(encode({{"r1", 7, 42}, AlignmentMessage{{{"r2", 0, {200'000, 0, 0}, {}}}}}));
  EXPECT_FALSE(encode({{"r1", 7, 42}, AlignmentMessage{{{"r2", 0, {200'001, 0, 0}, {}}}}}));
  EXPECT_FALSE(encode({{"r1", 7, 42}, AlignmentMessage{{{"r2", 0, {}, {{0, -200'001, 0}}}}}}));
}

TEST(FleetPayload, IsWrittenAsTheDocumentSays) {
  const std::string expected(
      "\x01\x06\x00"      // version, claim, not packed
      "\x02r1"            // robot
      "\x07\x00\x00\x00"  // boot id
      "\x2A\x00\x00\x00"  // counter
      "\x03\x00"          // map number
      "\x01\x00"          // one claim
      "\xE0\x12"          // x 1200 mm
      "\xD7\x04"          // y -300 mm
      "\x90\xBF\x05"      // 45000 mm2/s
      "\xE8\x20"          // reach 2100 mm
      "\x01\x00"          // it waits for one robot
      "\x02r2",
      32);
  EXPECT_EQ(encode(a_claim()), with_check(expected));
}

TEST(FleetPayload, RefusesEveryPartOfAMessage) {
  std::mt19937 random(2);
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const std::string payload = encode(random_fleet_message(random, kind)).value();
    for (std::size_t size = 0; size < payload.size(); ++size) {
      EXPECT_NE(outcome(decode(payload.substr(0, size))), "accepted") << kind << ", " << size;
    }
  }
}

TEST(FleetPayload, RefusesEverySingleBitError) {
  std::mt19937 random(3);
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const std::string payload = encode(random_fleet_message(random, kind)).value();
    for (std::size_t bit = 0; bit < 8 * payload.size(); ++bit) {
      std::string damaged = payload;
      damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
      EXPECT_NE(outcome(decode(damaged)), "accepted") << kind << ", bit " << bit;
    }
  }
}

TEST(FleetPayload, WithAForgedCheckIsRefusedOrMeansWhatItIsWrittenAs) {
  std::mt19937 random(4);
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string bytes = encode(random_fleet_message(random, round % kKinds)).value();
    bytes.resize(bytes.size() - 4);
    for (auto faults = 1 + random() % 3; faults > 0; --faults) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    const auto decoded = decode(with_check(bytes));
    if (const auto* message = std::get_if<FleetMessage>(&decoded)) {
      ++accepted;
      const auto again = encode(*message);
      ASSERT_TRUE(again);
      EXPECT_EQ(std::get<FleetMessage>(decode(*again)), *message);
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_LT(accepted, 19000);
}

TEST(FleetPayload, SaysWhyItIsRefused) {
  const std::string payload = encode(a_claim()).value();
  const std::string bytes = payload.substr(0, payload.size() - 4);
  const auto with_byte = [&](std::size_t at, char value) {
    std::string changed = bytes;
    changed[at] = value;
    return outcome(decode(with_check(changed)));
  };
  EXPECT_EQ(outcome(decode("")), "too_short");
  EXPECT_EQ(outcome(decode(std::string(kMaxPayloadBytes + 1, '\x01'))), "too_large");
  EXPECT_EQ(with_byte(0, '\x02'), "unknown_version");
  EXPECT_EQ(with_byte(1, '\x00'), "unknown_kind");
  EXPECT_EQ(with_byte(1, '\x0C'), "unknown_kind");
  EXPECT_EQ(with_byte(2, '\x01'), "cannot_decompress");
  EXPECT_EQ(with_byte(2, '\x02'), "out_of_range") << "no such packing";
  EXPECT_EQ(with_byte(4, '/'), "out_of_range") << "no robot's name";
  EXPECT_EQ(outcome(decode(with_check(bytes + "x"))), "trailing_bytes");
  EXPECT_EQ(outcome(decode(with_check(bytes.substr(0, bytes.size() - 1)))), "cut_short");
  std::string damaged = payload;
  damaged.back() ^= 1;
  EXPECT_EQ(outcome(decode(damaged)), "damaged");
}

TEST(FleetPayload, RefusesABombOfZeros) {
  const std::string header("\x01\x06\x01\x02r1\x07\x00\x00\x00\x2A\x00\x00\x00", 14);
  const std::string bomb = with_check(header + pack(std::string(10'000'000, '\0')));
  ASSERT_LT(bomb.size(), 2000U);
  EXPECT_EQ(outcome(decode(bomb)), "cannot_decompress");
}

TEST(FleetPayload, IsNotWrittenWhereItWouldBeRefused) {
  FleetMessage claim = a_claim();
  claim.sender.robot = "R1";
  EXPECT_FALSE(encode(claim)) << "not a name";
  EXPECT_FALSE(encode({{"r1", 0, 0}, SubmapMessage{}})) << "no readings";
  SubmapMessage backwards{0, 0, 2000, 1000, {ReadingRow{}}, {}, {}};
  EXPECT_FALSE(encode({{"r1", 0, 0}, backwards})) << "it ends before it begins";
  std::mt19937 random(5);
  GraphMessage graph;
  for (int i = 0; i < 8192; ++i) {
    graph.T_map_submaps.push_back({static_cast<std::int32_t>(random()),
                                   static_cast<std::int32_t>(random()),
                                   static_cast<std::uint16_t>(random())});
  }
  EXPECT_FALSE(encode({{"r1", 0, 0}, graph})) << "100 kB";
  EXPECT_FALSE(encode({{"r1", 0, 0}, ManifestMessage{0, std::vector<ContentHash>(33)}}));
}

TEST(FleetPayload, BelongsOnItsTopic) {
  std::mt19937 random(6);
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const FleetMessage message = random_fleet_message(random, kind);
    const std::string payload = encode(message).value();
    const FleetTopic topic = topic_of("hall", message, payload);
    const auto decoded = decode(format_topic(topic), payload);
    ASSERT_EQ(outcome(decoded), "accepted") << format_topic(topic);
    EXPECT_EQ(std::get<TopicMessage>(decoded).topic, topic);
    EXPECT_EQ(std::get<TopicMessage>(decoded).message, message);
  }
}

TEST(FleetPayload, IsRefusedOnAnotherTopic) {
  const std::string claim = encode(a_claim()).value();
  EXPECT_EQ(outcome(decode("echomap/1/hall/r1/claim", claim)), "accepted");
  EXPECT_EQ(outcome(decode("echomap/1/hall/r2/claim", claim)), "foreign_author");
  EXPECT_EQ(outcome(decode("echomap/1/hall/r1/pose", claim)), "wrong_topic");
  EXPECT_EQ(outcome(decode("echomap/1/hall/r1/claim/1", claim)), "wrong_topic");
  const std::string page = encode({{"r1", 7, 43}, ManifestMessage{3, {}}}).value();
  EXPECT_EQ(outcome(decode("echomap/1/hall/r1/manifest/3", page)), "accepted");
  EXPECT_EQ(outcome(decode("echomap/1/hall/r1/manifest/4", page)), "wrong_topic");
}

TEST(FleetPayload, OfAnObjectHasItsNamesBytes) {
  std::mt19937 random(7);
  FleetMessage submap = random_fleet_message(random, 2);
  submap.sender.robot = "r1";
  const std::string payload = encode(submap).value();
  const std::string folder = "echomap/1/hall/r1/submap/";
  EXPECT_EQ(outcome(decode(folder + hex(content_hash(payload)), payload)), "accepted");
  EXPECT_EQ(outcome(decode(folder + hex(content_hash("another")), payload)), "wrong_hash");
}

TEST(FleetPayload, OfAnotherRobotIsAcceptedFromARelay) {
  const std::string claim = encode(a_claim()).value();
  const std::string folder = "echomap/1/hall/r2/relay/";
  EXPECT_EQ(outcome(decode(folder + hex(content_hash(claim)), claim)), "accepted");
  EXPECT_EQ(outcome(decode(folder + hex(content_hash("another")), claim)), "wrong_hash");
}

}  // namespace
}  // namespace echomap::fleet_messages
