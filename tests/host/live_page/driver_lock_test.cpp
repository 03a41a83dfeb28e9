// SPDX-License-Identifier: MIT
#include "host/live_page/driver_lock.hpp"

#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using Steering = DriverLock::Steering;

constexpr bool kMoving = false;
constexpr bool kAtRest = true;

TEST(DriverLock, IsFreeAtFirstEvenAtTheClocksStart) {
  const DriverLock lock;
  EXPECT_FALSE(lock.holder(0.0));
  EXPECT_FALSE(lock.is_held_by_other(1, 0.0));
}

TEST(DriverLock, GoesToTheFirstWhoSteers) {
  DriverLock lock;
  EXPECT_EQ(lock.steer(1, kMoving, 10.0), Steering::kAllowed);
  EXPECT_EQ(lock.steer(2, kMoving, 20.0), Steering::kHeldByOther);
  EXPECT_EQ(lock.holder(20.0), 1U);
  EXPECT_TRUE(lock.is_held_by_other(2, 20.0));
  EXPECT_FALSE(lock.is_held_by_other(1, 20.0));
}

TEST(DriverLock, IsFreeAfterTwoSecondsOfSilence) {
  DriverLock lock;
  lock.steer(1, kMoving, 0.0);
  lock.steer(1, kMoving, 1000.0);
  EXPECT_EQ(lock.holder(2999.0), 1U);
  EXPECT_FALSE(lock.holder(3000.0));
  EXPECT_EQ(lock.steer(2, kMoving, 3000.0), Steering::kAllowed);
  EXPECT_EQ(lock.steer(1, kMoving, 3001.0), Steering::kHeldByOther);
}

TEST(DriverLock, IsNotHeldLongerByTheOneItIsRefusedTo) {
  DriverLock lock;
  lock.steer(1, kMoving, 0.0);
  lock.steer(2, kMoving, 1900.0);
  EXPECT_FALSE(lock.holder(2000.0));
}

TEST(DriverLock, IsReleasedByItsHolderAlone) {
  DriverLock lock;
  lock.steer(1, kMoving, 0.0);
  EXPECT_FALSE(lock.release(2, 1.0));
  EXPECT_EQ(lock.holder(1.0), 1U);
  EXPECT_TRUE(lock.release(1, 1.0));
  EXPECT_FALSE(lock.holder(1.0));
  EXPECT_FALSE(lock.release(1, 1.0));
}

TEST(DriverLock, IsNotReleasedAfterItRanOut) {
  DriverLock lock;
  lock.steer(1, kMoving, 0.0);
  EXPECT_FALSE(lock.release(1, 2000.0));
}

TEST(DriverLock, MakesTheDriverLetGoAfterAStop) {
  DriverLock lock;
  lock.steer(1, kMoving, 0.0);
  lock.stop();
  EXPECT_EQ(lock.steer(1, kMoving, 100.0), Steering::kMustLetGo);
  EXPECT_EQ(lock.steer(1, kMoving, 2000.0), Steering::kMustLetGo);
  EXPECT_EQ(lock.steer(1, kMoving, 3900.0), Steering::kMustLetGo) << "a key that is still held";
  EXPECT_EQ(lock.steer(1, kAtRest, 4000.0), Steering::kAllowed);
  EXPECT_EQ(lock.steer(1, kMoving, 4100.0), Steering::kAllowed);
}

TEST(DriverLock, LetsSomebodyNewDriveAfterAStop) {
  DriverLock lock;
  lock.stop();
  EXPECT_EQ(lock.steer(1, kMoving, 10.0), Steering::kAllowed);
  lock.stop();
  lock.release(1, 20.0);
  EXPECT_EQ(lock.steer(2, kMoving, 30.0), Steering::kAllowed);
}

}  // namespace
}  // namespace echomap::live_page
