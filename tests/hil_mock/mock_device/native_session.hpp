// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hil_mock/mock_device/mock_board.hpp"
#include "hil_mock/runner/robot_simulation.hpp"
#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"

namespace echomap::mock_device {

/// Keeps the latest message of each kind that a test looks at.
struct Heard {
  protocol::HelloReply hello{};
  protocol::Odometry odometry{};
  protocol::Status status{};
  protocol::Health health{};
  protocol::Ranges ranges{};
  protocol::Gyro gyro{};
  protocol::Scalar scalar{};
  std::vector<protocol::Ack> acks;
  std::vector<protocol::Echo> echoes;

  void operator()(const protocol::HelloReply& message) { hello = message; }
  void operator()(const protocol::Odometry& message) { odometry = message; }
  void operator()(const protocol::Status& message) { status = message; }
  void operator()(const protocol::Health& message) { health = message; }
  void operator()(const protocol::Ranges& message) { ranges = message; }
  void operator()(const protocol::Gyro& message) { gyro = message; }
  void operator()(const protocol::Scalar& message) { scalar = message; }
  void operator()(const protocol::Ack& message) { acks.push_back(message); }
  void operator()(const protocol::Echo& message) { echoes.push_back(message); }
  template <class Other>
  void operator()(const Other&) {}
};

/// The native firmware on a robot in a room, and a host that speaks to it.
class NativeSession {
 public:
  NativeSession(world::FloorPlan plan, const world::RobotParams& robot, std::uint32_t seed)
      : world_(std::move(plan), robot, seed) {
    send(protocol::Hello{1, 0, protocol::kSchemaDigest, 7});
  }

  template <class M>
  void send(const M& message) {
    const protocol::ByteSpan frame = encoder_.encode(message, seq_++);
    simulation_.receive({frame.data, frame.size});
    pass_ms(20);
  }

  /// Lets time pass and the robot live.
  void pass_ms(int duration_ms) {
    simulation_.advance_to(simulation_.now_ns() + duration_ms * std::int64_t{1'000'000});
    for (const std::uint8_t byte : simulation_.take_sent()) {
      bytes_.push_back(byte);
      if (decoder_.take(byte) == protocol::DecodeStatus::kFrame) {
        const protocol::Frame frame = decoder_.frame();
        protocol::Dispatcher<protocol::MessagesToHost>::dispatch(frame.id, frame.payload, heard_);
      }
    }
  }

  /// The same with a sign of life from the host every 50 ms.
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
  runner::RobotSimulation& simulation() { return simulation_; }
  const runner::SimulatedBoard& board() const { return board_; }

 private:
  MockBoard board_;
  world::RobotWorld world_;
  runner::RobotSimulation simulation_{board_, world_};
  protocol::FrameEncoder encoder_;
  protocol::FrameDecoder decoder_{protocol::MessagesToHost::find_schema};
  std::uint8_t seq_ = 0;
  Heard heard_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace echomap::mock_device
