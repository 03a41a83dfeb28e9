// SPDX-License-Identifier: MIT
#include "host/live_page/queued_sender.hpp"

#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

TEST(QueuedSender, WakesTheWriterOnceUntilItLooks) {
  int wakes = 0;
  QueuedSender sender([&] { ++wakes; });
  sender.send(text_frame("a"));
  sender.send(text_frame("b"));
  EXPECT_EQ(wakes, 1);
  EXPECT_EQ(*sender.take()->bytes, "a");
  sender.send(text_frame("c"));
  EXPECT_EQ(wakes, 2);
}

TEST(QueuedSender, ClosesAClientThatReadsTooLittleAtOnce) {
  int wakes = 0;
  QueuedSender sender([&] { ++wakes; }, 10);
  sender.send(text_frame("0123456789"));
  EXPECT_FALSE(sender.is_closed());
  sender.send(text_frame("0"));
  EXPECT_TRUE(sender.is_closed());
  EXPECT_EQ(wakes, 2);
  sender.send(text_frame("nothing any more"));
  sender.close();
  EXPECT_EQ(wakes, 2);
}

TEST(QueuedSender, WakesNobodyAfterTheClientIsGone) {
  int wakes = 0;
  QueuedSender sender([&] { ++wakes; });
  sender.detach();
  sender.send(text_frame("a"));
  sender.close();
  EXPECT_EQ(wakes, 0);
  EXPECT_FALSE(sender.take());
}

TEST(QueuedSender, TakesFramesFromSeveralThreads) {
  QueuedSender sender([] {});
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&sender] {
      for (int k = 0; k < 1000; ++k) {
        sender.send(text_frame("x"));
      }
    });
  }
  int taken = 0;
  while (taken < 4000) {
    taken += sender.take() ? 1 : 0;
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_FALSE(sender.take());
}

}  // namespace
}  // namespace echomap::live_page
