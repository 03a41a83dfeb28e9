// SPDX-License-Identifier: MIT
#include "hil_mock/mock_device/mock_board.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/runner/robot_simulation.hpp"
#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::mock_device {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// Keeps the latest message of each kind that a test looks at.
struct Heard {
  protocol::HelloReply hello{};
  protocol::Odometry odometry{};
  protocol::Status status{};
  protocol::Health health{};
  std::vector<protocol::Ack> acks;
  std::vector<protocol::Echo> echoes;

  void operator()(const protocol::HelloReply& message) { hello = message; }
  void operator()(const protocol::Odometry& message) { odometry = message; }
  void operator()(const protocol::Status& message) { status = message; }
  void operator()(const protocol::Health& message) { health = message; }
  void operator()(const protocol::Ack& message) { acks.push_back(message); }
  void operator()(const protocol::Echo& message) { echoes.push_back(message); }
  template <class Other>
  void operator()(const Other&) {}
};

/// The native firmware in a box room, and a host that speaks to it.
class Session {
 public:
  Session() { send(protocol::Hello{1, 0, protocol::kSchemaDigest, 7}); }

  template <class M>
  void send(const M& message) {
    const protocol::ByteSpan frame = encoder_.encode(message, seq_++);
    simulation_.receive({frame.data, frame.size});
    pass_ms(20);
  }

  /// Lets time pass and the robot live, as a host does every 50 ms.
  void pass_ms(int duration_ms) {
    simulation_.advance_to(simulation_.now_ns() + duration_ms * kMs);
    for (const std::uint8_t byte : simulation_.take_sent()) {
      bytes_.push_back(byte);
      if (decoder_.take(byte) == protocol::DecodeStatus::kFrame) {
        const protocol::Frame frame = decoder_.frame();
        protocol::Dispatcher<protocol::MessagesToHost>::dispatch(frame.id, frame.payload, heard_);
      }
    }
  }

  void keep_alive_ms(int duration_ms) {
    for (int passed_ms = 0; passed_ms < duration_ms; passed_ms += 50) {
      send(protocol::KeepAlive{200});
      pass_ms(30);
    }
  }

  void configure_and_arm() {
    send(protocol::ConfigureDrive{1, 0, 3000, 4400, 20, 12, 200, 20});
    send(protocol::ConfigureSonar{2, 25000, 30});
    send(protocol::Arm{3, 1});
  }

  const Heard& heard() const { return heard_; }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  const world::RobotWorld& world() const { return world_; }

 private:
  MockBoard board_;
  world::RobotWorld world_{world::box_room(), {}, 3};
  runner::RobotSimulation simulation_{board_, world_};
  protocol::FrameEncoder encoder_;
  protocol::FrameDecoder decoder_{protocol::MessagesToHost::find_schema};
  std::uint8_t seq_ = 0;
  Heard heard_;
  std::vector<std::uint8_t> bytes_;
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

TEST(MockBoard, NamesWhatItIs) {
  const MockBoard board;
  EXPECT_EQ(board.firmware_name().rfind("echomap-native ", 0), 0U);
  EXPECT_EQ(board.emulator_name(), "mock");
}

}  // namespace
}  // namespace echomap::mock_device
