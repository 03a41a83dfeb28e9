// SPDX-License-Identifier: MIT
#include "hil_mock/runner/duty_log.hpp"

#include <chrono>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::runner {
namespace {

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::istringstream text(files::read_text_file(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string without_clock(const std::string& line) {
  const std::size_t clock = line.find(',');
  return line.substr(0, clock) + line.substr(line.find(',', clock + 1));
}

TEST(DutyLog, HasALineWheneverAWheelBeginsOrEnds) {
  const tests::ScratchFolder folder;
  const auto file = folder / "duty.csv";
  DutyLog log(file);
  log.note(10'000, {});
  log.note(20'000, {0.5, 0.0});
  log.note(30'000, {0.6, -0.0});
  log.note(40'000, {0.0, -0.25});
  log.note(50'000, {-0.0, -0.0});
  const std::vector<std::string> lines = lines_of(file);
  ASSERT_EQ(lines.size(), 4U) << "while the log is still open";
  EXPECT_EQ(lines[0], "sim_us,monotonic_us,left_duty,right_duty");
  EXPECT_EQ(without_clock(lines[1]), "20,0.5,0");
  EXPECT_EQ(without_clock(lines[2]), "40,0,-0.25");
  EXPECT_EQ(without_clock(lines[3]), "50,0,0");
}

TEST(DutyLog, HasTheClockOfTheMachine) {
  const tests::ScratchFolder folder;
  const auto now_us = [] {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
  };
  DutyLog log(folder / "duty.csv");
  const std::int64_t before_us = now_us();
  log.note(10'000, {1.0, 1.0});
  const std::int64_t after_us = now_us();
  const std::string line = lines_of(folder / "duty.csv").back();
  const std::int64_t noted_us = std::stoll(line.substr(line.find(',') + 1));
  EXPECT_GE(noted_us, before_us);
  EXPECT_LE(noted_us, after_us);
}

TEST(DutyLog, NeedsAPlaceForItsFile) {
  EXPECT_THROW(DutyLog("/nowhere/duty.csv"), std::runtime_error);
}

}  // namespace
}  // namespace echomap::runner
