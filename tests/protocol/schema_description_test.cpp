// SPDX-License-Identifier: MIT
#include "protocol/schema_description.hpp"

#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "protocol/messages.hpp"
#include "tests/protocol/described_schema.hpp"
#include "tests/support/message_description.hpp"

namespace echomap::protocol {
namespace {

/// The schema as the compiler knows it.
struct CollectMessages {
  std::vector<DescribedMessage> messages;
  template <class M>
  void operator()(const M* /*tag*/) {
    messages.push_back({M::kId, M::name(), {}});
    describe<M>(*this);
  }
  void operator()(const char* name, char type_code) {
    messages.back().fields.emplace_back(name, type_code);
  }
};

/// The digest that a host works out of what a robot describes.
std::uint32_t digest_of(const std::vector<DescribedMessage>& messages) {
  SchemaHash digest;
  for (const DescribedMessage& message : messages) {
    SchemaHash seed;
    seed.add_text(message.name.c_str());
    for (const auto& [name, type_code] : message.fields) {
      seed.add_text(name.c_str());
      seed.add(type_code);
    }
    digest.add(static_cast<char>(message.id));
    digest.add(static_cast<char>(seed.folded() & 0xFF));
    digest.add(static_cast<char>(seed.folded() >> 8));
  }
  return digest.value();
}

TEST(SchemaDescription, SaysWhatTheCompilerKnows) {
  CollectMessages collect;
  AllMessages::for_each(collect);
  const auto messages = read_description(description);
  ASSERT_TRUE(messages);
  EXPECT_EQ(*messages, collect.messages);
  EXPECT_EQ(digest_of(*messages), kSchemaDigest);
}

TEST(SchemaDescription, IsSmall) {
  std::printf("description of the schema: %zu bytes\n", description.size());
  EXPECT_LE(description.size(), 1248U);
}

struct First {
  enum : std::uint8_t { kId = 1 };
  static constexpr const char* name() { return "First"; }
  std::uint8_t a;
  std::uint16_t b;
  std::uint8_t c;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("pin_0", m.a);
    v("pin_1", m.b);
    v("pin_10", m.c);
  }
};

struct Firm {
  enum : std::uint8_t { kId = 2 };
  static constexpr const char* name() { return "Firm"; }
  std::uint16_t a;
  std::uint8_t b;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("pin_1", m.a);
    v("pin_1", m.b);
  }
};

TEST(SchemaDescription, SharesBeginningsAndRefersToDefinitions) {
  constexpr auto kTwo = describe_schema<MessageList<First, Firm>>();
  const auto last = [](char character) { return static_cast<std::uint8_t>(character | 0x80); };
  const Bytes expected{
      0x00,       1,         'F',       'i', 'r', 's',       last('t'),  // message 1, "First"
      0x01,       'p',       'i',       'n', '_', last('0'),             // u8 "pin_0"
      4 << 3 | 3, last('1'),             // u16, 4 characters of "pin_0"
      5 << 3 | 1, last('0'),             // u8, 5 characters of "pin_1"
      3 << 3,     2,         last('m'),  // message 2, 3 characters of "First"
      0x80 | 1,                          // the second definition
      4 << 3 | 1, last('1'),             // the same name of another type
  };
  EXPECT_EQ(Bytes(std::begin(kTwo.bytes), std::end(kTwo.bytes)), expected);
}

}  // namespace
}  // namespace echomap::protocol
