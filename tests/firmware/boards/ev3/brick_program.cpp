// SPDX-License-Identifier: MIT
#include "tests/firmware/boards/ev3/brick_program.hpp"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <stdexcept>
#include <thread>
#include <unistd.h>

#include <sys/wait.h>

#include "protocol/message_codec.hpp"
#include "protocol/version.hpp"

namespace echomap::tests {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kPatience{10000};
constexpr milliseconds kLook{1};
constexpr std::uint8_t kTimeToLiveMs = 200;
constexpr std::int16_t kTicksPerS = 300;

/// What the kernel says of a process; empty of none.
std::string status_of(const std::filesystem::path& process, const std::string& key) {
  std::ifstream status(process / "status");
  std::string word;
  while (status >> word) {
    if (word == key) {
      status >> word;
      return word;
    }
  }
  return "";
}

std::filesystem::path folder_of(pid_t process) {
  return std::filesystem::path("/proc") / std::to_string(process);
}

constexpr int kOwnerWrites = 0600;

[[noreturn]] void become_program(std::vector<std::string>& words,
                                 bool children_are_ignored,
                                 const std::array<int, 3>& files) {
  std::signal(SIGCHLD, children_are_ignored ? SIG_IGN : SIG_DFL);
  for (std::size_t i = 0; i < files.size(); ++i) {
    ::dup2(files.at(i), static_cast<int>(i));
  }
  std::array<char*, 16> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    arguments.at(i) = words[i].data();
  }
  ::execvp(arguments.front(), arguments.data());
  ::_exit(127);
}

std::string content_of(int file) {
  std::string content;
  std::array<char, 1024> bytes{};
  for (ssize_t count = 0; (count = ::read(file, bytes.data(), bytes.size())) > 0;) {
    content.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return content;
}

}  // namespace

BrickProgram::BrickProgram(const BrickStart& start) {
  if (start.prepare) {
    start.prepare(brick_);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::array<int, 2> to_program{};
  std::array<int, 2> from_program{};
  if (::pipe2(to_program.data(), O_CLOEXEC) != 0 || ::pipe2(from_program.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("no pipe");
  }
  std::vector<std::string> words{"qemu-arm",
                                 "-cpu",
                                 "arm926",
                                 ECHOMAP_BINARY_DIR "/firmware/echomap-ev3.elf",
                                 "--sysfs",
                                 brick_.sysfs().string(),
                                 "--line",
                                 start.line};
  words.insert(words.end(), start.more.begin(), start.more.end());
  const int errors =
      ::open(file("stderr").c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kOwnerWrites);
  guard_ = ::fork();
  if (guard_ == 0) {
    become_program(words, start.children_are_ignored, {to_program[0], from_program[1], errors});
  }
  ::close(to_program[0]);
  ::close(from_program[1]);
  ::close(errors);
  input_ = to_program[1];
  output_ = from_program[0];
}

BrickProgram::~BrickProgram() {
  const pid_t robot_left = robot();
  if (robot_left > 0) {
    ::kill(robot_left, SIGKILL);
  }
  if (!status_) {
    ::kill(guard_, SIGKILL);
    ::waitpid(guard_, nullptr, 0);
  }
  hang_up();
  ::close(output_);
}

void BrickProgram::attach(int descriptor) {
  hang_up();
  ::close(output_);
  input_ = descriptor;
  output_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  decoder_ = protocol::FrameDecoder(protocol::MessagesToHost::find_schema);
  reply_.reset();
}

void BrickProgram::hang_up() {
  if (input_ >= 0) {
    ::close(input_);
    input_ = -1;
  }
}

std::string BrickProgram::errors() const {
  const int file_of_errors = ::open(file("stderr").c_str(), O_RDONLY | O_CLOEXEC);
  std::string said = content_of(file_of_errors);
  ::close(file_of_errors);
  return said;
}

std::string BrickProgram::output() const { return content_of(output_); }

std::optional<protocol::HelloReply> BrickProgram::connect(std::uint16_t session) {
  const auto end = Clock::now() + kPatience;
  while (Clock::now() < end) {
    write({0});
    send(protocol::Hello{
        protocol::kProtocolMajor, protocol::kProtocolMinor, protocol::kSchemaDigest, session});
    listen(milliseconds(50));
    if (reply_ && reply_->session == session) {
      return reply_;
    }
  }
  return std::nullopt;
}

bool BrickProgram::drive(std::uint16_t session) {
  // In one session: another would have to wait until this one has been silent for long.
  const auto end = Clock::now() + kPatience;
  std::uint8_t command_id = 0;
  for (bool is_there = connect(session).has_value(); is_there && Clock::now() < end;) {
    send(protocol::Arm{++command_id, 1});
    send(protocol::DriveSetpoint{kTicksPerS, kTicksPerS, kTimeToLiveMs});
    const auto give_up = Clock::now() + milliseconds(150);
    while (Clock::now() < give_up) {
      if (says(left_, "run-direct") && says(right_, "run-direct")) {
        return true;
      }
      listen(kLook);
    }
  }
  return false;
}

pid_t BrickProgram::robot() const {
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    const std::string name = process.path().filename();
    if (name.find_first_not_of("0123456789") == std::string::npos &&
        status_of(process.path(), "PPid:") == std::to_string(guard_)) {
      return std::stoi(name);
    }
  }
  return 0;
}

pid_t BrickProgram::living_robot() const {
  for (const auto end = Clock::now() + kPatience; Clock::now() < end;) {
    if (const pid_t found = robot(); found > 0) {
      return found;
    }
    std::this_thread::sleep_for(kLook);
  }
  throw std::runtime_error("the guard has no robot");
}

bool BrickProgram::lives(pid_t process) {
  const std::string state = status_of(folder_of(process), "State:");
  return !state.empty() && state != "Z" && state != "X";
}

std::string BrickProgram::name_of(pid_t process) { return status_of(folder_of(process), "Name:"); }

std::optional<int> BrickProgram::end() {
  const auto end = Clock::now() + kPatience;
  int status = 0;
  while (!status_ && Clock::now() < end) {
    if (::waitpid(guard_, &status, WNOHANG) == guard_) {
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    std::this_thread::sleep_for(kLook);
  }
  return status_;
}

std::optional<double> BrickProgram::ms_until_stopped(const std::function<void()>& harm) {
  const auto start = Clock::now();
  harm();
  while (Clock::now() < start + std::chrono::minutes(1)) {
    if (says(left_, "stop") && says(right_, "stop")) {
      return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return std::nullopt;
}

void BrickProgram::write(const std::vector<std::uint8_t>& bytes) const {
  static_cast<void>(!::write(input_, bytes.data(), bytes.size()));
}

void BrickProgram::listen(milliseconds most) {
  const auto end = Clock::now() + most;
  std::array<std::uint8_t, 1024> bytes{};
  while (Clock::now() < end) {
    pollfd wait{output_, POLLIN, 0};
    if (::poll(&wait, 1, 1) <= 0) {
      continue;
    }
    const auto count = ::read(output_, bytes.data(), bytes.size());
    if (count <= 0) {
      std::this_thread::sleep_for(kLook);  // Hung up: the program may come back.
    }
    for (ssize_t i = 0; i < count; ++i) {
      if (decoder_.take(bytes.at(static_cast<std::size_t>(i))) == protocol::DecodeStatus::kFrame) {
        const protocol::Frame frame = decoder_.frame();
        protocol::Dispatcher<protocol::MessagesToHost>::dispatch(frame.id, frame.payload, *this);
      }
    }
  }
}

bool BrickProgram::says(const std::filesystem::path& motor, const std::string& command) {
  return BrickFolder::read(motor / "command") == command;
}

}  // namespace echomap::tests
