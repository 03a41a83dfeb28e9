// SPDX-License-Identifier: MIT
#include "host/session/simulated_robot.hpp"

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

}  // namespace

SimulatedRobot::SimulatedRobot(const SimulatedRobotOptions& options,
                               const Seed& seed,
                               const fs::path& body,
                               const fs::path& out)
    : is_radio_(options.line == "bluetooth"), truth_(out / "truth"), log_(out / "robot.log") {
  fs::create_directories(truth_);
  std::vector<std::string> command{program_of(options),
                                   "--world=" + options.world,
                                   "--robot=" + body.string(),
                                   "--seed=" + std::to_string(seed.number()),
                                   "--link=" + port(),
                                   "--lockstep=" + socket(),
                                   "--truth=" + truth_.string()};
  command.push_back("--line=" + options.line);
  if (!options.faults.empty()) {
    command.push_back("--faults=" + options.faults);
  }
  if (!options.part_faults.empty()) {
    command.push_back("--part-faults=" + options.part_faults);
  }
  for (const std::string& source : options.sources) {
    command.push_back("--source=" + source);
  }
  if (!options.fixes.empty()) {
    command.push_back("--camera=udp:" + options.fixes.substr(options.fixes.rfind(':') + 1));
  }
  if (!options.camera_params.empty()) {
    command.push_back("--camera-params=" + options.camera_params);
  }
  if (!options.board.empty()) {
    command.push_back("--board=" + options.board);
  }
  if (!options.driver.empty()) {
    command.push_back("--driver=" + options.driver);
  }
  process_ = std::make_unique<ChildProcess>(command, log_);
  wait_until_it_listens();
}

ConnectionOptions SimulatedRobot::connection() const {
  ConnectionOptions options;
  options.ports = {port()};
  options.lockstep = socket();
  options.is_radio = is_radio_;
  return options;
}

void SimulatedRobot::wait_until_it_listens() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!fs::exists(socket()) || !fs::exists(port())) {
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
