// SPDX-License-Identifier: MIT
#include "hil_mock/runner/pin_log.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::runner {
namespace {

using world::DriverInputs;

TEST(PinLog, WritesAPinAsOneWord) {
  EXPECT_EQ(text_of(world::floating()), "z");
  EXPECT_EQ(text_of(world::pulled_up()), "u");
  EXPECT_EQ(text_of(world::level(false)), "0");
  EXPECT_EQ(text_of(world::level(true)), "1");
  EXPECT_EQ(text_of(world::pulses(0.25, 128.0)), "0.25/128");
  EXPECT_EQ(text_of(world::inverted_pulses(0.25, 128.0)), "~0.25/128");
  EXPECT_EQ(text_of(world::pulses(1.0, 128.0)), "1") << "no pulse has an end";
  EXPECT_EQ(text_of(world::pulses(0.0, 128.0)), "0");
}

TEST(PinLog, HasALineForEveryChange) {
  const tests::ScratchFolder folder;
  const auto file = folder / "pins.csv";
  PinLog log(file);
  const DriverInputs off{world::level(false), world::level(false), world::floating()};
  const DriverInputs on{world::pulses(0.5, 128.0), world::level(true), world::floating()};
  log.note(0, {}, {});
  log.note(1'000, off, off);
  log.note(2'000, off, off);
  log.note(2'063, off, on);
  EXPECT_EQ(files::read_text_file(file),
            "sim_ns,left_pwm,left_in1,left_in2,right_pwm,right_in1,right_in2\n"
            "0,z,z,z,z,z,z\n"
            "1000,0,0,z,0,0,z\n"
            "2063,0,0,z,0.5/128,1,z\n")
      << "while the log is still open";
}

TEST(PinLog, NeedsAPlaceForItsFile) {
  EXPECT_THROW(PinLog("/nowhere/pins.csv"), std::runtime_error);
}

}  // namespace
}  // namespace echomap::runner
