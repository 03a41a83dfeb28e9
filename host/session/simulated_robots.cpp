// SPDX-License-Identifier: MIT
#include "host/session/simulated_robots.hpp"

#include <chrono>
#include <thread>
#include <vector>

#include "host/boards/boards.hpp"
#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::session {
namespace {

using console::CommandError;
using console::ExitCode;

namespace fs = std::filesystem;

std::string program_of(const SimulatedRobotOptions& options) {
  const fs::path program = program_folder() / ("echomap-" + options.emulator);
  if (!fs::exists(program)) {
    throw CommandError(ExitCode::kRuntimeError,
                       program.string() +
                           " was not built: a dependency is missing on this machine\n  next: " +
                           boards::way_to_build(options.emulator, options.board) +
                           (options.emulator == "mock" ? "" : ", or --emulator mock"));
  }
  return program;
}

/// What a program that has ended says of itself, without its name before and blank lines behind.
std::string said_in(const fs::path& log) {
  const std::string text = files::read_text_file(log);
  const std::size_t end = text.find_last_not_of('\n');
  const std::string said = end == std::string::npos ? "" : text.substr(0, end + 1);
  const std::size_t colon = said.find(": ");
  const bool is_named = said.starts_with("echomap-") && said.find(' ') == colon + 1;
  return is_named ? said.substr(colon + 2) : said;
}

/// What only some of the options need.
std::vector<std::string> optional_arguments(const SimulatedRobotOptions& options) {
  std::vector<std::string> arguments;
  const auto add = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) {
      arguments.push_back(name + value);
    }
  };
  add("--faults=", options.faults);
  add("--part-faults=", options.part_faults);
  for (const std::string& source : options.sources) {
    add("--source=", source);
  }
  add("--camera=udp:",
      options.fixes.empty() ? "" : options.fixes.substr(options.fixes.rfind(':') + 1));
  add("--camera-params=", options.camera_params);
  add("--board=", options.board);
  add("--driver=", options.driver);
  add("--robots=", options.robots == 1 ? "" : std::to_string(options.robots));
  add("--starts=", options.starts);
  add("--apart=", options.apart_m ? std::to_string(*options.apart_m) : "");
  return arguments;
}

}  // namespace

SimulatedRobots::SimulatedRobots(const SimulatedRobotOptions& options,
                                 const Seed& seed,
                                 const fs::path& body,
                                 const fs::path& out)
    : robots_(options.robots),
      is_radio_(options.line == "bluetooth"),
      truth_(out / "truth"),
      log_(out / "robot.log") {
  fs::create_directories(truth_);
  std::vector<std::string> command{program_of(options),
                                   "--world=" + options.world,
                                   "--robot=" + body.string(),
                                   "--seed=" + std::to_string(seed.number()),
                                   "--link=" + (folder_ / "robot").string(),
                                   "--lockstep=" + (folder_ / "lockstep").string(),
                                   "--truth=" + truth_.string(),
                                   "--line=" + options.line};
  const std::vector<std::string> more = optional_arguments(options);
  command.insert(command.end(), more.begin(), more.end());
  process_ = std::make_unique<ChildProcess>(command, log_);
  wait_until_they_listen();
}

ConnectionOptions SimulatedRobots::connection(std::size_t robot) const {
  ConnectionOptions options;
  options.ports = {port(robot)};
  options.lockstep = socket(robot);
  options.is_radio = is_radio_;
  return options;
}

fs::path SimulatedRobots::truth(std::size_t robot) const {
  return robots_ == 1 ? truth_ : truth_ / ("robot" + std::to_string(robot));
}

/// One alone has names without a number.
std::string SimulatedRobots::end_of(std::size_t robot) const {
  return robots_ == 1 ? "" : "." + std::to_string(robot);
}

bool SimulatedRobots::listens() const {
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    if (!fs::exists(socket(robot)) || !fs::exists(port(robot))) {
      return false;
    }
  }
  return true;
}

void SimulatedRobots::wait_until_they_listen() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!listens()) {
    if (const auto status = process_->exit_status()) {
      const auto code = static_cast<ExitCode>(*status);
      const bool users_fault = code == ExitCode::kConfigInvalid || code == ExitCode::kUsage;
      throw CommandError(users_fault ? code : ExitCode::kRuntimeError, said_in(log_));
    }
    if (std::chrono::steady_clock::now() > end) {
      throw CommandError(ExitCode::kRuntimeError,
                         "the simulated robot did not start; see " + log_.string());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace echomap::session
