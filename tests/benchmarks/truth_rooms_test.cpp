// SPDX-License-Identifier: MIT
#include "tests/benchmarks/truth_rooms.hpp"

#include <atomic>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

TEST(TruthRooms, AreSixteenAndCanBeRead) {
  EXPECT_EQ(truth_room_names().size(), 16U);
  for (const std::string& name : truth_room_names()) {
    EXPECT_EQ(truth_room(name, {}).name, name);
  }
}

TEST(TruthRooms, AreOfTheReleaseImageInFourOfThem) {
  const TruthEmulators mixed;
  EXPECT_EQ(mixed.of("office"), "simavr");
  EXPECT_EQ(mixed.of("attic"), "mock");
  EXPECT_EQ((TruthEmulators{"mock", {"office"}}).of("office"), "mock");
}

TEST(ForEachInJobs, CallsEachOnce) {
  std::vector<std::atomic<int>> calls(20);
  for_each_in_jobs(calls.size(), 3, [&](std::size_t i) { ++calls[i]; });
  for (const auto& count : calls) {
    EXPECT_EQ(count, 1);
  }
}

}  // namespace
}  // namespace echomap::bench
