// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>

#include "hil_mock/unicorn/unicorn_board.hpp"
#include "tests/hil/measure/board_hangs.hpp"
#include "tests/hil/measure/chip_figures.hpp"

namespace echomap::tests {
namespace {

constexpr auto kTickCycles = static_cast<std::int64_t>(unicorn::kClockHz / 1000);

/// Takes the core's hook `on_enter`.
class Stm32Meter final : public ChipMeter {
 public:
  explicit Stm32Meter(unicorn::Stm32Chip& chip)
      : chip_(chip), first_cycle_(chip.cycle()), slept_before_(chip.core().slept_cycles()) {
    chip_.core().on_enter = [this](unicorn::Exception exception) {
      if (exception == unicorn::Nvic::kSysTick) {
        note_tick();
      }
    };
  }
  ~Stm32Meter() override { chip_.core().on_enter = nullptr; }
  Stm32Meter(const Stm32Meter&) = delete;
  Stm32Meter& operator=(const Stm32Meter&) = delete;

  ChipLoad load() const override {
    const double slept = double(chip_.core().slept_cycles() - slept_before_);
    const double passed = double(chip_.cycle() - first_cycle_);
    return {1.0 - slept / passed, double(latest_ - earliest_) * 1e6 / double(unicorn::kClockHz)};
  }

 private:
  /// Against a grid of a millisecond through the first.
  void note_tick() {
    const auto cycle = static_cast<std::int64_t>(chip_.cycle());
    first_tick_cycle_ = first_tick_cycle_ == 0 ? cycle : first_tick_cycle_;
    const std::int64_t since = cycle - first_tick_cycle_;
    const std::int64_t ticks = (since + kTickCycles / 2) / kTickCycles;
    earliest_ = std::min(earliest_, since - ticks * kTickCycles);
    latest_ = std::max(latest_, since - ticks * kTickCycles);
  }

  unicorn::Stm32Chip& chip_;
  std::uint64_t first_cycle_;
  std::uint64_t slept_before_;
  std::int64_t first_tick_cycle_ = 0;
  std::int64_t earliest_ = 0;
  std::int64_t latest_ = 0;
};

}  // namespace

std::unique_ptr<ChipMeter> make_chip_meter(runner::SimulatedBoard& board) {
  return std::make_unique<Stm32Meter>(dynamic_cast<unicorn::UnicornBoard&>(board).chip());
}

std::unique_ptr<runner::SimulatedBoard> make_owned_board(const std::filesystem::path& elf) {
  return std::make_unique<unicorn::UnicornBoard>(elf);
}

std::optional<double> measure_sample_to_pwm_us(const std::filesystem::path& /*elf*/) { return {}; }

double measure_worst_hang_ms(const std::filesystem::path& elf) {
  return measure_board_hangs_ms(elf);
}

std::optional<double> measure_crash_off_ms(const std::filesystem::path& elf) {
  return measure_board_crash_ms(elf);
}

}  // namespace echomap::tests
