// SPDX-License-Identifier: MIT
#include "host/localization/workers.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(Workers, DoEachNumberOnce) {
  for (const int threads : {1, 2, 5}) {
    const Workers workers(threads);
    EXPECT_EQ(workers.threads(), threads);
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
      std::vector<std::atomic<int>> times(count);
      workers.share(count, [&](std::size_t number) { ++times[number]; });
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(times[i], 1) << threads << " threads, number " << i << " of " << count;
      }
    }
  }
}

TEST(Workers, AreDoneWhenTheyReturn) {
  const Workers workers(3);
  std::vector<int> values(40);
  for (int round = 0; round < 5000; ++round) {
    workers.share(values.size(), [&](std::size_t number) { values[number] = round; });
    ASSERT_EQ(values, std::vector<int>(40, round));
  }
}

TEST(Workers, WorkSideBySide) {
  const Workers workers(2);
  std::atomic<int> there = 0;
  workers.share(2, [&](std::size_t /*number*/) {
    ++there;
    while (there < 2) {
      std::this_thread::yield();
    }
  });
  EXPECT_EQ(there, 2);
}

TEST(Workers, ServeOneCallerAfterTheOther) {
  const Workers workers(2);
  const Workers same = workers;
  std::vector<int> here(500);
  std::vector<int> there(500);
  const auto count_up = [](const Workers& crew, std::vector<int>& values) {
    for (int round = 0; round < 200; ++round) {
      crew.share(values.size(), [&](std::size_t number) { ++values[number]; });
    }
  };
  std::thread other([&] { count_up(same, there); });
  count_up(workers, here);
  other.join();
  EXPECT_EQ(here, std::vector<int>(500, 200));
  EXPECT_EQ(there, std::vector<int>(500, 200));
}

TEST(Workers, TakeParticlesInBlocks) {
  const Workers workers(2);
  std::vector<int> times(3 * kBlock + 1);
  share_blocks(workers, times.size(), [&](ParticleRange range, std::size_t number) {
    EXPECT_EQ(range.begin, number * kBlock);
    EXPECT_LE(range.size(), kBlock);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      ++times[i];
    }
  });
  EXPECT_EQ(times, std::vector<int>(times.size(), 1));
}

TEST(Workers, AreAtLeastOne) { EXPECT_THROW(Workers(0), std::invalid_argument); }

}  // namespace
}  // namespace echomap::localization
