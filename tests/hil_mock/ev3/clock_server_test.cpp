// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/clock_server.hpp"

#include <chrono>
#include <string>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "tests/support/scratch_folder.hpp"

namespace echomap::ev3 {
namespace {

using std::chrono::milliseconds;

/// A program that sleeps by the clock, from within the test.
class Sleeper {
 public:
  explicit Sleeper(const std::filesystem::path& socket)
      : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    socket.string().copy(address.sun_path, sizeof address.sun_path - 1);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the interface of the kernel
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ~Sleeper() { leave(); }
  Sleeper(const Sleeper&) = delete;
  Sleeper& operator=(const Sleeper&) = delete;

  void sleep_until(std::uint64_t us) const {
    EXPECT_EQ(::send(socket_, &us, sizeof us, MSG_NOSIGNAL), static_cast<ssize_t>(sizeof us));
  }
  /// The time that it was told; empty where it still waits.
  std::optional<std::uint64_t> told_us() const {
    std::uint64_t us = 0;
    return ::recv(socket_, &us, sizeof us, 0) == sizeof us ? std::optional(us) : std::nullopt;
  }
  void leave() {
    if (socket_ >= 0) {
      ::close(socket_);
    }
    socket_ = -1;
  }

 private:
  int socket_;
};

class ClockServerTest : public testing::Test {
 protected:
  void wait(std::uint64_t now_us, milliseconds limit = milliseconds(0)) {
    clock.wait_until_all_sleep(now_us, limit, [] {});
  }

  tests::ScratchFolder scratch;
  ClockServer clock{scratch / "clock"};
};

TEST_F(ClockServerTest, TellsTheTimeToWhoConnects) {
  const Sleeper sleeper(scratch / "clock");
  sleeper.sleep_until(9000);
  wait(5000, milliseconds(1000));
  EXPECT_EQ(sleeper.told_us(), 5000U);
  EXPECT_EQ(clock.next_wake_us(), 9000U);
}

TEST_F(ClockServerTest, WakesWhoIsDueAndNobodyElse) {
  const Sleeper early(scratch / "clock");
  const Sleeper late(scratch / "clock");
  early.sleep_until(1000);
  late.sleep_until(2000);
  wait(0, milliseconds(1000));
  EXPECT_TRUE(early.told_us() && late.told_us());
  EXPECT_EQ(clock.next_wake_us(), 1000U);
  clock.wake(1000, false);
  EXPECT_EQ(early.told_us(), 1000U);
  EXPECT_FALSE(late.told_us());
}

TEST_F(ClockServerTest, BytesWakeTheOneThatHasConnectedLast) {
  const Sleeper guard(scratch / "clock");
  const Sleeper robot(scratch / "clock");
  guard.sleep_until(120'000);
  robot.sleep_until(5000);
  wait(0, milliseconds(1000));
  EXPECT_TRUE(guard.told_us() && robot.told_us());
  clock.wake(1000, true);
  EXPECT_EQ(robot.told_us(), 1000U);
  EXPECT_FALSE(guard.told_us());
}

TEST_F(ClockServerTest, GoesOnWithoutOneThatHangsUntilItAsksAgain) {
  const Sleeper hanging(scratch / "clock");
  const auto start = std::chrono::steady_clock::now();
  wait(0, milliseconds(100));
  EXPECT_GE(std::chrono::steady_clock::now() - start, milliseconds(100));
  EXPECT_FALSE(clock.next_wake_us());
  wait(1000, milliseconds(60'000));
  hanging.sleep_until(3000);
  wait(2000, milliseconds(60'000));
  EXPECT_EQ(clock.next_wake_us(), 3000U);
}

TEST_F(ClockServerTest, ForgetsWhoHasGone) {
  Sleeper sleeper(scratch / "clock");
  sleeper.sleep_until(1000);
  wait(0, milliseconds(1000));
  EXPECT_TRUE(clock.has_clients());
  sleeper.leave();
  wait(500, milliseconds(1000));
  EXPECT_FALSE(clock.has_clients());
  EXPECT_EQ(clock.connections(), 1U);
}

}  // namespace
}  // namespace echomap::ev3
