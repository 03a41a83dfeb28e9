// SPDX-License-Identifier: MIT
#include "hil_mock/runner/robot_device.hpp"

#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "hil_mock/runner/device_world.hpp"
#include "hil_mock/runner/pty_endpoint.hpp"
#include "hil_mock/runner/tcp_endpoint.hpp"
#include "hil_mock/runner/truth_files.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::runner {
namespace {

std::unique_ptr<ByteEndpoint> open_endpoint(const DeviceOptions& options) {
  const WhenUnread when_unread = options.lockstep.empty() ? WhenUnread::kDrop : WhenUnread::kKeep;
  if (options.tcp_port) {
    return std::make_unique<TcpEndpoint>(*options.tcp_port, when_unread);
  }
  return std::make_unique<PtyEndpoint>(options.link, when_unread);
}

}  // namespace

RobotDevice::RobotDevice(const DeviceProgram& program, DeviceOptions options)
    : options_(std::move(options)),
      world_(load_world(options_)),
      board_(program.make_board(options_.board), options_.line),
      simulation_(board_, *world_),
      endpoint_(open_endpoint(options_)) {
  schedule_kidnaps();
  if (!options_.camera.empty()) {
    put_up_camera();
  }
  open_logs();
}

std::string RobotDevice::hello() const {
  return nlohmann::ordered_json{
      {"lockstep", 1}, {"firmware", board_.firmware_name()}, {"emulator", board_.emulator_name()}}
      .dump();
}

std::string RobotDevice::whereabouts() const {
  return world_->robot().name + " in " + world_->plan().name() + " listens on " +
         endpoint_->address();
}

void RobotDevice::write_truth_so_far() const {
  if (!options_.truth.empty()) {
    runner::write_truth_so_far(options_.truth, simulation_);
  }
}

void RobotDevice::write_truth(const std::optional<StopReport>& stop) const {
  if (!options_.truth.empty()) {
    write_truth_files(
        options_.truth, simulation_, {options_.seed, endpoint_->dropped_bytes(), stop});
  }
}

/// The robot is put down where it could also start.
void RobotDevice::schedule_kidnaps() {
  for (const Kidnap& kidnap : options_.kidnaps) {
    const Eigen::Vector2d place_m = kidnap.T_world_robot.position_m();
    if (!world_->fits(place_m, 0.0)) {
      throw files::ConfigError("--kidnap: the robot does not fit at " +
                               std::to_string(place_m.x()) + ", " + std::to_string(place_m.y()));
    }
    simulation_.schedule(kidnap);
  }
}

void RobotDevice::put_up_camera() {
  camera_.emplace(options_.camera_params, options_.seed);
  try {
    fixes_ = make_fix_sender(options_.camera);
  } catch (const std::invalid_argument& fault) {
    throw files::ConfigError("--camera " + std::string(fault.what()));
  }
  simulation_.on_step = [this] {
    for (const std::string& line : camera_->look(simulation_.now_ns(), world_->T_world_robot())) {
      fixes_->send(line);
    }
  };
}

void RobotDevice::open_logs() {
  if (!options_.duty_log.empty()) {
    duty_log_.emplace(options_.duty_log);
    simulation_.on_duty = [this](std::int64_t now_ns, const MotorDuty& duty) {
      duty_log_->note(now_ns, duty);
    };
  }
  if (!options_.pin_log.empty()) {
    pin_log_.emplace(options_.pin_log);
    simulation_.on_driver_inputs = [this](std::int64_t now_ns,
                                          const world::DriverInputs& left,
                                          const world::DriverInputs& right) {
      pin_log_->note(now_ns, left, right);
    };
  }
}

}  // namespace echomap::runner
