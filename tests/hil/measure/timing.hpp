// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "hil_mock/emulator/simavr_board.hpp"
#include "tests/hil/measure/interrupt_meter.hpp"
#include "tests/hil/measure/loaded_robot.hpp"

namespace echomap::tests {

/// Names of the firmware's interrupts, as in the pages that list them, by vector number.
std::map<int, std::string> interrupt_names(const emulator::SimavrBoard& board);

/// Where the time of the chip goes under a load.
struct TimingFigures {
  std::map<std::string, InterruptCost> interrupts;  ///< By name; "vector N" where it has none.
  double interrupt_share = 0.0;
  double program_share = 0.0;
  double tick_jitter_us = 0.0;
  LoadResult load;

  double busy_share() const { return interrupt_share + program_share; }
};
TimingFigures measure_timing(const std::filesystem::path& elf, const Load& load, double seconds);

/// From encoder sample to PWM register.
struct ControlFigures {
  double mean_us = 0.0;
  double max_us = 0.0;
  double duties_per_s = 0.0;  ///< Of one wheel.
};
ControlFigures measure_control(const std::filesystem::path& elf, const Load& load, double seconds);

/// Everything that is asked of the line by habit: 100 Hz odometry, 25 Hz echo, status, and a host
/// that drives.
Load usual_load(double edges_per_s);

}  // namespace echomap::tests
