// SPDX-License-Identifier: MIT
#include "host/ros_messages/cdr_reader.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/ros_messages/serialization.hpp"
#include "tests/support/all_ros_messages.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::ros_messages {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using ReaderBytes = std::vector<std::uint8_t>;

template <Message M>
std::string refusal_of(const ReaderBytes& bytes) {
  return tests::thrown_text<CdrError>([&] { deserialize<M>(bytes); });
}

TEST(CdrReader, ReadsBothByteOrders) {
  const Time expected{1, 0x10203};
  EXPECT_EQ(deserialize<Time>(ReaderBytes{0, 1, 0, 0, 1, 0, 0, 0, 3, 2, 1, 0}), expected);
  EXPECT_EQ(deserialize<Time>(ReaderBytes{0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3}), expected);
}

TEST(CdrReader, ReadsTextsAndSequencesOfTheOtherByteOrder) {
  const ReaderBytes bytes{0, 0, 0, 0, 0, 0, 0, 3, 'a', 'b', 0, 0, 0, 0, 0, 2, 5, 6};
  EXPECT_EQ(deserialize<MeshFile>(bytes), (MeshFile{"ab", {5, 6}}));
}

TEST(CdrReader, IgnoresTheOptionsOfTheHeader) {
  EXPECT_EQ(deserialize<String>(ReaderBytes{0, 1, 7, 3, 1, 0, 0, 0, 0}), String{});
}

TEST(CdrReader, AcceptsWhatALaterVersionAppends) {
  Range range;
  range.range = 1.25F;
  ReaderBytes bytes = serialize(range);
  bytes.insert(bytes.end(), {1, 2, 3, 4});
  EXPECT_EQ(deserialize<Range>(bytes), range);
}

TEST(CdrReader, AcceptsAnEmptyTextWithoutItsZero) {
  EXPECT_EQ(deserialize<String>(ReaderBytes{0, 1, 0, 0, 0, 0, 0, 0}), String{});
}

TEST(CdrReader, KeepsZerosWithinAText) {
  const String text{std::string("a\0b", 3)};
  EXPECT_EQ(deserialize<String>(serialize(text)), text);
}

TEST(CdrReader, RefusesWhatIsNotPlainCdr) {
  EXPECT_THAT(refusal_of<Time>({0, 1, 0}), HasSubstr("the header has 3 of 4 bytes"));
  for (const std::uint8_t kind : ReaderBytes{2, 3, 6, 7, 255}) {
    EXPECT_THAT(refusal_of<Time>({0, kind, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}),
                HasSubstr("representation " + std::to_string(kind) + " is not plain CDR"));
  }
  EXPECT_THAT(refusal_of<Time>({1, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}), HasSubstr("257"));
}

TEST(CdrReader, NamesTypeAndFieldWhereTheMessageEnds) {
  EXPECT_THAT(
      refusal_of<Time>({0, 1, 0, 0, 1, 0, 0, 0, 2, 0}),
      AllOf(HasSubstr("builtin_interfaces/msg/Time, nanosec: "), HasSubstr("ends after 6 bytes")));
}

TEST(CdrReader, RefusesACountThatTheRestCannotHold) {
  EXPECT_THAT(refusal_of<MeshFile>({0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 1}),
              AllOf(HasSubstr("MeshFile, data: "),
                    HasSubstr("4294967295 elements cannot be in the 1 bytes that are left")));
  // A transform takes 72 bytes or more.
  ReaderBytes transforms{0, 1, 0, 0, 2, 0, 0, 0};
  transforms.resize(8 + 143);
  EXPECT_THAT(refusal_of<TFMessage>(transforms), HasSubstr("2 elements cannot be in the 143"));
}

TEST(CdrReader, RefusesATextWithoutAZero) {
  EXPECT_THAT(refusal_of<String>({0, 1, 0, 0, 2, 0, 0, 0, 'a', 'b'}),
              HasSubstr("std_msgs/msg/String, data: the text has no zero at its end"));
}

TEST(CdrReader, RefusesATruthValueOfTwo) {
  BatteryState state;
  state.present = true;
  ReaderBytes bytes = serialize(state);
  // Header of 4, stamp 8, empty frame 5, padding 3, seven floats, three bytes.
  const std::size_t at = 4 + 8 + 8 + 28 + 3;
  ASSERT_EQ(bytes[at], 1);
  bytes[at] = 2;
  EXPECT_THAT(refusal_of<BatteryState>(bytes), HasSubstr("present: 2 is not a truth value"));
}

TEST(CdrReader, KnowsTheFewestBytesOfAType) {
  EXPECT_EQ(min_cdr_size<Time>(), 8U);
  EXPECT_EQ(min_cdr_size<Header>(), 12U);
  EXPECT_EQ(min_cdr_size<TransformStamped>(), 72U);
  EXPECT_EQ(min_cdr_size<PoseWithCovariance>(), 56U + 36U * 8U);
  EXPECT_EQ(min_cdr_size<TFMessage>(), 4U);
}

}  // namespace
}  // namespace echomap::ros_messages
