// SPDX-License-Identifier: MIT
#include "protocol/schema_reader.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "protocol/messages.hpp"
#include "tests/protocol/described_schema.hpp"

namespace echomap::protocol {
namespace {

std::uint8_t last(char character) { return static_cast<std::uint8_t>(character | 0x80); }

/// A message "M" and then these bytes.
bool is_read(const Bytes& bytes) {
  Bytes whole{0x00, 1, last('M')};
  whole.insert(whole.end(), bytes.begin(), bytes.end());
  return read_description(whole).has_value();
}

TEST(SchemaReader, EndsAtOnceWhereThereIsNothing) {
  EXPECT_EQ(read_description({}), std::vector<DescribedMessage>{});
}

TEST(SchemaReader, RefusesWhatIsNoDescription) {
  EXPECT_TRUE(is_read({}));
  EXPECT_TRUE(is_read({0x01, last('a'), 0x80}));
  EXPECT_FALSE(read_description({0x01, last('a')})) << "a field of no message";
  EXPECT_FALSE(read_description({0x80})) << "a reference of no message";
  EXPECT_FALSE(is_read({0x80})) << "a reference to nothing";
  EXPECT_FALSE(is_read({0x01, last('a'), 0x81})) << "a reference to a later definition";
  EXPECT_FALSE(is_read({0x07, last('a')})) << "a type that is none";
  EXPECT_FALSE(is_read({1 << 3 | 1, last('a')})) << "shares more than there is";
  EXPECT_FALSE(is_read({2 << 3, 2, last('a')})) << "the same of a message";
  EXPECT_FALSE(is_read({0x01, 'a', 0x00, last('b')})) << "a zero in a name";
  EXPECT_FALSE(is_read({0x01, last('-')})) << "another character";
  EXPECT_FALSE(is_read({0x00})) << "no id";
}

TEST(SchemaReader, TakesNamesOf31CharactersAndNoLonger) {
  for (const std::size_t characters : {1U, 31U, 32U}) {
    Bytes field(1 + characters, 'a');
    field.front() = 0x01;
    field.back() = last('a');
    EXPECT_EQ(is_read(field), characters <= 31) << characters;
  }
}

TEST(SchemaReader, Takes128DefinitionsAndNoMore) {
  Bytes fields;
  for (int i = 0; i < 128; ++i) {
    fields.push_back(0x01);
    fields.push_back(last('a'));
  }
  fields.push_back(0xFF);
  EXPECT_TRUE(is_read(fields));
  fields.push_back(0x01);
  fields.push_back(last('a'));
  EXPECT_FALSE(is_read(fields));
}

TEST(SchemaReader, TakesNoMoreBytesThanAreAllowed) {
  constexpr std::size_t kMessage = 3;
  Bytes fields(SchemaFormat::kMaxBytes - kMessage, 0x80);
  fields[0] = 0x01;
  fields[1] = last('a');
  EXPECT_TRUE(is_read(fields));
  fields.push_back(0x80);
  EXPECT_FALSE(is_read(fields));
}

TEST(SchemaReader, StaysMalformed) {
  const Bytes bytes{0x01, last('a'), 0x00, 1, last('M')};
  SchemaReader reader(bytes.data(), static_cast<std::uint16_t>(bytes.size()));
  EXPECT_EQ(reader.next(), SchemaItem::kMalformed);
  EXPECT_EQ(reader.next(), SchemaItem::kMalformed);
}

TEST(SchemaReader, ReadsACutDescriptionUpToTheCutAndNoFurther) {
  const auto whole = read_description(description);
  ASSERT_TRUE(whole);
  for (std::size_t size = 0; size < description.size(); ++size) {
    // A block of its own: the address sanitizer sees a read beyond it.
    const Bytes cut(description.begin(), description.begin() + std::ptrdiff_t(size));
    const auto part = read_description(cut);
    if (part && !part->empty()) {
      ASSERT_LE(part->size(), whole->size());
      ASSERT_EQ(part->back().name, (*whole)[part->size() - 1].name);
    }
  }
}

TEST(SchemaReader, SurvivesDamage) {
  std::mt19937 generator(4711);
  int malformed = 0;
  for (int i = 0; i < 2000; ++i) {
    Bytes damaged = description;
    damaged[generator() % damaged.size()] = static_cast<std::uint8_t>(generator());
    malformed += read_description(damaged) ? 0 : 1;
  }
  EXPECT_GT(malformed, 500);
  EXPECT_LT(malformed, 2000);
}

}  // namespace
}  // namespace echomap::protocol
