// SPDX-License-Identifier: MIT
#include "hil_mock/runner/device_main.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "hil_mock/runner/device_options.hpp"
#include "hil_mock/runner/duty_log.hpp"
#include "hil_mock/runner/faulty_board.hpp"
#include "hil_mock/runner/fix_sender.hpp"
#include "hil_mock/runner/lockstep_run.hpp"
#include "hil_mock/runner/paced_run.hpp"
#include "hil_mock/runner/pin_log.hpp"
#include "hil_mock/runner/pty_endpoint.hpp"
#include "hil_mock/runner/robot_simulation.hpp"
#include "hil_mock/runner/stop_signal.hpp"
#include "hil_mock/runner/tcp_endpoint.hpp"
#include "hil_mock/runner/truth_files.hpp"
#include "hil_mock/world/floor_plan_file.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "host/files/atomic_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::runner {
namespace {

enum ExitCode { kOk = 0, kRuntimeError = 1, kConfigInvalid = 6 };

world::FloorPlan load_plan(const DeviceOptions& options) {
  const auto path = files::bundled_file(options.world, "hil_mock/worlds", "world");
  world::FloorPlan plan = world::read_floor_plan(files::TomlReader::load(path));
  if (options.sources) {
    plan = plan.with_radiation(*options.sources);
  }
  return options.T_world_start ? plan.starting_at(*options.T_world_start) : plan;
}

/// Puts another driver between board and motors.
void fit_driver(world::DriverChip driver, world::DriveParams& drive) {
  drive.driver = driver;
  if (driver == world::DriverChip::kServo) {
    drive.dead_zone_duty = 0.0;
  }
}

/// Whatever does not fit, robot or start, is a fault of the configuration.
std::unique_ptr<world::RobotWorld> load_world(const DeviceOptions& options) {
  const auto path = files::bundled_file(options.robot, "hil_mock/robots", "robot");
  world::RobotParams robot = world::read_robot(files::TomlReader::load(path));
  if (!options.driver.empty()) {
    fit_driver(world::driver_named(options.driver), robot.drive);
  }
  try {
    return std::make_unique<world::RobotWorld>(
        load_plan(options), robot, options.seed, options.part_faults);
  } catch (const std::invalid_argument& fault) {
    throw files::ConfigError(options.robot + " in " + options.world + ": " + fault.what());
  }
}

/// The robot is put down where it could also start.
void schedule_kidnaps(const DeviceOptions& options, RobotSimulation& simulation) {
  const world::RobotWorld& world = simulation.world();
  for (const Kidnap& kidnap : options.kidnaps) {
    const Eigen::Vector2d place_m = kidnap.T_world_robot.position_m();
    if (!world.fits(place_m, 0.0)) {
      throw files::ConfigError("--kidnap: the robot does not fit at " +
                               std::to_string(place_m.x()) + ", " + std::to_string(place_m.y()));
    }
    simulation.schedule(kidnap);
  }
}

std::unique_ptr<ByteEndpoint> open_endpoint(const DeviceOptions& options) {
  const WhenUnread when_unread = options.lockstep.empty() ? WhenUnread::kDrop : WhenUnread::kKeep;
  if (options.tcp_port) {
    return std::make_unique<TcpEndpoint>(*options.tcp_port, when_unread);
  }
  return std::make_unique<PtyEndpoint>(options.link, when_unread);
}

std::int64_t nanoseconds_or_endless(double duration_s) {
  constexpr auto kEndless = std::numeric_limits<std::int64_t>::max();
  return duration_s * 1e9 < static_cast<double>(kEndless) ? std::llround(duration_s * 1e9)
                                                          : kEndless;
}

/// Runs a program's board in its world.
class Device {
 public:
  Device(const DeviceProgram& program, const DeviceOptions& options)
      : name_(program.name),
        options_(options),
        world_(load_world(options)),
        board_(program.make_board(options.board), options.line),
        simulation_(board_, *world_),
        endpoint_(open_endpoint(options)) {
    schedule_kidnaps(options, simulation_);
    if (!options.camera.empty()) {
      put_up_camera();
    }
    if (!options.duty_log.empty()) {
      duty_log_.emplace(options.duty_log);
      simulation_.on_duty = [this](std::int64_t now_ns, const MotorDuty& duty) {
        duty_log_->note(now_ns, duty);
      };
    }
    if (!options.pin_log.empty()) {
      pin_log_.emplace(options.pin_log);
      simulation_.on_driver_inputs = [this](std::int64_t now_ns,
                                            const world::DriverInputs& left,
                                            const world::DriverInputs& right) {
        pin_log_->note(now_ns, left, right);
      };
    }
  }

  void run() {
    write_truth_so_far();
    if (options_.lockstep.empty()) {
      run_paced();
    } else {
      run_in_lockstep();
    }
  }

 private:
  void put_up_camera() {
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

  void run_paced() {
    std::cout << name_ << ": " << world_->robot().name << " in " << world_->plan().name()
              << " listens on " << endpoint_->address() << std::endl;
    runner::run_paced(simulation_,
                      *endpoint_,
                      Pacer(options_.speed, std::chrono::steady_clock::now()),
                      nanoseconds_or_endless(options_.duration_s));
    write_truth(std::nullopt);
  }

  void run_in_lockstep() {
    const nlohmann::ordered_json hello = {{"lockstep", 1},
                                          {"firmware", board_.firmware_name()},
                                          {"emulator", board_.emulator_name()}};
    LockstepServer server(options_.lockstep, hello.dump());
    LockstepRun run(simulation_, *endpoint_, server);
    run.on_box = [this](const PutBox& box, bool stands) { note_box(box, stands); };
    run.on_cut_cable = [this](std::int64_t for_ns) { board_.cut_cable(for_ns); };
    const LockstepEnd end = run.run();
    std::optional<StopReport> stop;
    if (end == LockstepEnd::kHostGone) {
      stop = run.run_without_host();
      std::cerr << name_ << ": " << describe(*stop) << '\n';
    }
    write_truth(stop);
    if (end == LockstepEnd::kQuit) {
      server.send_bye();
    }
  }

  void note_box(const PutBox& box, bool stands) const {
    std::cerr << name_ << ": " << (stands ? "a box" : "there is no place for a box") << " of "
              << box.side_mm << " mm at " << box.x_mm << ", " << box.y_mm << " mm\n";
    if (stands) {
      write_truth_so_far();
    }
  }

  /// For who watches; what cannot be written now may be at the end.
  void write_truth_so_far() const {
    if (options_.truth.empty()) {
      return;
    }
    try {
      runner::write_truth_so_far(options_.truth, simulation_);
    } catch (const files::FileError& error) {
      std::cerr << name_ << ": " << error.what() << '\n';
    }
  }

  void write_truth(const std::optional<StopReport>& stop) const {
    if (!options_.truth.empty()) {
      write_truth_files(
          options_.truth, simulation_, {options_.seed, endpoint_->dropped_bytes(), stop});
    }
  }

  std::string name_;
  DeviceOptions options_;
  std::unique_ptr<world::RobotWorld> world_;
  FaultyBoard board_;
  RobotSimulation simulation_;
  std::unique_ptr<ByteEndpoint> endpoint_;
  std::optional<OverheadCamera> camera_;
  std::unique_ptr<FixSender> fixes_;
  std::optional<DutyLog> duty_log_;
  std::optional<PinLog> pin_log_;
};

}  // namespace

int run_device(int argc, char** argv, const DeviceProgram& program) {
  const auto read = read_device_options(argc, argv, program);
  if (const int* exit_code = std::get_if<int>(&read)) {
    return *exit_code;
  }
  catch_stop_signals();
  try {
    Device(program, std::get<DeviceOptions>(read)).run();
    return kOk;
  } catch (const files::ConfigError& error) {
    std::cerr << program.name << ": " << error.what() << '\n';
    return kConfigInvalid;
  } catch (const std::exception& error) {
    std::cerr << program.name << ": " << error.what() << '\n';
    return kRuntimeError;
  }
}

}  // namespace echomap::runner
