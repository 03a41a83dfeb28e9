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
    contacts.poll();
  }
  Contacts contacts;
};

TEST_F(ContactsTest, PressCountsAtTheFirstPoll) {
  press(false, true);
  EXPECT_TRUE(contacts.left());
  EXPECT_FALSE(contacts.right());
  EXPECT_TRUE(contacts.just_pressed());
  contacts.poll();
  EXPECT_TRUE(contacts.any());
  EXPECT_FALSE(contacts.just_pressed());
}

TEST_F(ContactsTest, ReleaseCountsWhenItHasLasted) {
  press(true, true);
  press(true, false);
  for (int ms = 1; ms < Contacts::kReleaseMs; ++ms) {
    EXPECT_TRUE(contacts.right());
    contacts.poll();
  }
  EXPECT_FALSE(contacts.right());
}

TEST_F(ContactsTest, BouncingIsOnePress) {
  int presses = 0;
  for (int i = 0; i < 50; ++i) {
    press(false, i % 3 != 2);
    presses += contacts.just_pressed() ? 1 : 0;
  }
  EXPECT_EQ(presses, 1);
}

TEST_F(ContactsTest, SecondContactIsAPressOfItsOwn) {
  press(false, true);
  press(true, true);
  EXPECT_TRUE(contacts.just_pressed());
}

}  // namespace
}  // namespace echomap::drivers
