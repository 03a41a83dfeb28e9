// SPDX-License-Identifier: MIT
#include "host/fleet_messages/field_writer.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/fleet_messages/table_rows.hpp"

namespace echomap::fleet_messages {
namespace {

template <class T>
std::string written(const T& value) {
  std::string bytes;
  FieldWriter writer(bytes);
  writer("value", value);
  return bytes;
}

TEST(FieldWriter, WritesNumbersLittleEndian) {
  EXPECT_EQ(written(std::uint16_t{0x1234}), "\x34\x12");
  EXPECT_EQ(written(std::int32_t{-2}), "\xFE\xFF\xFF\xFF");
  EXPECT_EQ(written(std::uint64_t{0x0102030405060708}), "\x08\x07\x06\x05\x04\x03\x02\x01");
}

TEST(FieldWriter, WritesANameBehindItsLength) { EXPECT_EQ(written(std::string("r12")), "\x03r12"); }

TEST(FieldWriter, WritesATableByColumnsOfDifferences) {
  // Three poses: x 100, 101, 99 mm; y 0; heading 65535, 0, 1.
  const std::vector<PoseRow> poses{{100, 0, 65535}, {101, 0, 0}, {99, 0, 1}};
  const std::string expected(
      "\x03\x00"          // rows
      "\xC8\x01\x02\x03"  // +100 (zigzag 200 in base 128), +1, -2
      "\x00\x00\x00"      // y
      "\x01\x02\x02",     // headings wrap: -1, +1, +1
      12);
  EXPECT_EQ(written(poses), expected);
}

TEST(FieldWriter, WritesTheLargestDifferenceInFiveBytes) {
  const std::vector<PoseRow> poses{{INT32_MIN, 0, 0}};
  EXPECT_EQ(written(poses), std::string("\x01\x00\xFF\xFF\xFF\xFF\x0F\x00\x00", 9));
}

TEST(FieldWriter, SaysWhatAReaderWouldRefuse) {
  const auto fits = [](const auto& value) {
    std::string bytes;
    FieldWriter writer(bytes);
    writer("value", value);
    return writer.fits();
  };
  EXPECT_TRUE(fits(std::string("r1")));
  EXPECT_FALSE(fits(std::string("R1")));
  EXPECT_TRUE(fits(std::vector<PoseRow>(kMaxElements)));
  EXPECT_FALSE(fits(std::vector<PoseRow>(kMaxElements + 1)));
  EXPECT_FALSE(fits(std::vector<ContentHash>(kMaxElements + 1)));
  EXPECT_FALSE(fits(std::vector<AlignedMapPart>(kMaxElements + 1)));
  EXPECT_TRUE(fits(std::vector<ContactRow>{{{}, 3}}));
  EXPECT_FALSE(fits(std::vector<ContactRow>{{{}, 4}}));
  std::string bytes;
  FieldWriter writer(bytes);
  writer("state", std::uint8_t{3}, 2);
  EXPECT_FALSE(writer.fits());
}

}  // namespace
}  // namespace echomap::fleet_messages
