// SPDX-License-Identifier: MIT
#include "host/ros_messages/cdr_writer.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/ros_messages/serialization.hpp"
#include "tests/support/all_ros_messages.hpp"

namespace echomap::ros_messages {
namespace {

using testing::ElementsAreArray;
using Bytes = std::vector<std::uint8_t>;

/// The bytes of fields behind a header, whose alignment begins there.
template <class... Fields>
Bytes body_of(const Fields&... fields) {
  Bytes bytes;
  CdrWriter writer(bytes);
  (writer("field", fields), ...);
  EXPECT_THAT(Bytes(bytes.begin(), bytes.begin() + 4), ElementsAreArray({0, 1, 0, 0}));
  return {bytes.begin() + 4, bytes.end()};
}

TEST(CdrWriter, WritesNumbersFromTheLeastSignificantByteOn) {
  EXPECT_EQ(body_of(std::uint16_t{0x1234}), (Bytes{0x34, 0x12}));
  EXPECT_EQ(body_of(std::int32_t{-2}), (Bytes{0xFE, 0xFF, 0xFF, 0xFF}));
  EXPECT_EQ(body_of(std::uint64_t{0x0102030405060708}), (Bytes{8, 7, 6, 5, 4, 3, 2, 1}));
  EXPECT_EQ(body_of(1.0F), (Bytes{0, 0, 0x80, 0x3F}));
  EXPECT_EQ(body_of(-2.0), (Bytes{0, 0, 0, 0, 0, 0, 0, 0xC0}));
  EXPECT_EQ(body_of(true, false, 'a', std::byte{7}), (Bytes{1, 0, 'a', 7}));
}

TEST(CdrWriter, AlignsANumberToItsOwnSizeFromTheEndOfTheHeader) {
  const std::uint8_t byte = 9;
  EXPECT_EQ(body_of(byte, std::int16_t{1}), (Bytes{9, 0, 1, 0}));
  EXPECT_EQ(body_of(byte, std::int32_t{1}), (Bytes{9, 0, 0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(body_of(byte, std::int64_t{1}),
            (Bytes{9, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(body_of(std::int32_t{1}, byte, byte, std::int16_t{2}), (Bytes{1, 0, 0, 0, 9, 9, 2, 0}));
}

TEST(CdrWriter, CountsTheZeroOfAText) {
  EXPECT_EQ(body_of(std::string()), (Bytes{1, 0, 0, 0, 0}));
  EXPECT_EQ(body_of(std::string("abc"), std::uint16_t{1}),
            (Bytes{4, 0, 0, 0, 'a', 'b', 'c', 0, 1, 0}));
}

TEST(CdrWriter, AlignsTheElementsOfASequenceAndNotAnEmptyOne) {
  EXPECT_EQ(body_of(std::vector<std::int8_t>{-1, 2}), (Bytes{2, 0, 0, 0, 0xFF, 2}));
  EXPECT_EQ(body_of(std::vector<std::int64_t>{1}),
            (Bytes{1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(body_of(std::vector<double>{}, std::vector<double>{}), Bytes(8, 0));
}

TEST(CdrWriter, WritesNoCountOfAnArrayOfFixedSize) {
  EXPECT_EQ(body_of(std::array<std::uint16_t, 2>{1, 2}), (Bytes{1, 0, 2, 0}));
}

TEST(CdrWriter, WritesTextsOfASequenceEachAtAMultipleOfFour) {
  EXPECT_EQ(body_of(std::vector<std::string>{"a", "bc"}),
            (Bytes{2, 0, 0, 0, 2, 0, 0, 0, 'a', 0, 0, 0, 3, 0, 0, 0, 'b', 'c', 0}));
}

TEST(CdrWriter, WritesARangeAsRosDoes) {
  Range range;
  range.header.stamp = {1, 2};
  range.header.frame_id = "sonar";
  range.radiation_type = Range::kInfrared;
  range.field_of_view = 0.5F;
  range.min_range = 1.0F;
  range.max_range = 2.0F;
  range.range = 1.5F;
  // clang-format off
  const Bytes expected{0, 1, 0, 0,
                       1, 0, 0, 0,  2, 0, 0, 0,
                       6, 0, 0, 0,  's', 'o', 'n', 'a', 'r', 0,
                       1, 0,
                       0, 0, 0x00, 0x3F,  0, 0, 0x80, 0x3F,  0, 0, 0, 0x40,  0, 0, 0xC0, 0x3F};
  // clang-format on
  EXPECT_EQ(serialize(range), expected);
}

TEST(CdrWriter, WritesATransformAsRosDoes) {
  TFMessage message;
  message.transforms.resize(1);
  message.transforms[0].header.frame_id = "odom";
  message.transforms[0].child_frame_id = "base";
  message.transforms[0].transform.translation.x = 1.0;
  Bytes expected{0, 1, 0, 0,                                     // Header.
                 1, 0, 0, 0, 0,   0,   0,   0,   0, 0, 0,    0,  // Count, stamp.
                 5, 0, 0, 0, 'o', 'd', 'o', 'm', 0, 0, 0,    0,  // Text, padding.
                 5, 0, 0, 0, 'b', 'a', 's', 'e', 0, 0, 0,    0,
                 0, 0, 0, 0, 0,   0,   0,   0,   0, 0, 0xF0, 0x3F};
  expected.resize(expected.size() + 5 * 8);
  expected.insert(expected.end(), {0, 0, 0, 0, 0, 0, 0xF0, 0x3F});
  EXPECT_EQ(serialize(message), expected);
}

TEST(CdrWriter, EmptiesTheVectorAndKeepsItsMemory) {
  Bytes bytes(1000, 1);
  const std::uint8_t* memory = bytes.data();
  serialize(Time{1, 2}, bytes);
  EXPECT_EQ(bytes, (Bytes{0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}));
  EXPECT_EQ(bytes.data(), memory);
}

}  // namespace
}  // namespace echomap::ros_messages
