// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/flash_writer.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

class Flash : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kKeyr = 0x04;
  static constexpr std::uint32_t kSr = 0x0C;
  static constexpr std::uint32_t kCr = 0x10;
  static constexpr std::uint32_t kAr = 0x14;
  static constexpr std::uint32_t kProgram = 1;
  static constexpr std::uint32_t kErase = 2;
  static constexpr std::uint32_t kStart = 1U << 6;
  static constexpr std::uint32_t kLock = 1U << 7;
  static constexpr std::uint32_t kProgramError = 1U << 2;
  static constexpr std::uint32_t kErased = 0xFFFF;

  Flash() { flash.reset(); }

  void unlock() {
    flash.write(kKeyr, 0x45670123);
    flash.write(kKeyr, 0xCDEF89AB);
  }

  bool complains() { return (flash.read(kSr) & kProgramError) != 0; }

  EventQueue queue;
  FlashWriter flash{queue};
};

TEST_F(Flash, StaysLockedWithoutBothKeysInOrder) {
  flash.write(kKeyr, 0xCDEF89AB);
  flash.write(kKeyr, 0x45670123);
  flash.write(kCr, kProgram);
  EXPECT_EQ(flash.read(kCr), kLock);
  flash.write_data(0, 2, 0x1234);
  EXPECT_EQ(flash.read_data(0, 2), kErased);
  EXPECT_TRUE(complains());
}

TEST_F(Flash, WritesAHalfWordIn53Microseconds) {
  unlock();
  flash.write(kCr, kProgram);
  flash.write_data(6, 2, 0x1234);
  EXPECT_FALSE(complains());
  EXPECT_EQ(flash.read_data(6, 2), 0x1234U);
  EXPECT_EQ(flash.read_data(4, 4), 0x1234FFFFU);
  EXPECT_EQ(flash.read_data(7, 1), 0x12U);
  EXPECT_EQ(queue.now(), 53U * 72);
}

TEST_F(Flash, WritesNoWordAndNothingTwice) {
  unlock();
  flash.write(kCr, kProgram);
  flash.write_data(0, 4, 0x1234);
  EXPECT_TRUE(complains());
  flash.write(kSr, kProgramError);
  flash.write_data(0, 2, 0x1234);
  EXPECT_FALSE(complains());
  flash.write_data(0, 2, 0x0034);
  EXPECT_TRUE(complains());
  EXPECT_EQ(flash.read_data(0, 2), 0x1234U);
}

TEST_F(Flash, ErasesOnePageIn20Milliseconds) {
  unlock();
  flash.write(kCr, kProgram);
  flash.write_data(0x3FE, 2, 1);
  flash.write_data(0x400, 2, 2);
  flash.write_data(0x7FE, 2, 3);
  flash.write_data(0x800, 2, 4);
  const std::uint64_t before = queue.now();
  flash.write(kCr, kErase);
  flash.write(kAr, FlashWriter::kDataAddress + 0x400);
  flash.write(kCr, kErase | kStart);
  EXPECT_EQ(queue.now() - before, 20U * 72'000);
  EXPECT_EQ(flash.read_data(0x3FE, 2), 1U);
  EXPECT_EQ(flash.read_data(0x400, 2), kErased);
  EXPECT_EQ(flash.read_data(0x7FE, 2), kErased);
  EXPECT_EQ(flash.read_data(0x800, 2), 4U);
}

TEST_F(Flash, KeepsWhatIsWrittenAndLocksItselfAtAReset) {
  unlock();
  flash.write(kCr, kProgram);
  flash.write_data(0, 2, 7);
  flash.reset();
  EXPECT_EQ(flash.read_data(0, 2), 7U);
  EXPECT_EQ(flash.read(kCr), kLock);
}

}  // namespace
}  // namespace echomap::unicorn
