// SPDX-License-Identifier: MIT
#include "tests/hil_mock/mock_device/lossy_commands.hpp"

#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "hil_mock/runner/faulty_board.hpp"
#include "host/robot_link/robot_link.hpp"

namespace echomap::mock_device {
namespace {

using robot_link::CommandOutcome;

constexpr std::int64_t kStepNs = 5'000'000;

/// Whole degrees from -30 to 30 and back: two neighbours are never alike.
std::int16_t angle_deg(int number) {
  return static_cast<std::int16_t>(std::abs(number % 120 - 60) - 30);
}

/// As the firmware has it by default.
double pulse_us(int number) { return 1500.0 + 10.0 * angle_deg(number); }

/// Pulses of neighbours are 10 us apart; a board's model may compute them with rounding.
bool is_pulse_of(int number, double measured_us) {
  constexpr double kRoundingUs = 1e-6;
  return std::abs(measured_us - pulse_us(number)) < kRoundingUs;
}

protocol::StartSweep single_ping(int number) {
  const auto angle_cdeg = static_cast<std::int16_t>(100 * angle_deg(number));
  return {0, angle_cdeg, angle_cdeg, 100, 0};
}

class LossySession : private robot_link::RobotLinkListener {
 public:
  LossySession(std::unique_ptr<runner::SimulatedBoard> board, double loss)
      : board_(std::move(board), {.faults = {.rates = {}, .loss = loss, .seed = 5}}),
        link_(*this, 0x0CE5) {
    board_.on_sent = [this](std::uint8_t byte) { to_host_.push_back(byte); };
    board_.on_trigger = [this](std::int64_t at_ns) { ping(at_ns); };
  }

  CommandOutcome perform(const robot_link::Command& command) {
    result_.reset();
    link_.submit(command);
    while (!result_) {
      step();
    }
    return result_->outcome;
  }

  /// Performs a sweep and waits until the robot says that it is over.
  CommandOutcome sweep(const protocol::StartSweep& command) {
    const CommandOutcome outcome = perform(command);
    while (outcome == CommandOutcome::kAccepted && swept_id_ != result_->command_id) {
      step();
    }
    return outcome;
  }

  /// Lets what is still on its way have its effect.
  void wait_a_second() {
    for (int i = 0; i < 200; ++i) {
      step();
    }
  }

  const std::vector<double>& pulses_us() const { return pulses_us_; }
  robot_link::LinkStatistics statistics() const { return link_.statistics(); }
  std::uint16_t session_breaks() const { return session_breaks_; }

 private:
  void on_odometry(const protocol::Odometry& /*message*/) override {}
  void on_echo(const protocol::Echo& /*message*/) override {}
  void on_status(const protocol::Status& message) override {
    const bool reached =
        message.sweep_outcome == static_cast<std::uint8_t>(protocol::MotionOutcome::kReached);
    swept_id_ = reached ? message.sweep_id : std::uint8_t{0};
  }
  void on_ready(const protocol::HelloReply& /*reply*/) override { ++session_breaks_; }
  void on_reset(std::uint8_t /*cause*/) override { ++session_breaks_; }
  void on_command_done(const robot_link::CommandResult& result) override { result_ = result; }

  void step() {
    const time::HostTime now(std::chrono::microseconds(board_.now_ns() / 1000));
    link_.receive(to_host_, now);
    to_host_.clear();
    link_.poll(now);
    board_.receive(link_.take_outgoing());
    board_.run_until(board_.now_ns() + kStepNs);
  }

  void ping(std::int64_t at_ns) {
    pulses_us_.push_back(board_.pan_pulse_us());
    board_.schedule_echo(at_ns + 460'000, at_ns + 3'000'000);
  }

  runner::FaultyBoard board_;
  robot_link::RobotLink link_;
  std::vector<std::uint8_t> to_host_;
  std::vector<double> pulses_us_;
  std::optional<robot_link::CommandResult> result_;
  std::uint8_t swept_id_ = 0;
  std::uint16_t session_breaks_ = 0;
};

}  // namespace

LossyCommands measure_commands(std::unique_ptr<runner::SimulatedBoard> board,
                               int commands,
                               double loss) {
  LossySession session(std::move(board), loss);
  session.perform(protocol::ConfigureSonar{0, 25000, 30});
  LossyCommands result;
  for (int number = 0; number < commands; ++number) {
    const std::size_t before = session.pulses_us().size();
    result.accepted += session.sweep(single_ping(number)) == CommandOutcome::kAccepted ? 1 : 0;
    const bool once =
        session.pulses_us().size() == before + 1 && is_pulse_of(number, session.pulses_us().back());
    result.exactly_once += once ? 1 : 0;
  }
  const std::size_t pings = session.pulses_us().size();
  session.wait_a_second();
  if (session.pulses_us().size() != pings) {
    result.exactly_once = 0;
  }
  result.sessions = session.session_breaks();
  result.statistics = session.statistics();
  return result;
}

}  // namespace echomap::mock_device
