// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/lego_sensor.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::ev3 {
namespace {

TEST(LegoSensor, TellsItsPortKindAndValue) {
  const tests::ScratchFolder scratch;
  LegoSensor sensor(scratch / "sensor3", "ev3-ports:in4", {"lego-ev3-us", "US-DIST-CM", 1});
  sensor.show(1234);
  const auto line = [&](const char* name) {
    return files::read_text_file(scratch / "sensor3" / name);
  };
  EXPECT_EQ(line("address"), "ev3-ports:in4\n");
  EXPECT_EQ(line("driver_name"), "lego-ev3-us\n");
  EXPECT_EQ(line("decimals"), "1\n");
  EXPECT_EQ(line("value0"), "1234\n");
  files::write_text_file(scratch / "other", "");
  EXPECT_EQ(sensor.mode(), "US-DIST-CM");
}

}  // namespace
}  // namespace echomap::ev3
