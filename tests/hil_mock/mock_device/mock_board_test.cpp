// SPDX-License-Identifier: MIT
#include "hil_mock/mock_device/mock_board.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/mock_device/native_session.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::mock_device {
namespace {

world::RobotParams robot_with(world::DriverChip driver) {
  world::RobotParams robot;
  robot.drive.driver = driver;
  return robot;
}

/// The robot of the defaults in a box, also with another motor driver.
class Session : public NativeSession {
 public:
  explicit Session(world::DriverChip driver = world::DriverChip::kPhaseEnable)
      : NativeSession(world::box_room(), robot_with(driver), 3) {}
};

TEST(MockBoard, SaysHelloWithTheSchemaOfTheHost) {
  const Session session;
  EXPECT_EQ(session.heard().hello.schema_digest, protocol::kSchemaDigest);
  EXPECT_EQ(session.heard().hello.session, 7);
}

TEST(MockBoard, AMoveEndsAtItsCountsAndNoneIsLostOnTheWay) {
  Session session;
  session.configure_and_arm();
  session.send(protocol::MoveTicks{4, 2000, 2000, 1500, 200});
  session.keep_alive_ms(3000);
  const auto left = session.world().body().left_wheel().counts();
  const auto right = session.world().body().right_wheel().counts();
  EXPECT_NEAR(static_cast<double>(left), 2000.0, 8.0);
  EXPECT_NEAR(static_cast<double>(right), 2000.0, 8.0);
  EXPECT_EQ(session.heard().odometry.left_ticks, left);
  EXPECT_EQ(session.heard().odometry.right_ticks, right);
  EXPECT_EQ(session.heard().health.encoder_errors, 0);
  EXPECT_EQ(session.heard().status.move_outcome,
            static_cast<std::uint8_t>(protocol::MotionOutcome::kReached));
  EXPECT_NEAR(session.world().T_world_robot().x_m(), 2.0 + 2000.0 / 1496.0 * 0.2042, 0.01);
}

TEST(MockBoard, TellsWhenItsProgramSetsADuty) {
  Session session;
  std::vector<std::int64_t> changed_ns;
  bool was_driven = false;
  session.simulation().on_duty = [&](std::int64_t now_ns, const runner::MotorDuty& duty) {
    const bool is_driven = duty.left != 0.0;
    if (is_driven != was_driven) {
      changed_ns.push_back(now_ns);
    }
    was_driven = is_driven;
  };
  session.configure_and_arm();
  session.send(protocol::MoveTicks{4, 500, 500, 1500, 200});
  session.keep_alive_ms(2000);
  ASSERT_GE(changed_ns.size(), 2U) << "it begins and it ends";
  EXPECT_FALSE(was_driven);
  EXPECT_GT(changed_ns.back() - changed_ns.front(), 300'000'000);
}

TEST(MockBoard, ASweepMeasuresTheWallsOfTheRoom) {
  Session session;
  session.configure_and_arm();
  session.send(protocol::StartSweep{4, -9000, 9000, 9000, 50});
  session.pass_ms(3000);
  ASSERT_EQ(session.heard().echoes.size(), 3U);
  const double expected_m[] = {1.5, 1.97, 1.5};
  for (std::size_t i = 0; i < 3; ++i) {
    const protocol::Echo& echo = session.heard().echoes[i];
    EXPECT_EQ(echo.pan_cdeg, -9000 + 9000 * static_cast<int>(i));
    EXPECT_NEAR(echo.flight_us * 1e-6 * 343.2 / 2.0, expected_m[i], 0.12);
  }
}

TEST(MockBoard, AWallStopsAMoveByItsBumpers) {
  Session session;
  session.configure_and_arm();
  session.send(protocol::MoveTicks{4, 20000, 20000, 2500, 200});
  session.keep_alive_ms(8000);
  EXPECT_EQ(session.heard().status.move_outcome,
            static_cast<std::uint8_t>(protocol::MotionOutcome::kBumped));
  EXPECT_GT(session.world().T_world_robot().x_m(), 3.7);
}

TEST(MockBoard, WithoutKeepAliveTheWheelsStop) {
  Session session;
  session.configure_and_arm();
  session.send(protocol::MoveTicks{4, 20000, 20000, 2500, 200});
  session.pass_ms(200 + 128 + 10);
  EXPECT_EQ(session.heard().status.move_outcome,
            static_cast<std::uint8_t>(protocol::MotionOutcome::kExpired));
  session.pass_ms(300);  // Released, the motors run out by themselves.
  const auto counts = session.world().body().left_wheel().counts();
  session.pass_ms(500);
  EXPECT_EQ(session.world().body().left_wheel().counts(), counts);
}

TEST(MockBoard, ASessionGivesTheSameBytesEveryTime) {
  const auto session_bytes = [] {
    Session session;
    session.configure_and_arm();
    session.send(protocol::MoveTicks{4, 500, -500, 1500, 200});
    session.keep_alive_ms(1500);
    session.send(protocol::StartSweep{5, -3000, 3000, 1000, 30});
    session.pass_ms(1500);
    return session.bytes();
  };
  const auto first = session_bytes();
  EXPECT_GT(first.size(), 1000U);
  EXPECT_EQ(first, session_bytes());
}

/// Begins with a move of so many counts, then does the same for all.
class MovingSession : public Session {
 public:
  explicit MovingSession(std::int16_t counts) {
    configure_and_arm();
    send(protocol::MoveTicks{4, counts, static_cast<std::int16_t>(-counts), 1500, 200});
  }

  void go_on(int step) {
    if (step == 30) {
      send(protocol::StartSweep{5, -3000, 3000, 1000, 30});
    }
    keep_alive_ms(50);
  }
};

std::vector<std::uint8_t> bytes_of_move(std::int16_t counts) {
  MovingSession session(counts);
  for (int step = 0; step < 60; ++step) {
    session.go_on(step);
  }
  return session.bytes();
}

TEST(MockBoard, TwoTakeTurnsAndNeitherNoticesTheOther) {
  MovingSession first(500);
  MovingSession second(-900);
  for (int step = 0; step < 60; ++step) {
    first.go_on(step);
    second.go_on(step);
  }
  EXPECT_GT(first.bytes().size(), 1000U);
  EXPECT_EQ(first.bytes(), bytes_of_move(500));
  EXPECT_EQ(second.bytes(), bytes_of_move(-900));
  EXPECT_NE(first.bytes(), second.bytes());
}

TEST(MockBoard, NamesWhatItIs) {
  const MockBoard board;
  EXPECT_EQ(board.firmware_name().rfind("echomap-native ", 0), 0U);
  EXPECT_EQ(board.emulator_name(), "mock");
}

/// A name, an answer at one address, and what was written.
class Registers final : public world::TwoWireDevice {
 public:
  std::uint8_t address() const override { return 0x68; }
  void write(std::uint8_t device_register, std::uint8_t value) override {
    written = {device_register, value};
  }
  std::uint8_t read(std::uint8_t device_register) override { return device_register; }

  std::pair<int, int> written;
};

TEST(MockBoard, ItsBusReadsAndWritesTheDeviceAtItsAddress) {
  Registers device;
  MockBoard board;
  board.connect(device);
  const native::NativeTwoWire& bus = native::NativeBoard::instance().two_wire;
  EXPECT_EQ(bus.on_read(0x68, 0x47), 0x4748) << "the high byte first";
  EXPECT_EQ(bus.on_read(0x69, 0x47), std::nullopt);
  EXPECT_TRUE(bus.on_write(0x68, 0x6B, 1));
  EXPECT_FALSE(bus.on_write(0x69, 0x6B, 2));
  EXPECT_EQ(device.written, std::pair(0x6B, 1));
}

TEST(MockBoard, ItsConverterCountsTheVoltageOfAPin) {
  MockBoard board;
  native::NativeBoard& native = native::NativeBoard::instance();
  const auto counts = [&](double millivolts) {
    board.set_aux_millivolts(9, millivolts);
    native.start_conversion(9);
    board.run_until(board.now_ns() + 1'000'000);
    std::uint16_t value = 0;
    EXPECT_TRUE(native.conversion_done(value));
    return value;
  };
  EXPECT_EQ(counts(2500.0), 512);
  EXPECT_EQ(counts(0.0), 0);
  EXPECT_EQ(counts(6000.0), 1023);
}

TEST(MockBoard, ANewBoardHasForgottenWhatTheLastOneWasWiredTo) {
  {
    MockBoard board;
    board.set_aux_level(3, false);
  }
  const MockBoard board;
  native::NativeBoard& native = native::NativeBoard::instance();
  native.use_aux_pin(3, hal::PinUse::kDigital);
  EXPECT_EQ(native.aux_levels(), 1U << 3U);
  EXPECT_FALSE(native.two_wire.on_read);
}

TEST(MockBoard, ShowsWhatTheProgramGivesAnOutput) {
  const MockBoard board;
  native::NativeBoard& native = native::NativeBoard::instance();
  native.use_aux_pin(2, hal::PinUse::kOutput);
  EXPECT_FALSE(board.aux_output(2));
  native.set_aux_output(2, true);
  EXPECT_TRUE(board.aux_output(2));
}

protocol::ConfigureWiring wiring_of(world::DriverInterface interface, std::uint8_t options = 0) {
  return {8, static_cast<std::uint8_t>(interface), options, 0};
}

/// What its left motor gets from this driver.
world::MotorDrive left_drive(const Session& session, world::DriverChip chip) {
  const world::MotorDriver driver(chip);
  return driver.drive(session.board().driver_inputs(runner::Wheel::kLeft, driver.interface()));
}

TEST(MockBoard, DrivesTheDriverThatItIsConfiguredForAndNoOther) {
  for (const auto& [chip, other] :
       {std::pair(world::DriverChip::kTb6612fng, world::DriverChip::kDrv8833),
        std::pair(world::DriverChip::kDrv8833, world::DriverChip::kPhaseEnable),
        std::pair(world::DriverChip::kServo, world::DriverChip::kL298n)}) {
    Session session(chip);
    session.send(wiring_of(world::MotorDriver(chip).interface()));
    session.configure_and_arm();
    session.send(protocol::DriveSetpoint{-1500, 1500, 200});
    session.pass_ms(150);
    EXPECT_LT(left_drive(session, chip).duty, -0.1) << world::name_of(chip);
    EXPECT_EQ(left_drive(session, other).duty, 0.0) << world::name_of(chip);
  }
}

/// Also with those that let go of the motor in the pauses of their PWM, which makes it faster at
/// the same duty.
TEST(MockBoard, ItsWheelsKeepTheirSpeedWithEveryKindOfDriver) {
  for (const auto chip : {world::DriverChip::kPhaseEnable,
                          world::DriverChip::kTb6612fng,
                          world::DriverChip::kL298n,
                          world::DriverChip::kDrv8833,
                          world::DriverChip::kServo}) {
    for (const int ticks_per_s : {300, -300, 1800, -1800}) {
      Session session(chip);
      session.send(wiring_of(world::MotorDriver(chip).interface()));
      session.configure_and_arm();
      const auto speed = static_cast<std::int16_t>(ticks_per_s);
      session.send(protocol::DriveSetpoint{speed, static_cast<std::int16_t>(-speed), 200});
      session.keep_alive_ms(700);
      const auto before = session.world().body().left_wheel().counts();
      session.keep_alive_ms(1000);
      const auto counts = session.world().body().left_wheel().counts() - before;
      EXPECT_NEAR(static_cast<double>(counts), ticks_per_s, 0.02 * std::abs(ticks_per_s))
          << world::name_of(chip);
    }
  }
}

TEST(MockBoard, ItsPwmIsSlowWhereTheDriverNeedsIt) {
  for (const bool is_slow : {false, true}) {
    Session session(world::DriverChip::kL293d);
    session.send(wiring_of(world::DriverInterface::kIn1In2Pwm, is_slow ? protocol::kSlowPwm : 0));
    session.configure_and_arm();
    session.send(protocol::DriveSetpoint{1500, 1500, 200});
    session.pass_ms(150);
    EXPECT_EQ(left_drive(session, world::DriverChip::kL293d).duty > 0.0, is_slow);
  }
}

TEST(MockBoard, AMotorAtRestIsBrakedWhereTheWiringSaysSo) {
  for (const bool brakes : {false, true}) {
    Session session(world::DriverChip::kTb6612fng);
    const std::uint8_t options = brakes ? protocol::kBrakeAtZero : 0;
    session.send(wiring_of(world::DriverInterface::kIn1In2Pwm, options));
    session.configure_and_arm();
    session.send(protocol::MoveTicks{4, 500, 500, 1500, 200});
    session.keep_alive_ms(2000);
    EXPECT_EQ(left_drive(session, world::DriverChip::kTb6612fng).coasting, brakes ? 0.0 : 1.0);
  }
}

}  // namespace
}  // namespace echomap::mock_device
