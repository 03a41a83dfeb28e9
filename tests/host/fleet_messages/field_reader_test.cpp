// SPDX-License-Identifier: MIT
#include "host/fleet_messages/field_reader.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "host/fleet_messages/table_rows.hpp"

namespace echomap::fleet_messages {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

/// Why the bytes are no field of type T and nothing else.
template <class T>
std::optional<RefusedReason> refused(const std::string& bytes) {
  FieldReader reader(bytes);
  T value{};
  reader("value", value);
  return reader.finish();
}

TEST(FieldReader, ReadsNumbersLittleEndian) {
  FieldReader reader("\x34\x12\xFE\xFF\xFF\xFF"sv);
  std::uint16_t first = 0;
  std::int32_t second = 0;
  reader("first", first);
  reader("second", second);
  EXPECT_EQ(reader.finish(), std::nullopt);
  EXPECT_EQ(first, 0x1234);
  EXPECT_EQ(second, -2);
}

TEST(FieldReader, RefusesBytesThatAreMissingOrTooMany) {
  EXPECT_EQ(refused<std::uint32_t>("\x01\x02\x03"s), RefusedReason::kCutShort);
  EXPECT_EQ(refused<std::uint16_t>("\x01\x02\x03"s), RefusedReason::kTrailingBytes);
  EXPECT_EQ(refused<ContentHash>(std::string(15, 'x')), RefusedReason::kCutShort);
}

TEST(FieldReader, RefusesNumbersAboveTheLimit) {
  FieldReader reader("\x03"sv);
  std::uint8_t state = 0;
  reader("state", state, 2);
  EXPECT_EQ(reader.finish(), RefusedReason::kOutOfRange);
}

TEST(FieldReader, RefusesNamesThatNoRobotHas) {
  EXPECT_EQ(refused<std::string>("\x02r1"s), std::nullopt);
  EXPECT_EQ(refused<std::string>("\x02R1"s), RefusedReason::kOutOfRange);
  EXPECT_EQ(refused<std::string>("\x00"s), RefusedReason::kOutOfRange);
  EXPECT_EQ(refused<std::string>("\x03r1"s), RefusedReason::kCutShort);
  EXPECT_EQ(refused<std::string>("\x21"s + std::string(33, 'r')), RefusedReason::kOutOfRange);
}

TEST(FieldReader, RefusesCountsThatTheBytesCannotFill) {
  EXPECT_EQ(refused<std::vector<PoseRow>>("\x02\x00\x00\x00\x00\x00\x00"s),
            RefusedReason::kCutShort);
  EXPECT_EQ(refused<std::vector<ContentHash>>("\xFF\x1F"s), RefusedReason::kCutShort);
  EXPECT_EQ(refused<std::vector<PoseRow>>("\x01\x20"s + std::string(30000, '\0')),
            RefusedReason::kMalformed)
      << "8193 rows";
}

TEST(FieldReader, RefusesDifferencesThatAreNotTheShortestOrTooLarge) {
  const auto pose_with_x = [](const std::string& x) { return "\x01\x00"s + x + "\x00\x00"s; };
  EXPECT_EQ(refused<std::vector<PoseRow>>(pose_with_x("\x80\x01"s)), std::nullopt);
  EXPECT_EQ(refused<std::vector<PoseRow>>(pose_with_x("\x80\x00"s)), RefusedReason::kMalformed);
  EXPECT_EQ(refused<std::vector<PoseRow>>(pose_with_x("\xFF\xFF\xFF\xFF\x0F"s)), std::nullopt);
  EXPECT_EQ(refused<std::vector<PoseRow>>(pose_with_x("\xFF\xFF\xFF\xFF\x1F"s)),
            RefusedReason::kMalformed)
      << "more than 32 bits";
  EXPECT_EQ(refused<std::vector<PoseRow>>(pose_with_x("\x80\x80\x80\x80\x80\x01"s)),
            RefusedReason::kMalformed);
  EXPECT_EQ(refused<std::vector<PoseRow>>("\x01\x00\x00\x00\x80\x80\x04"s),
            RefusedReason::kMalformed)
      << "a heading of more than 16 bits";
}

TEST(FieldReader, RefusesRowsAboveTheLimit) {
  EXPECT_EQ(refused<std::vector<ContactRow>>("\x01\x00\x00\x00\x00\x06"s), std::nullopt);
  EXPECT_EQ(refused<std::vector<ContactRow>>("\x01\x00\x00\x00\x00\x08"s),
            RefusedReason::kOutOfRange);
}

TEST(FieldReader, KeepsTheFirstRefusal) {
  FieldReader reader("\x02R1\x05"sv);
  std::string name;
  std::uint32_t number = 7;
  reader("name", name);
  reader("number", number);
  EXPECT_EQ(reader.finish(), RefusedReason::kOutOfRange);
}

}  // namespace
}  // namespace echomap::fleet_messages
