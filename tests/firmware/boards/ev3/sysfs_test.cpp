// SPDX-License-Identifier: MIT
#include "firmware/boards/ev3/sysfs.hpp"

#include <gtest/gtest.h>

#include "tests/firmware/boards/ev3/brick_folder.hpp"

namespace echomap::boards {
namespace {

class Ev3SysfsTest : public testing::Test {
 protected:
  bool finds(const char* port) {
    return find_device(brick.sysfs().c_str(), "tacho-motor", port, found);
  }

  tests::BrickFolder brick;
  DeviceFolder found{};
};

TEST_F(Ev3SysfsTest, MotorIsFoundByTheEndOfItsAddressWhateverItsNumber) {
  brick.add_motor(0, "ev3-ports:outC");
  const auto motor = brick.add_motor(7, "ev3-ports:outA");
  brick.add_motor(1, "outB");
  ASSERT_TRUE(finds("outA"));
  EXPECT_EQ(motor, found.path);
  EXPECT_TRUE(finds("outB"));
  EXPECT_FALSE(finds("outD"));
}

TEST_F(Ev3SysfsTest, AddressThatOnlyEndsInThePortsNameIsAnother) {
  brick.add_motor(0, "ev3-ports:in1:mux:layoutA");
  EXPECT_FALSE(finds("outA"));
}

TEST_F(Ev3SysfsTest, NumbersComeBackAsTheyWereWritten) {
  const auto motor = brick.add_motor(0, "outA");
  ASSERT_TRUE(finds("outA"));
  Attribute position;
  ASSERT_TRUE(position.open(found, "position", Access::kReadAndWrite));
  for (const std::int32_t number : {0, 7, -7, 100, -32768, INT32_MAX, INT32_MIN}) {
    ASSERT_TRUE(position.write(number));
    std::int32_t read = 1;
    ASSERT_TRUE(position.read(read));
    EXPECT_EQ(read, number);
    EXPECT_EQ(tests::BrickFolder::read(motor / "position"), std::to_string(number));
  }
}

TEST_F(Ev3SysfsTest, TextThatIsNoNumberIsNotRead) {
  const auto motor = brick.add_motor(0, "outA");
  ASSERT_TRUE(finds("outA"));
  Attribute state;
  tests::BrickFolder::write(motor / "state", "running overloaded");
  ASSERT_TRUE(state.open(found, "state", Access::kRead));
  std::int32_t number = 0;
  EXPECT_FALSE(state.read(number));
  char word[16];
  EXPECT_TRUE(state.read_word(word, sizeof word));
  EXPECT_STREQ(word, "running");
}

TEST_F(Ev3SysfsTest, FileThatIsNotThereIsNeitherReadNorWritten) {
  brick.add_motor(0, "outA");
  ASSERT_TRUE(finds("outA"));
  Attribute missing;
  std::int32_t number = 0;
  EXPECT_FALSE(missing.open(found, "no_such_file", Access::kReadAndWrite));
  EXPECT_FALSE(missing.read(number));
  EXPECT_FALSE(missing.write("1\n"));
}

TEST_F(Ev3SysfsTest, FileThatMayOnlyBeReadIsNotOpenedToBeWritten) {
  const auto motor = brick.add_motor(0, "outA");
  ASSERT_TRUE(finds("outA"));
  // Root may write into every file, but not into a folder.
  std::filesystem::create_directory(motor / "folder");
  Attribute attribute;
  EXPECT_TRUE(attribute.open(found, "folder", Access::kRead));
  EXPECT_FALSE(attribute.open(found, "folder", Access::kWrite));
  EXPECT_FALSE(attribute.is_open());
  EXPECT_FALSE(attribute.open(found, "folder", Access::kReadAndWrite));
}

}  // namespace
}  // namespace echomap::boards
