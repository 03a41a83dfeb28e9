// SPDX-License-Identifier: MIT
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "hil_mock/ev3/ev3_board.hpp"
#include "tests/hil/emulated_board.hpp"

namespace echomap::tests {
namespace {

/// Of real time: a loaded machine may keep a program from the processor for long.
constexpr std::chrono::milliseconds kBusyLimit{1500};
/// Guard and robot each ask for the time.
constexpr std::size_t kProcesses = 2;

class Ev3UnderTest final : public EmulatedBoard {
 public:
  explicit Ev3UnderTest(const std::filesystem::path& elf)
      : board_({ev3::under_qemu(elf), ev3::RangeSensor::kUltrasonic, kBusyLimit}) {}

  runner::SimulatedBoard& pins() override { return board_; }
  void cut_power() override { board_.reset(); }
  /// It has none: the battery is taken out.
  void pull_reset_pin() override { board_.reset(); }
  /// How often the guard has started the robot's program again.
  std::uint32_t resets() const override {
    return static_cast<std::uint32_t>(board_.processes_seen() - kProcesses);
  }
  void stop_ticks() override { hang(); }
  void hang() override { signal_robot(SIGSTOP); }
  void crash() override { signal_robot(SIGKILL); }
  void hold_two_wire_bus(unsigned /*bits*/) override {
    throw std::logic_error("the EV3 has no two-wire bus of its own");
  }

 private:
  /// To the robot's program, the guard's only child.
  void signal_robot(int signal) {
    const std::string guard = std::to_string(board_.pid().value());
    std::ifstream children("/proc/" + guard + "/task/" + guard + "/children");
    pid_t robot = 0;
    if (!(children >> robot) || ::kill(robot, signal) != 0) {
      throw std::runtime_error("the guard has started no robot");
    }
  }

  ev3::Ev3Board board_;
};

}  // namespace

std::unique_ptr<EmulatedBoard> make_emulated_board(const std::filesystem::path& elf) {
  return std::make_unique<Ev3UnderTest>(elf);
}

std::vector<const char*> flashed_images() { return {"echomap-ev3"}; }

std::vector<const char*> images_of_every_baud() { return flashed_images(); }

std::vector<const char*> images_that_tell_lost_steps() { return {}; }

std::vector<const char*> vector_images() { return {}; }

}  // namespace echomap::tests
