// SPDX-License-Identifier: MIT
#include "firmware/drivers/contacts.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"

namespace echomap::drivers {
namespace {

class ContactsTest : public testing::Test {
 protected:
  ~ContactsTest() override {
    press(false, false);
    press(true, false);
  }
  void press(bool right, bool pressed) {
    native::NativeBoard::instance().set_bump(right, pressed);
    contacts.poll(0);
  }
  Contacts contacts;
};

TEST_F(ContactsTest, PressCountsAtTheFirstPoll) {
  press(false, true);
  EXPECT_EQ(contacts.pressed(), hal::kContactLeft);
  EXPECT_EQ(contacts.just_pressed(), hal::kContactLeft);
  contacts.poll(0);
  EXPECT_EQ(contacts.pressed(), hal::kContactLeft);
  EXPECT_EQ(contacts.just_pressed(), 0);
}

TEST_F(ContactsTest, ReleaseCountsWhenItHasLasted) {
  press(true, true);
  press(true, false);
  EXPECT_EQ(contacts.pressed(), hal::kContactRight);
  for (int ms = 1; ms < Contacts::kMaxReleaseMs; ++ms) {
    contacts.poll(0);
  }
  EXPECT_EQ(contacts.pressed(), 0);
}

TEST_F(ContactsTest, BouncingIsOnePress) {
  int presses = 0;
  for (int i = 0; i < 50; ++i) {
    press(false, i % 3 != 2);
    presses += contacts.just_pressed() != 0 ? 1 : 0;
  }
  EXPECT_EQ(presses, 1);
}

TEST_F(ContactsTest, SecondContactIsAPressOfItsOwn) {
  press(false, true);
  press(true, true);
  EXPECT_EQ(contacts.just_pressed(), hal::kContactRight);
}

TEST_F(ContactsTest, OneThatIsNormallyClosedIsPressedWhereItOpensOrItsWireBreaks) {
  press(false, true);
  contacts.restart();
  contacts.poll(hal::kContactLeft);
  EXPECT_EQ(contacts.pressed(), 0);
  native::NativeBoard::instance().set_bump(false, false);
  contacts.poll(hal::kContactLeft);
  EXPECT_EQ(contacts.just_pressed(), hal::kContactLeft);
}

TEST_F(ContactsTest, ForgetsAtARestartWhatWasReadOtherwise) {
  press(false, true);
  contacts.restart();
  EXPECT_EQ(contacts.pressed(), 0);
  contacts.poll(0);
  EXPECT_EQ(contacts.just_pressed(), hal::kContactLeft) << "it is still pressed";
}

}  // namespace
}  // namespace echomap::drivers
