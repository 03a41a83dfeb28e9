// SPDX-License-Identifier: MIT
#include "hil_mock/emulator/chip_modules.hpp"
#include "hil_mock/emulator/simavr_board.hpp"
#include "tests/hil/measure/chip_figures.hpp"
#include "tests/hil/measure/planted_hangs.hpp"
#include "tests/hil/measure/timing.hpp"

namespace echomap::tests {
namespace {

class AvrMeter final : public ChipMeter {
 public:
  explicit AvrMeter(emulator::SimavrBoard& board)
      : meter_(board.machine(),
               emulator::find_timer(board.machine().core(), '2')
                   .comp[AVR_TIMER_COMPA]
                   .interrupt.vector) {}

  ChipLoad load() const override {
    return {meter_.interrupt_share() + meter_.program_share(), meter_.tick_jitter_us()};
  }

 private:
  InterruptMeter meter_;
};

}  // namespace

std::unique_ptr<ChipMeter> make_chip_meter(runner::SimulatedBoard& board) {
  return std::make_unique<AvrMeter>(dynamic_cast<emulator::SimavrBoard&>(board));
}

std::unique_ptr<runner::SimulatedBoard> make_owned_board(const std::filesystem::path& elf) {
  return std::make_unique<emulator::SimavrBoard>(elf);
}

std::optional<double> measure_sample_to_pwm_us(const std::filesystem::path& elf) {
  return measure_control(elf, {.edges_per_s = 40'000}, 4.0).max_us;
}

double measure_worst_hang_ms(const std::filesystem::path& elf) { return measure_hang_ms(elf); }

std::optional<double> measure_crash_off_ms(const std::filesystem::path& /*elf*/) { return {}; }

}  // namespace echomap::tests
