// SPDX-License-Identifier: MIT
#include "hil_mock/runner/device_main.hpp"

#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>

#include "hil_mock/runner/device_options.hpp"
#include "hil_mock/runner/device_world.hpp"
#include "hil_mock/runner/lockstep_run.hpp"
#include "hil_mock/runner/paced_run.hpp"
#include "hil_mock/runner/robot_device.hpp"
#include "hil_mock/runner/robot_team.hpp"
#include "hil_mock/runner/stop_signal.hpp"
#include "hil_mock/runner/truth_files.hpp"
#include "host/files/atomic_file.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::runner {
namespace {

enum ExitCode { kOk = 0, kRuntimeError = 1, kConfigInvalid = 6 };

std::int64_t nanoseconds_or_endless(double duration_s) {
  constexpr auto kEndless = std::numeric_limits<std::int64_t>::max();
  return duration_s * 1e9 < static_cast<double>(kEndless) ? std::llround(duration_s * 1e9)
                                                          : kEndless;
}

std::vector<std::unique_ptr<RobotDevice>> make_robots(const DeviceProgram& program,
                                                      const DeviceOptions& options) {
  const std::vector<geometry::Pose2> starts = device_starts(options);
  std::vector<std::unique_ptr<RobotDevice>> robots;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    DeviceOptions own = options_of_robot(options, i);
    own.T_world_start = starts[i];
    robots.push_back(std::make_unique<RobotDevice>(program, own));
  }
  return robots;
}

std::vector<RobotSimulation*> simulations_of(
    const std::vector<std::unique_ptr<RobotDevice>>& robots) {
  std::vector<RobotSimulation*> simulations;
  for (const auto& robot : robots) {
    simulations.push_back(&robot->simulation());
  }
  return simulations;
}

/// Runs a program's boards in their world.
class Device {
 public:
  Device(const DeviceProgram& program, const DeviceOptions& options)
      : name_(program.name),
        options_(options),
        robots_(make_robots(program, options)),
        team_(simulations_of(robots_)) {}

  void run() {
    write_truth_so_far();
    if (options_.lockstep.empty()) {
      run_paced();
    } else {
      run_in_lockstep();
    }
  }

 private:
  void run_paced() {
    std::vector<ServedRobot> served;
    for (const auto& robot : robots_) {
      std::cout << name_ << ": " << robot->whereabouts() << std::endl;
      served.push_back({&robot->simulation(), &robot->endpoint()});
    }
    runner::run_paced(team_,
                      served,
                      Pacer(options_.speed, std::chrono::steady_clock::now()),
                      nanoseconds_or_endless(options_.duration_s));
    for (const auto& robot : robots_) {
      robot->write_truth(std::nullopt);
    }
  }

  void run_in_lockstep() {
    std::vector<std::unique_ptr<LockstepServer>> servers;
    std::vector<LockstepSeat> seats;
    for (const auto& robot : robots_) {
      servers.push_back(
          std::make_unique<LockstepServer>(robot->options().lockstep, robot->hello()));
      seats.emplace_back(robot->simulation(), robot->endpoint(), *servers.back());
    }
    LockstepRun run(team_, seats);
    run.on_box = [this](std::size_t robot, const PutBox& box, bool stands) {
      note_box(robot, box, stands);
    };
    run.on_cut_cable = [this](std::size_t robot, std::int64_t for_ns) {
      robots_[robot]->board().cut_cable(for_ns);
    };
    run.on_end = [&](std::size_t robot, LockstepEnd end, const std::optional<StopReport>& stop) {
      if (stop) {
        std::cerr << speaker(robot) << describe(*stop) << '\n';
      }
      robots_[robot]->write_truth(stop);
      if (end == LockstepEnd::kQuit) {
        servers[robot]->send_bye();
      }
    };
    run.run();
  }

  /// Who says something on stderr.
  std::string speaker(std::size_t robot) const {
    return name_ + (robots_.size() == 1 ? "" : ": robot " + std::to_string(robot)) + ": ";
  }

  void note_box(std::size_t robot, const PutBox& box, bool stands) const {
    std::cerr << speaker(robot) << (stands ? "a box" : "there is no place for a box") << " of "
              << box.side_mm << " mm at " << box.x_mm << ", " << box.y_mm << " mm\n";
    if (stands) {
      write_truth_so_far();
    }
  }

  /// What cannot be written now may be at the end.
  void write_truth_so_far() const {
    for (const auto& robot : robots_) {
      try {
        robot->write_truth_so_far();
      } catch (const files::FileError& error) {
        std::cerr << name_ << ": " << error.what() << '\n';
      }
    }
  }

  std::string name_;
  DeviceOptions options_;
  std::vector<std::unique_ptr<RobotDevice>> robots_;
  RobotTeam team_;
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
