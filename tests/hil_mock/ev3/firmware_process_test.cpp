// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/firmware_process.hpp"

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace echomap::ev3 {
namespace {

constexpr std::chrono::milliseconds kLook{5};
constexpr int kLooks = 2000;

/// What it says until `size` bytes have come or it takes too long.
std::string heard(FirmwareProcess& process, std::size_t size) {
  std::vector<std::uint8_t> bytes;
  for (int look = 0; look < kLooks && bytes.size() < size; ++look) {
    process.read(bytes);
    std::this_thread::sleep_for(kLook);
  }
  return {bytes.begin(), bytes.end()};
}

std::optional<int> end_of(FirmwareProcess& process) {
  for (int look = 0; look < kLooks && !process.exit_status(); ++look) {
    std::this_thread::sleep_for(kLook);
  }
  return process.exit_status();
}

TEST(FirmwareProcess, PassesBytesBothWays) {
  FirmwareProcess cat({"cat"});
  const std::string text = "hello";
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  cat.write(bytes);
  EXPECT_EQ(heard(cat, text.size()), text);
  EXPECT_FALSE(cat.exit_status());
}

TEST(FirmwareProcess, TellsHowItHasEnded) {
  FirmwareProcess process({"sh", "-c", "exit 3"});
  EXPECT_EQ(end_of(process), 3);
  const std::vector<std::uint8_t> bytes{1, 2, 3};
  process.write(bytes);
  FirmwareProcess missing({"there-is-no-such-program"});
  EXPECT_EQ(end_of(missing), 127);
  FirmwareProcess killed({"cat"});
  ::kill(killed.pid(), SIGKILL);
  EXPECT_EQ(end_of(killed), 128 + SIGKILL);
}

TEST(FirmwareProcess, TakesWhatItHasStartedWithIt) {
  pid_t child = 0;
  {
    FirmwareProcess process({"sh", "-c", "sleep 100 & echo $!; wait"});
    child = std::stoi(heard(process, 2));
    EXPECT_EQ(::kill(child, 0), 0);
  }
  int looks = 0;
  while (::kill(child, 0) == 0 && looks++ < kLooks) {
    std::this_thread::sleep_for(kLook);
  }
  EXPECT_LT(looks, kLooks);
}

}  // namespace
}  // namespace echomap::ev3
