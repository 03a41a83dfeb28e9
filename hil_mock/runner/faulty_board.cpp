// SPDX-License-Identifier: MIT
#include "hil_mock/runner/faulty_board.hpp"

#include <algorithm>
#include <utility>

namespace echomap::runner {

using line_faults::Direction;

FaultyBoard::FaultyBoard(std::unique_ptr<SimulatedBoard> board, const LineModel& line)
    : board_(std::move(board)),
      faults_(line.faults),
      to_robot_(line.faults, Direction::kToRobot),
      to_host_(line.faults, Direction::kToHost) {
  if (line.delays) {
    const auto noise = [&](std::uint32_t direction) {
      return world::NoiseStream(2 * line.faults.seed + direction, world::NoisePurpose::kLineDelays);
    };
    delay_to_robot_.emplace(line.delays->to_robot, noise(0));
    delay_to_host_.emplace(line.delays->to_host, noise(1));
  }
  board_->on_sent = [this](std::uint8_t byte) { take_from_board(byte); };
  board_->on_duty = [this] {
    if (on_duty) {
      on_duty();
    }
  };
  board_->on_trigger = [this](std::int64_t at_ns) {
    if (on_trigger) {
      on_trigger(at_ns);
    }
  };
}

void FaultyBoard::cut_cable(std::int64_t for_ns) {
  cut_until_ns_ = std::max(cut_until_ns_, board_->now_ns() + for_ns);
}

/// In pieces that end where bytes arrive at the board.
void FaultyBoard::run_until(std::int64_t until_ns) {
  move_plug();
  if (!delay_to_robot_ || !delay_to_host_) {
    board_->run_until(until_ns);
    return;
  }
  line_faults::DelayedLine& to_robot = *delay_to_robot_;
  line_faults::DelayedLine& to_host = *delay_to_host_;
  while (const auto arrival_ns = to_robot.next_arrival_ns()) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    if (*arrival_ns > until_ns) {
      break;
    }
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    board_->run_until(std::max(*arrival_ns, board_->now_ns()));
    const std::vector<std::uint8_t> arrived = to_robot.take_arrived(board_->now_ns());
    if (!is_cut()) {
      board_->receive(arrived);
    }
  }
  board_->run_until(until_ns);
  give_to_host(to_host.take_arrived(until_ns));
}

bool FaultyBoard::is_away() const {
  return is_cut() || line_faults::is_away(faults_, 1e-9 * static_cast<double>(board_->now_ns()));
}

void FaultyBoard::move_plug() {
  if (is_plugged_ == is_away()) {
    is_plugged_ = !is_plugged_;
    board_->plug_line(is_plugged_);
  }
}

void FaultyBoard::receive(std::span<const std::uint8_t> bytes) {
  if (is_away()) {
    return;
  }
  const std::vector<std::uint8_t> passed = to_robot_.pass(bytes);
  if (!delay_to_robot_) {
    board_->receive(passed);
    return;
  }
  for (const std::uint8_t byte : passed) {
    delay_to_robot_->send(byte, board_->now_ns());
  }
}

void FaultyBoard::take_from_board(std::uint8_t byte) {
  if (is_away()) {
    return;
  }
  const std::vector<std::uint8_t> passed = to_host_.pass({&byte, 1});
  if (!delay_to_host_) {
    give_to_host(passed);
    return;
  }
  for (const std::uint8_t passed_byte : passed) {
    delay_to_host_->send(passed_byte, board_->now_ns());
  }
}

void FaultyBoard::give_to_host(std::span<const std::uint8_t> bytes) {
  if (is_cut()) {
    return;
  }
  for (const std::uint8_t byte : bytes) {
    if (on_sent) {
      on_sent(byte);
    }
  }
}

}  // namespace echomap::runner
