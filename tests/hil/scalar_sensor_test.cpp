// SPDX-License-Identifier: MIT
/// The scalar sensor on a spare pin of every board: pulses one by one, and a voltage's mean.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil/measure/loaded_robot.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

/// Spare pins of each board, as its page has them.
struct ScalarPins {
  unsigned pins;
  std::vector<unsigned> pulses;
  std::vector<unsigned> level;
  double supply_mv;
};

std::vector<unsigned> from_to(unsigned first, unsigned last) {
  std::vector<unsigned> numbers;
  for (unsigned number = first; number <= last; ++number) {
    numbers.push_back(number);
  }
  return numbers;
}

const ScalarPins& pins_of(const std::string& board) {
  static const std::map<std::string, ScalarPins> boards{
      {"uno", {7, from_to(0, 2), from_to(3, 6), 5000.0}},
      {"mega", {16, from_to(8, 15), from_to(8, 15), 5000.0}},
      {"stm32f103", {14, from_to(0, 13), from_to(0, 7), 3300.0}},
      {"pico", {11, from_to(0, 10), from_to(4, 6), 3300.0}}};
  return boards.at(board);
}

/// Gives the pin with this number a function; a visitor of the message's fields.
struct SetPin {
  std::string name;
  std::uint8_t function;
  void operator()(const char* field, std::uint8_t& pin) const {
    pin = field == name ? function : pin;
  }
};

protocol::ConfigurePins settings_of(unsigned number, std::uint8_t function) {
  protocol::ConfigurePins pins{};
  const SetPin set{"pin_" + std::to_string(number), function};
  protocol::ConfigurePins::each(pins, set);
  return pins;
}

bool is_among(unsigned number, const std::vector<unsigned>& numbers) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

/// Pulses by chance, as a tube's: exponential gaps and a dead time.
class PulseTrain {
 public:
  static constexpr std::int64_t kPulseNs = 100'000;
  static constexpr std::int64_t kDeadNs = 160'000;

  PulseTrain(runner::SimulatedBoard& board, unsigned pin, double per_s, std::uint32_t seed = 1)
      : board_(board), pin_(pin), mean_gap_ns_(1e9 / per_s), random_(seed) {
    board_.set_aux_level(pin_, true);
    next_ns_ = board_.now_ns() + kDeadNs;
  }

  /// Schedules those of the next millisecond.
  void run_ms() {
    for (; next_ns_ < board_.now_ns() + 1'000'000; ++count_) {
      board_.schedule_aux_pulse(pin_, next_ns_, next_ns_ + kPulseNs);
      const double share = (double(random_()) + 0.5) / 4294967296.0;
      next_ns_ += kDeadNs + static_cast<std::int64_t>(-mean_gap_ns_ * std::log(share));
    }
  }

  std::uint32_t count() const { return count_; }

 private:
  runner::SimulatedBoard& board_;
  unsigned pin_;
  double mean_gap_ns_;
  std::mt19937 random_;
  std::int64_t next_ns_ = 0;
  std::uint32_t count_ = 0;
};

class ScalarSensor : public OnEveryBoard {
 protected:
  const ScalarPins& pins() { return pins_of(robot.board().board_name()); }
  void use(unsigned pin, std::uint8_t function, std::uint16_t period_ms) {
    ASSERT_TRUE(robot.connect());
    ASSERT_EQ(robot.command(settings_of(pin, function)), CommandStatus::kAccepted);
    ASSERT_EQ(robot.command(protocol::ConfigureScalar{0, period_ms}), CommandStatus::kAccepted);
  }
  /// What comes within this time, and a little longer, so that the last has come.
  protocol::Scalar after_ms(std::int64_t ms) {
    robot.run_ms(ms);
    robot.each_ms = nullptr;
    robot.forget_heard();
    robot.run_ms(60);
    return robot.last<protocol::Scalar>().value();
  }
};

INSTANTIATE_TEST_SUITE_P(Boards, ScalarSensor, every_board(), image_label);

TEST_P(ScalarSensor, EachPinCanBeWhatItsPageSays) {
  const auto reply = robot.connect();
  ASSERT_TRUE(reply);
  EXPECT_TRUE((reply->capabilities & protocol::kCapabilityScalar) != 0);
  for (unsigned pin = 0; pin < 16; ++pin) {
    const bool pulses = is_among(pin, pins().pulses);
    const bool level = is_among(pin, pins().level);
    EXPECT_EQ(robot.command(settings_of(pin, protocol::kPinScalarPulses)),
              pulses ? CommandStatus::kAccepted : CommandStatus::kOutOfRange)
        << pin;
    EXPECT_EQ(robot.command(settings_of(pin, protocol::kPinScalarLevel)),
              level ? CommandStatus::kAccepted : CommandStatus::kOutOfRange)
        << pin;
  }
}

TEST_P(ScalarSensor, EveryPinThatCanCountsAThousandPulsesASecondOneByOne) {
  for (const unsigned pin : pins().pulses) {
    use(pin, protocol::kPinScalarPulses, 50);
    const std::uint32_t before = after_ms(0).sum;
    PulseTrain train(robot.board(), pin, 1200.0, pin);
    robot.each_ms = [&] { train.run_ms(); };
    const protocol::Scalar last = after_ms(500);
    EXPECT_GT(train.count(), 400U) << "1007 a second in the mean";
    EXPECT_EQ(last.sum - before, train.count()) << "pin " << pin;
    EXPECT_EQ(last.samples, 0) << "of a voltage only";
    robot.board().set_aux_level(pin, true);
  }
}

/// hal/pulses.hpp promises them.
TEST_P(ScalarSensor, CountsPulsesAndGapsOfFiftyMicroseconds) {
  const unsigned pin = pins().pulses.at(0);
  robot.board().set_aux_level(pin, true);
  use(pin, protocol::kPinScalarPulses, 20);
  constexpr int kPulses = 1000;
  constexpr std::int64_t kMinLengthNs = 50'000;
  const std::int64_t begin_ns = robot.board().now_ns() + kMinLengthNs;
  for (int i = 0; i < kPulses; ++i) {
    const std::int64_t fall_ns = begin_ns + 2 * i * kMinLengthNs;
    robot.board().schedule_aux_pulse(pin, fall_ns, fall_ns + kMinLengthNs);
  }
  EXPECT_EQ(after_ms(2 * kPulses * kMinLengthNs / 1'000'000 + 1).sum, unsigned{kPulses});
}

TEST_P(ScalarSensor, OtherPinsAndAPulseThatIsUnderWayDoNotCount) {
  const unsigned pin = pins().pulses.at(0);
  const unsigned other = pins().pulses.at(1);
  robot.board().set_aux_level(other, true);
  robot.board().set_aux_level(pin, false);
  use(pin, protocol::kPinScalarPulses, 20);
  robot.board().set_aux_level(pin, true);
  robot.run_ms(1);
  robot.board().schedule_aux_pulse(other, robot.board().now_ns(), robot.board().now_ns() + 100'000);
  EXPECT_EQ(after_ms(10).sum, 0U);
  robot.board().schedule_aux_pulse(pin, robot.board().now_ns(), robot.board().now_ns() + 100'000);
  EXPECT_EQ(after_ms(10).sum, 1U);
  ASSERT_EQ(robot.command(protocol::ConfigurePins{}), CommandStatus::kAccepted);
  robot.board().schedule_aux_pulse(pin, robot.board().now_ns(), robot.board().now_ns() + 100'000);
  EXPECT_EQ(after_ms(10).sum, 1U) << "the pin is no sensor any more";
}

TEST_P(ScalarSensor, VoltageIsTheMeanOfItsConversions) {
  const unsigned pin = pins().level.back();
  const double low_mv = 0.25 * pins().supply_mv;
  const double high_mv = 0.75 * pins().supply_mv;
  use(pin, protocol::kPinScalarLevel, 50);
  int ms = 0;
  robot.each_ms = [&] { robot.board().set_aux_millivolts(pin, ++ms % 10 < 3 ? high_mv : low_mv); };
  robot.run_ms(100);
  robot.forget_heard();
  robot.run_ms(2000);
  const auto told = robot.all<protocol::Scalar>();
  ASSERT_GT(told.size(), 30U);
  const auto samples = static_cast<std::uint16_t>(told.back().samples - told.front().samples);
  const double passed_ms = 1e-3 * (told.back().stamp_us - told.front().stamp_us);
  EXPECT_NEAR(samples, passed_ms, 2.0) << "one each millisecond";
  const double mean = double(told.back().sum - told.front().sum) / samples;
  EXPECT_NEAR(mean, (0.3 * 0.75 + 0.7 * 0.25) * 1024.0, 2.0);
}

TEST_P(ScalarSensor, ComesAtItsPeriodUntilItIsSwitchedOff) {
  use(pins().pulses.at(0), protocol::kPinScalarPulses, 100);
  robot.run_ms(50);
  robot.forget_heard();
  robot.run_ms(1000);
  EXPECT_EQ(robot.all<protocol::Scalar>().size(), 10U);
  ASSERT_EQ(robot.command(protocol::ConfigureScalar{0, 0}), CommandStatus::kAccepted);
  robot.forget_heard();
  robot.run_ms(500);
  EXPECT_TRUE(robot.all<protocol::Scalar>().empty());
}

class PulsesUnderLoad : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Boards, PulsesUnderLoad, every_board(), image_label);

/// Beside 20,000 edges a second and wheel, pings and a full line.
TEST_P(PulsesUnderLoad, PulsesAndEncodersDoNotHurtEachOther) {
  LoadedRobot robot(release_image(GetParam()), {.edges_per_s = 20'000});
  robot.connect();
  RobotSession& session = robot.session();
  const unsigned pin = pins_of(session.board().board_name()).pulses.back();
  ASSERT_EQ(session.command(settings_of(pin, protocol::kPinScalarPulses)),
            CommandStatus::kAccepted);
  ASSERT_EQ(session.command(protocol::ConfigureScalar{0, 100}), CommandStatus::kAccepted);
  PulseTrain train(session.board(), pin, 1200.0);
  bool is_on = true;
  std::uint32_t sum = 0;
  session.each_ms = [&] {
    if (is_on) {
      train.run_ms();
    }
    if (const auto last = session.last<protocol::Scalar>()) {
      sum = last->sum;
    }
  };
  robot.run_s(10.0);
  is_on = false;
  robot.run_s(0.5);
  const LoadResult result = robot.finish();
  std::printf("%s: %u pulses of %u, miscounts %d, echo within %.2f us, stack %d B\n",
              GetParam(),
              sum,
              train.count(),
              static_cast<int>(result.miscounts),
              result.worst_echo_error_us,
              result.min_stack_bytes);
  EXPECT_GT(train.count(), 9'500U) << "1007 a second in the mean";
  EXPECT_EQ(sum, train.count());
  EXPECT_EQ(result.miscounts, 0);
  EXPECT_EQ(result.encoder_errors, 0);
  EXPECT_EQ(result.receive_overruns, 0);
  EXPECT_EQ(result.frames_bad, 0);
  EXPECT_EQ(result.frames_lost, 0);
  EXPECT_LE(result.worst_echo_error_us, 1.0);
  EXPECT_GE(result.min_stack_bytes, 300);
}

}  // namespace
}  // namespace echomap::tests
