// SPDX-License-Identifier: MIT
#include "host/fleet_messages/body_packing.hpp"

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

namespace echomap::fleet_messages {
namespace {

constexpr std::size_t kLimit = 1000;

TEST(BodyPacking, UnpacksWhatItPacked) {
  for (const std::string& bytes : {std::string(), std::string("a"), std::string(900, 'x')}) {
    EXPECT_EQ(unpack(pack(bytes), kLimit), bytes);
  }
}

TEST(BodyPacking, MakesALongRunShort) { EXPECT_LT(pack(std::string(10000, 'x')).size(), 30U); }

TEST(BodyPacking, RefusesMoreThanTheLimit) {
  EXPECT_TRUE(unpack(pack(std::string(kLimit, 'x')), kLimit));
  EXPECT_FALSE(unpack(pack(std::string(kLimit + 1, 'x')), kLimit));
  EXPECT_FALSE(unpack(pack(std::string(100'000'000, 'x')), kLimit)) << "a bomb of some kB";
}

TEST(BodyPacking, RefusesEveryPartOfAFrameAndMoreThanOne) {
  const std::string packed = pack("one two three one two three one two three");
  for (std::size_t size = 0; size < packed.size(); ++size) {
    EXPECT_FALSE(unpack(packed.substr(0, size), kLimit)) << size;
  }
  EXPECT_FALSE(unpack(packed + "x", kLimit));
  EXPECT_FALSE(unpack(packed + packed, kLimit));
}

TEST(BodyPacking, RefusesAFrameThatDoesNotSayItsSize) {
  // Magic number, a header without size and with a window of 1 kB, an empty last block.
  const std::string unsized("\x28\xB5\x2F\xFD\x00\x00\x01\x00\x00", 9);
  EXPECT_FALSE(unpack(unsized, kLimit));
}

}  // namespace
}  // namespace echomap::fleet_messages
