// SPDX-License-Identifier: MIT
#include "tests/hil/measure/timing.hpp"

#include "hil_mock/emulator/board_wiring.hpp"
#include "hil_mock/emulator/chip_modules.hpp"
#include "tests/hil/measure/control_delay.hpp"

namespace echomap::tests {
namespace {

/// Until speeds are reached.
constexpr double kRunUpS = 1.0;

int tick_vector(const avr_t& core) {
  return emulator::find_timer(core, '2').comp[AVR_TIMER_COMPA].interrupt.vector;
}

/// The robots of this program are simavr's.
emulator::SimavrBoard& simavr_board_of(LoadedRobot& robot) {
  return dynamic_cast<emulator::SimavrBoard&>(robot.session().board());
}

}  // namespace

std::map<int, std::string> interrupt_names(const emulator::SimavrBoard& board) {
  const avr_t& core = board.machine().core();
  const emulator::BoardWiring& wiring = board.wiring();
  const avr_timer_t& frame_timer = emulator::find_timer(core, wiring.pan_servo.timer);
  const avr_uart_t& uart = emulator::find_uart(core, '0');
  return {{emulator::find_port(core, wiring.left_encoder_a.port).pcint.vector, "encoder pins"},
          {tick_vector(core), "tick"},
          {frame_timer.icr.vector, "echo capture"},
          {frame_timer.overflow.vector, "clock overflow"},
          {uart.rxc.vector, "byte received"},
          {uart.udrc.vector, "byte to send"},
          {emulator::find_two_wire(core).twi.vector, "two-wire"}};
}

TimingFigures measure_timing(const std::filesystem::path& elf, const Load& load, double seconds) {
  LoadedRobot robot(elf, load);
  robot.connect();
  robot.run_s(kRunUpS);
  emulator::SimavrBoard& board = simavr_board_of(robot);
  InterruptMeter meter(board.machine(), tick_vector(board.machine().core()));
  robot.run_s(seconds);
  TimingFigures figures;
  const auto names = interrupt_names(board);
  for (const auto& [vector, cost] : meter.costs()) {
    const auto name = names.find(vector);
    figures.interrupts[name == names.end() ? "vector " + std::to_string(vector) : name->second] =
        cost;
  }
  figures.interrupt_share = meter.interrupt_share();
  figures.program_share = meter.program_share();
  figures.tick_jitter_us = meter.tick_jitter_us();
  figures.load = robot.finish();
  return figures;
}

ControlFigures measure_control(const std::filesystem::path& elf, const Load& load, double seconds) {
  LoadedRobot robot(elf, load);
  robot.connect();
  robot.run_s(kRunUpS);
  ControlDelay delay(simavr_board_of(robot), elf);
  robot.run_s(seconds);
  delay.stop();
  return {delay.mean_us(), delay.max_us(), delay.duties() / seconds / 2.0};
}

Load usual_load(double edges_per_s) {
  Load load;
  load.edges_per_s = edges_per_s;
  load.odometry_period_ms = 10;
  load.full_line = false;
  load.sweeps_on = true;
  return load;
}

}  // namespace echomap::tests
