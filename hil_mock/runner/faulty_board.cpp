// SPDX-License-Identifier: MIT
#include "hil_mock/runner/faulty_board.hpp"

#include <utility>

namespace echomap::runner {

using line_faults::Direction;

FaultyBoard::FaultyBoard(std::unique_ptr<SimulatedBoard> board,
                         const line_faults::LineFaults& faults)
    : board_(std::move(board)),
      to_robot_(faults, Direction::kToRobot),
      to_host_(faults, Direction::kToHost) {
  board_->on_sent = [this](std::uint8_t byte) { pass_to_host(byte); };
  board_->on_trigger = [this](std::int64_t at_ns) {
    if (on_trigger) {
      on_trigger(at_ns);
    }
  };
}

void FaultyBoard::receive(std::span<const std::uint8_t> bytes) {
  board_->receive(to_robot_.pass(bytes));
}

void FaultyBoard::pass_to_host(std::uint8_t byte) {
  for (const std::uint8_t passed : to_host_.pass({&byte, 1})) {
    if (on_sent) {
      on_sent(passed);
    }
  }
}

}  // namespace echomap::runner
