// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/rp2040_board.hpp"
#include "tests/hil/measure/board_hangs.hpp"
#include "tests/hil/measure/chip_figures.hpp"

namespace echomap::tests {
namespace {

class PicoMeter final : public ChipMeter {
 public:
  explicit PicoMeter(rp2040::Rp2040Board& board) : board_(board) { board_.meter_load(); }

  ChipLoad load() const override {
    const rp2040::Rp2040Board::Load load = board_.load();
    return {load.busy_share, load.tick_jitter_us};
  }

 private:
  rp2040::Rp2040Board& board_;
};

}  // namespace

std::unique_ptr<ChipMeter> make_chip_meter(runner::SimulatedBoard& board) {
  return std::make_unique<PicoMeter>(dynamic_cast<rp2040::Rp2040Board&>(board));
}

std::unique_ptr<runner::SimulatedBoard> make_owned_board(const std::filesystem::path& elf) {
  return std::make_unique<rp2040::Rp2040Board>(elf, rp2040::PicoLine::kUart);
}

std::optional<double> measure_sample_to_pwm_us(const std::filesystem::path& /*elf*/) { return {}; }

double measure_worst_hang_ms(const std::filesystem::path& elf) {
  return measure_board_hangs_ms(elf);
}

std::optional<double> measure_crash_off_ms(const std::filesystem::path& elf) {
  return measure_board_crash_ms(elf);
}

}  // namespace echomap::tests
