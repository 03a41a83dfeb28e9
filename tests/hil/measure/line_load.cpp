// SPDX-License-Identifier: MIT
#include "tests/hil/measure/line_load.hpp"

#include <cmath>
#include <stdexcept>

namespace echomap::tests {
namespace {

constexpr double kBytesPerS = 115200.0 / 10.0;
/// So small that nine of ten leave the servo as it is: what is measured is line and sonar.
constexpr std::int32_t kFineStepCdeg = 1;
constexpr double kSpeedOfSoundMPerS = 343.0;
/// From the trigger until the sonar raises its echo pin.
constexpr std::int64_t kBurstNs = 460'000;

void require(bool done) {
  if (!done) {
    throw std::runtime_error("the robot does not do what it is asked");
  }
}

}  // namespace

LineLoad::LineLoad(const std::filesystem::path& elf, double wall_m) : robot(elf) {
  const auto flight_ns = static_cast<std::int64_t>(2e9 * wall_m / kSpeedOfSoundMPerS);
  robot.board().on_trigger = [this, flight_ns](std::int64_t at_ns) {
    robot.board().schedule_echo(at_ns + kBurstNs, at_ns + kBurstNs + flight_ns);
  };
  require(robot.connect().has_value());
}

void LineLoad::ask_odometry(std::uint8_t period_ms) {
  const protocol::ConfigureDrive drive{0, 0, 3000, 6000, 20, 30, 300, period_ms};
  require(robot.command(drive) == protocol::CommandStatus::kAccepted);
}

void LineLoad::sweep(std::uint8_t ping_gap_ms, std::int32_t step_cdeg) {
  const protocol::ConfigureSonar sonar{0, 24'000, ping_gap_ms};
  const protocol::StartSweep sweep{0, -9000, 9000, step_cdeg, 0};
  require(robot.command(sonar) == protocol::CommandStatus::kAccepted &&
          robot.command(sweep) == protocol::CommandStatus::kAccepted);
}

double LineLoad::bytes_per_s(int seconds) {
  robot.forget_heard();
  const std::size_t before = robot.bytes().size();
  robot.run_ms(seconds * 1000);
  return double(robot.bytes().size() - before) / seconds;
}

UsualLine measure_usual_line(const std::filesystem::path& elf) {
  constexpr int kSeconds = 8;
  LineLoad line(elf, 4.0);
  line.ask_odometry(10);
  line.sweep(40, kFineStepCdeg);
  line.robot.run_ms(1000);
  UsualLine usual;
  usual.share = line.bytes_per_s(kSeconds) / kBytesPerS;
  usual.odometry_per_s = line.per_s<protocol::Odometry>(kSeconds);
  usual.echoes_per_s = line.per_s<protocol::Echo>(kSeconds);
  usual.status_per_s = line.per_s<protocol::Status>(kSeconds);
  usual.rate_step = line.rate_step();
  usual.dropped = line.dropped();
  return usual;
}

double measure_pings_per_s(const std::filesystem::path& elf) {
  constexpr int kSeconds = 5;
  LineLoad line(elf, 4.0);
  line.sweep(0, kFineStepCdeg);
  line.robot.run_ms(500);
  line.robot.forget_heard();
  line.robot.run_ms(kSeconds * 1000);
  return line.per_s<protocol::Echo>(kSeconds);
}

}  // namespace echomap::tests
