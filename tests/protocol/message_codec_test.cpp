// SPDX-License-Identifier: MIT
#include "protocol/message_codec.hpp"

#include <cstdint>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/protocol/every_message.hpp"
#include "tests/protocol/frames.hpp"

namespace echomap::protocol {
namespace {

template <class M>
class MessageCodecOf : public testing::Test {};
TYPED_TEST_SUITE(MessageCodecOf, TestTypes<AllMessages>::Types, MessageNames);

TYPED_TEST(MessageCodecOf, BringsEveryRandomMessageBack) {
  std::mt19937 generator(TypeParam::kId);
  for (int i = 0; i < 1000; ++i) {
    const auto message = random_message<TypeParam>(generator);
    Bytes payload(MessageFacts<TypeParam>::kSize);
    put_payload(message, payload.data());
    ASSERT_EQ(values_of(get_payload<TypeParam>(payload.data())), values_of(message));
  }
}

TYPED_TEST(MessageCodecOf, BringsEveryRandomPayloadBack) {
  std::mt19937 generator(TypeParam::kId);
  for (int i = 0; i < 1000; ++i) {
    Bytes payload(MessageFacts<TypeParam>::kSize);
    for (std::uint8_t& byte : payload) {
      byte = static_cast<std::uint8_t>(generator());
    }
    Bytes again(payload.size());
    put_payload(get_payload<TypeParam>(payload.data()), again.data());
    ASSERT_EQ(again, payload);
  }
}

TEST(MessageCodec, WritesFieldsInOrderAndLittleEndian) {
  const Echo echo{0x04030201, -2, 0x0605, 0x0807, -32768};
  Bytes payload(MessageFacts<Echo>::kSize);
  put_payload(echo, payload.data());
  EXPECT_EQ(payload,
            (Bytes{0x01, 0x02, 0x03, 0x04, 0xFE, 0xFF, 0x05, 0x06, 0x07, 0x08, 0x00, 0x80}));
}

struct NamePrinter {
  std::string name;
  template <class M>
  void operator()(const M& /*message*/) {
    name += M::name();
  }
};

TYPED_TEST(MessageCodecOf, IsDispatchedByItsIdAndNoOther) {
  const Bytes payload(MessageFacts<TypeParam>::kSize);
  NamePrinter printer;
  EXPECT_TRUE(Dispatcher<AllMessages>::dispatch(TypeParam::kId, payload.data(), printer));
  EXPECT_EQ(printer.name, TypeParam::name());
}

TEST(MessageCodec, DispatchesNoUnknownId) {
  const Bytes payload(kMaxPayload);
  NamePrinter printer;
  EXPECT_FALSE(Dispatcher<MessagesToHost>::dispatch(Arm::kId, payload.data(), printer));
  EXPECT_EQ(printer.name, "");
}

}  // namespace
}  // namespace echomap::protocol
