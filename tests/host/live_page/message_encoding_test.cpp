// SPDX-License-Identifier: MIT
#include "host/live_page/message_encoding.hpp"

#include <cmath>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/host/live_page/read_messages.hpp"

namespace echomap::live_page {
namespace {

// Offsets as docs/live_protocol.md has them, from the beginning of the body.

TEST(MessageEncoding, BeginsWithItsKindSevenZerosAndTheTimeOfTheRun) {
  const SharedMessage message = new_map_message(12.5);
  EXPECT_EQ(message->bytes, std::string("\x09\0\0\0\0\0\0\0\0\0\0\0\0\0\x29\x40", 16));
  EXPECT_EQ(message->kind, MessageKind::kNewMap);
  EXPECT_EQ(message->time_s, 12.5);
}

TEST(MessageEncoding, OfEachKindHasItsNumber) {
  EXPECT_EQ(byte_at(json_message(MessageKind::kHello, 0.0, {})->bytes, 0), 1U);
  EXPECT_EQ(byte_at(tile_message(0.0, {0, 0}, {})->bytes, 0), 2U);
  EXPECT_EQ(byte_at(motion_message(0.0, {})->bytes, 0), 3U);
  EXPECT_EQ(byte_at(particles_message(0.0, {})->bytes, 0), 4U);
  EXPECT_EQ(byte_at(trail_message(0.0, {})->bytes, 0), 5U);
  EXPECT_EQ(byte_at(json_message(MessageKind::kRoom, 0.0, {})->bytes, 0), 6U);
  EXPECT_EQ(byte_at(json_message(MessageKind::kState, 0.0, {})->bytes, 0), 7U);
  EXPECT_EQ(byte_at(json_message(MessageKind::kEvent, 0.0, {})->bytes, 0), 8U);
}

TEST(MessageEncoding, OfATileIsItsPlaceAndItsBytesRowByRow) {
  mapping::GridTile cells;
  cells.row(0)[1] = 130;
  cells.row(2)[3] = 90;
  const std::string body = body_of(*tile_message(1.0, {-2, 5}, cells));
  ASSERT_EQ(body.size(), 8U + 64U * 64U);
  EXPECT_EQ(i32_at(body, 0), -2);
  EXPECT_EQ(i32_at(body, 4), 5);
  EXPECT_EQ(byte_at(body, 8 + 0), 0U);
  EXPECT_EQ(byte_at(body, 8 + 1), 130U);
  EXPECT_EQ(byte_at(body, 8 + 2 * 64 + 3), 90U);
}

TEST(MessageEncoding, OfATileReplacesThatOfTheSameTileAlone) {
  std::set<std::uint64_t> keys;
  for (const geometry::CellIndex tile :
       {geometry::CellIndex{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {-1, -1}, {1, -1}}) {
    keys.insert(tile_message(0.0, tile, {})->key);
    EXPECT_EQ(tile_message(0.0, tile, {})->key, tile_message(1.0, tile, {})->key);
  }
  EXPECT_EQ(keys.size(), 7U);
}

MotionView whole_motion() {
  MotionView motion;
  motion.clock_ms = 1234.5;
  motion.T_map_robot = geometry::Pose2(1.0, 2.0, 0.5);
  motion.covariance = Eigen::Matrix3d{{0.25, 0.125, 0.0}, {0.125, 0.5, 0.0}, {0.0, 0.0, 4.0}};
  motion.T_odom_robot = geometry::Pose2(3.0, 4.0, -0.5);
  motion.T_map_true_robot = geometry::Pose2(5.0, 6.0, 0.75);
  motion.ping = {-1.5, 2.5, 7, PingResult::kEcho};
  return motion;
}

TEST(MessageEncoding, OfAMotionHasEveryNumberInItsPlace) {
  const std::string body = body_of(*motion_message(1.0, whole_motion()));
  ASSERT_EQ(body.size(), 76U);
  EXPECT_EQ(f64_at(body, 0), 1234.5) << "clock";
  EXPECT_EQ(f32_at(body, 8), 1.0F) << "estimated x";
  EXPECT_EQ(f32_at(body, 12), 2.0F) << "estimated y";
  EXPECT_EQ(f32_at(body, 16), 0.5F) << "estimated heading";
  EXPECT_EQ(f32_at(body, 20), 0.25F) << "xx";
  EXPECT_EQ(f32_at(body, 24), 0.125F) << "xy";
  EXPECT_EQ(f32_at(body, 28), 0.5F) << "yy";
  EXPECT_EQ(f32_at(body, 32), 2.0F) << "standard deviation of the heading";
  EXPECT_EQ(f32_at(body, 36), 3.0F) << "wheels' x";
  EXPECT_EQ(f32_at(body, 40), 4.0F) << "wheels' y";
  EXPECT_EQ(f32_at(body, 44), -0.5F) << "wheels' heading";
  EXPECT_EQ(f32_at(body, 48), 5.0F) << "true x";
  EXPECT_EQ(f32_at(body, 52), 6.0F) << "true y";
  EXPECT_EQ(f32_at(body, 56), 0.75F) << "true heading";
  EXPECT_EQ(f32_at(body, 60), -1.5F) << "bearing of the ping";
  EXPECT_EQ(f32_at(body, 64), 2.5F) << "range of the ping";
  EXPECT_EQ(u32_at(body, 68), 7U) << "number of the ping";
  EXPECT_EQ(u32_at(body, 72), 1U) << "an echo";
}

TEST(MessageEncoding, OfAMotionHasNoNumberWhereNothingIsKnown) {
  MotionView motion = whole_motion();
  motion.covariance.reset();
  motion.T_map_true_robot.reset();
  motion.ping = {};
  const std::string body = body_of(*motion_message(1.0, motion));
  ASSERT_EQ(body.size(), 76U);
  for (const std::size_t offset : {20U, 24U, 28U, 32U, 48U, 52U, 56U, 64U}) {
    EXPECT_TRUE(std::isnan(f32_at(body, offset))) << offset;
  }
  EXPECT_EQ(f32_at(body, 36), 3.0F);
  EXPECT_EQ(u32_at(body, 68), 0U) << "before the first ping";
  EXPECT_EQ(u32_at(body, 72), 0U);
}

TEST(MessageEncoding, OfAMotionTellsSilenceFromNoAnswer) {
  MotionView motion;
  motion.ping.result = PingResult::kSilence;
  EXPECT_EQ(u32_at(body_of(*motion_message(1.0, motion)), 72), 2U);
  motion.ping.result = PingResult::kNoAnswer;
  EXPECT_EQ(u32_at(body_of(*motion_message(1.0, motion)), 72), 3U);
}

TEST(MessageEncoding, OfParticlesIsTheirNumberAndFourNumbersOfEach) {
  const std::string body =
      body_of(*particles_message(1.0, {{{1.0, 2.0, 0.5}, 0.25}, {{3.0, 4.0, -0.5}, 0.75}}));
  ASSERT_EQ(body.size(), 8U + 2U * 16U);
  EXPECT_EQ(u32_at(body, 0), 2U);
  EXPECT_EQ(u32_at(body, 4), 0U);
  EXPECT_EQ(f32_at(body, 8), 1.0F);
  EXPECT_EQ(f32_at(body, 12), 2.0F);
  EXPECT_EQ(f32_at(body, 16), 0.5F);
  EXPECT_EQ(f32_at(body, 20), 0.25F);
  EXPECT_EQ(f32_at(body, 24), 3.0F);
  EXPECT_EQ(f32_at(body, 36), 0.75F);
}

TEST(MessageEncoding, OfATrailIsItsPlaces) {
  const std::string body = body_of(*trail_message(1.0, {{1.0, 2.0}, {-3.0, 4.0}}));
  ASSERT_EQ(body.size(), 8U + 2U * 8U);
  EXPECT_EQ(u32_at(body, 0), 2U);
  EXPECT_EQ(u32_at(body, 4), 0U);
  EXPECT_EQ(f32_at(body, 8), 1.0F);
  EXPECT_EQ(f32_at(body, 12), 2.0F);
  EXPECT_EQ(f32_at(body, 16), -3.0F);
  EXPECT_EQ(f32_at(body, 20), 4.0F);
}

TEST(MessageEncoding, OfJsonIsItsTextInTheOrderOfItsEntries) {
  const SharedMessage message =
      json_message(MessageKind::kEvent, 2.0, {{"text", "Türe"}, {"code", 3}, {"at", nullptr}});
  EXPECT_EQ(body_of(*message), R"({"text":"Türe","code":3,"at":null})");
  EXPECT_EQ(f64_at(message->bytes, 8), 2.0);
}

TEST(MessageEncoding, OfJsonIsReadableWhateverItSays) {
  const SharedMessage message =
      json_message(MessageKind::kEvent, 0.0, {{"text", "a\xff\xfe file"}, {"left", std::nan("")}});
  EXPECT_EQ(json_in(*message).at("text"), "a\uFFFD\uFFFD file");
  EXPECT_TRUE(json_in(*message).at("left").is_null()) << "JSON has no such number";
}

}  // namespace
}  // namespace echomap::live_page
