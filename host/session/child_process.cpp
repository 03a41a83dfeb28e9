// SPDX-License-Identifier: MIT
#include "host/session/child_process.hpp"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>

namespace echomap::session {
namespace {

constexpr int kNotStarted = 127;

/// Opens a file as one of the standard streams; false and errno where that fails.
bool open_as(int stream, const char* path, int flags) {
  const int file = ::open(path, flags, 0644);
  if (file == stream) {
    return true;
  }
  return file >= 0 && ::dup2(file, stream) == stream && ::close(file) == 0;
}

/// Goes on as the child of a fork and becomes the program, or writes an errno to `report`. Other
/// threads may have held locks when it was forked: only calls that are safe in a signal handler.
[[noreturn]] void become(char* const* command, const char* log, pid_t parent, int report) {
  // A group of its own: the terminal's Ctrl-C reaches only the host, which then ends it in order.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  const bool is_orphan = ::getppid() != parent;
  if (!is_orphan && open_as(STDIN_FILENO, "/dev/null", O_RDONLY) &&
      open_as(STDOUT_FILENO, log, O_WRONLY | O_CREAT | O_TRUNC) &&
      ::dup2(STDOUT_FILENO, STDERR_FILENO) == STDERR_FILENO) {
    ::execv(command[0], command);
  }
  const int error = errno;
  [[maybe_unused]] const ssize_t written = ::write(report, &error, sizeof error);
  ::_exit(kNotStarted);
}

/// Waits until the child has become its program; the errno where it has not, or 0.
int start_error(int report) {
  int error = 0;
  ssize_t count = 0;
  do {
    count = ::read(report, &error, sizeof error);
  } while (count < 0 && errno == EINTR);
  return count == sizeof error ? error : 0;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::filesystem::path& log) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const auto& word : command) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);

  int report[2] = {-1, -1};
  const pid_t parent = ::getpid();
  int error = ::pipe2(report, O_CLOEXEC) == 0 ? 0 : errno;
  if (error == 0) {
    pid_ = ::fork();
    error = pid_ < 0 ? errno : 0;
    if (pid_ == 0) {
      become(arguments.data(), log.c_str(), parent, report[1]);
    }
    ::close(report[1]);
    error = error != 0 ? error : start_error(report[0]);
    ::close(report[0]);
  }
  if (error != 0) {
    if (pid_ > 0) {
      wait_for(std::chrono::seconds(2));
    }
    throw std::runtime_error("cannot start " + command.front() + ": " +
                             std::generic_category().message(error));
  }
}

ChildProcess::~ChildProcess() {
  send(SIGTERM);
  if (!wait_for(std::chrono::seconds(2))) {
    send(SIGKILL);
    wait_for(std::chrono::seconds(2));
  }
}

void ChildProcess::send(int signal) {
  if (!exit_status()) {
    ::kill(pid_, signal);
  }
}

std::optional<int> ChildProcess::exit_status() {
  int status = 0;
  rusage used{};
  if (!status_ && ::wait4(pid_, &status, WNOHANG, &used) == pid_) {
    status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    cpu_s_ = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  }
  return status_;
}

std::optional<int> ChildProcess::wait_for(std::chrono::milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!exit_status() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return status_;
}

std::filesystem::path program_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

}  // namespace echomap::session
