// SPDX-License-Identifier: MIT
#include "tests/sessions/simulated_session.hpp"

#include <algorithm>
#include <array>

#include "hil_mock/world/floor_plan_file.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::tests {
namespace {

constexpr std::int64_t kStepNs = 5'000'000;
constexpr const char* kRobot = "uno_2wd";

files::TomlReader bundled(const std::string& name, const char* folder) {
  return files::TomlReader::load(files::bundled_file(name, folder, "file"));
}

}  // namespace

class SimulatedSession::Stream final : public transport::ByteStream {
 public:
  explicit Stream(SimulatedSession& owner) : owner_(owner) {}

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds /*wait*/) override {
    const std::size_t count = std::min(into.size(), owner_.to_host_.size());
    const auto end = owner_.to_host_.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(owner_.to_host_.begin(), end, into.begin());
    owner_.to_host_.erase(owner_.to_host_.begin(), end);
    return count;
  }
  void write(std::span<const std::uint8_t> bytes) override {
    if (passes()) {
      owner_.simulation_.receive(bytes);
    }
  }
  transport::StreamStatus status() const override {
    return owner_.cable_.plugged ? transport::StreamStatus::kOpen : transport::StreamStatus::kAway;
  }
  std::string close_reason() const override { return owner_.cable_.plugged ? "" : "pulled out"; }
  std::string name() const override { return "cable"; }

  bool passes() const { return owner_.cable_.plugged && !owner_.cable_.boot_loader; }

 private:
  SimulatedSession& owner_;
};

class SimulatedSession::Pace final : public session::Pace {
 public:
  explicit Pace(SimulatedSession& owner) : owner_(owner) {}

  time::HostTime step(transport::ByteStream& stream,
                      std::uint64_t /*bytes_sent*/,
                      const Receive& receive) override {
    if (owner_.each_step) {
      owner_.each_step();
    }
    owner_.simulation_.advance_to(owner_.simulation_.now_ns() + kStepNs);
    const std::vector<std::uint8_t> sent = owner_.simulation_.take_sent();
    if (static_cast<Stream&>(stream).passes()) {
      owner_.to_host_.insert(owner_.to_host_.end(), sent.begin(), sent.end());
    }
    std::array<std::uint8_t, 4096> buffer{};
    receive(std::span(buffer).first(stream.read_some(buffer, std::chrono::microseconds(0))));
    return time::HostTime(std::chrono::microseconds(owner_.simulation_.now_ns() / 1000));
  }

 private:
  SimulatedSession& owner_;
};

SimulatedSession::SimulatedSession(runner::SimulatedBoard& board,
                                   const std::string& world,
                                   std::uint32_t seed)
    : world_(world::read_floor_plan(bundled(world, "hil_mock/worlds")),
             world::read_robot(bundled(kRobot, "hil_mock/robots")),
             seed),
      simulation_(board, world_),
      T_world_start_(world_.T_world_robot()),
      pipeline_(session::load_robot_profile(kRobot).geometry) {
  session::RobotConnection connection;
  connection.stream = std::make_unique<Stream>(*this);
  connection.pace = std::make_unique<Pace>(*this);
  connection.session_id = 4711;
  connection.patience = std::chrono::seconds(10);
  session_ = std::make_unique<session::RobotSession>(
      std::move(connection), session::load_robot_profile(kRobot), pipeline_);
}

SimulatedSession::~SimulatedSession() = default;

double SimulatedSession::position_error_m() const {
  const geometry::Pose2 truth = T_world_start_.inverse() * world_.T_world_robot();
  return (truth.position_m() - pipeline_.snapshot().latest.T_map_robot.position_m()).norm();
}

}  // namespace echomap::tests
