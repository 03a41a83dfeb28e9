// SPDX-License-Identifier: MIT
#include "protocol/message_schema.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/frame_encoder.hpp"
#include "tests/protocol/every_message.hpp"
#include "tests/support/message_description.hpp"

namespace echomap::protocol {
namespace {

struct FieldNames {
  std::vector<std::string> names;
  void operator()(const char* name, char /*type_code*/) { names.emplace_back(name); }
};

template <class M>
std::vector<std::string> field_names() {
  FieldNames sink;
  describe<M>(sink);
  return sink.names;
}

struct FactsById {
  std::map<int, std::string> names;
  std::set<unsigned> seeds;
  int messages = 0;
  template <class M>
  void operator()(const M* /*tag*/) {
    names[M::kId] = M::name();
    seeds.insert(MessageFacts<M>::kSeed);
    ++messages;
  }
};

template <class List>
FactsById facts_of() {
  FactsById facts;
  List::for_each(facts);
  return facts;
}

template <class M>
class MessageSchemaOf : public testing::Test {};
TYPED_TEST_SUITE(MessageSchemaOf, TestTypes<AllMessages>::Types, MessageNames);

TYPED_TEST(MessageSchemaOf, FitsIntoAFrame) {
  EXPECT_LE(unsigned{MessageFacts<TypeParam>::kSize}, unsigned{kMaxPayload});
}

TYPED_TEST(MessageSchemaOf, IsFoundByItsId) {
  const Schema schema = AllMessages::find_schema(TypeParam::kId);
  ASSERT_TRUE(schema.known());
  EXPECT_EQ(schema.seed, unsigned{MessageFacts<TypeParam>::kSeed});
  EXPECT_EQ(schema.payload_size, unsigned{MessageFacts<TypeParam>::kSize});
}

TYPED_TEST(MessageSchemaOf, NamesEveryFieldOnce) {
  const std::vector<std::string> names = field_names<TypeParam>();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TYPED_TEST(MessageSchemaOf, BeginsWithItsCommandIdWhereItIsACommand) {
  if (TypeParam::message_class() == MessageClass::kCommand) {
    EXPECT_EQ(field_names<TypeParam>().front(), "command_id");
  }
}

TYPED_TEST(MessageSchemaOf, CarriesATimeToLiveWhereItIsASetpoint) {
  if (TypeParam::message_class() == MessageClass::kSetpoint) {
    EXPECT_THAT(field_names<TypeParam>(), testing::Contains("time_to_live_ms"));
  }
}

TEST(MessageSchema, NoTwoMessagesShareAnIdOrASeed) {
  const FactsById facts = facts_of<AllMessages>();
  EXPECT_EQ(facts.names.size(), static_cast<std::size_t>(facts.messages));
  EXPECT_EQ(facts.seeds.size(), static_cast<std::size_t>(facts.messages));
}

TEST(MessageSchema, EveryMessageGoesExactlyOneWay) {
  FactsById both_ways = facts_of<MessagesToRobot>();
  MessagesToHost::for_each(both_ways);
  const FactsById all = facts_of<AllMessages>();
  EXPECT_EQ(both_ways.names, all.names);
  EXPECT_EQ(both_ways.messages, all.messages);
}

TEST(MessageSchema, DoesNotFindAnIdOfTheOtherDirection) {
  EXPECT_FALSE(MessagesToHost::find_schema(Arm::kId).known());
  EXPECT_FALSE(MessagesToRobot::find_schema(Echo::kId).known());
}

// The list, the digest and the seeds are pinned by golden_vectors_test; here: what moves a seed.

struct Original {
  enum : std::uint8_t { kId = 0x7F };
  static constexpr const char* name() { return "Sample"; }
  std::uint16_t left;
  std::uint16_t right;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("left_ticks", m.left);
    v("right_ticks", m.right);
  }
};

struct Renamed : Original {
  static constexpr const char* name() { return "Other"; }
};

struct FieldRenamed : Original {
  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("left_counts", m.left);
    v("right_ticks", m.right);
  }
};

struct FieldsSwapped : Original {
  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("right_ticks", m.right);
    v("left_ticks", m.left);
  }
};

struct FieldRetyped {
  enum : std::uint8_t { kId = 0x7F };
  static constexpr const char* name() { return "Sample"; }
  std::int16_t left;
  std::uint16_t right;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("left_ticks", m.left);
    v("right_ticks", m.right);
  }
};

TEST(MessageSchema, AChangedNameTypeOrOrderChangesTheSeedAndTheDigest) {
  EXPECT_NE(seed_of<Renamed>(), seed_of<Original>());
  EXPECT_NE(seed_of<FieldRenamed>(), seed_of<Original>());
  EXPECT_NE(seed_of<FieldsSwapped>(), seed_of<Original>());
  EXPECT_NE(seed_of<FieldRetyped>(), seed_of<Original>());
  EXPECT_NE(MessageList<FieldRenamed>::digest(), MessageList<Original>::digest());
}

TEST(MessageSchema, TheHashIsFnv1a) {
  SchemaHash hash;
  for (const char character : std::string("foobar")) {
    hash.add(character);
  }
  EXPECT_EQ(hash.value(), 0xBF9CF968U);  // Fowler, Noll and Vo's test vector
}

}  // namespace
}  // namespace echomap::protocol
