// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "hil_mock/emulator/simavr_board.hpp"
#include "tests/hil/measure/source_lines.hpp"

namespace echomap::tests {

/// Measures how old the encoder counts are of which a duty is made: from the first instruction that
/// takes them to the write of the motor's compare register. Slows the board to a tenth until
/// `stop`.
class ControlDelay {
 public:
  /// `board` runs `elf`; this outlives it, or at least its last run.
  ControlDelay(emulator::SimavrBoard& board, const std::filesystem::path& elf);
  ControlDelay(const ControlDelay&) = delete;
  ControlDelay& operator=(const ControlDelay&) = delete;

  void stop();

  double max_us() const { return max_us_; }
  double mean_us() const { return duties_ == 0 ? 0.0 : sum_us_ / duties_; }
  /// Of both motors.
  int duties() const { return duties_; }

 private:
  void note_instruction(std::uint32_t address);
  void note_duty();

  emulator::AvrMachine& machine_;
  SourceLines lines_;
  std::uint64_t sample_cycle_ = 0;
  std::uint64_t newest_sampling_cycle_ = 0;
  bool sampled_ = false;
  int duties_ = 0;
  double sum_us_ = 0.0;
  double max_us_ = 0.0;
};

}  // namespace echomap::tests
