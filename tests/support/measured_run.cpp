// SPDX-License-Identifier: MIT
// measured_run PROGRAM [ARGUMENT ..]: runs a test, ends as it ended, and says on stdout what it and
// its children took. `./run test` adds these lines up.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The test ends with this program, whom ctest ends at a time limit.
[[noreturn]] void become(char** command) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  execvp(command[0], command);
  std::perror(command[0]);
  std::_Exit(127);
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: measured_run PROGRAM [ARGUMENT ..]\n", stderr);
    return 2;
  }
  const pid_t child = fork();
  if (child < 0) {
    std::perror("fork");
    return 127;
  }
  if (child == 0) {
    become(argv + 1);
  }
  const int status = wait_for(child);
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  std::printf("measured: %.2f s of processor, %ld MB, exit status %d\n",
              seconds(usage.ru_utime) + seconds(usage.ru_stime),
              usage.ru_maxrss / 1024,
              WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
  std::fflush(stdout);
  if (WIFSIGNALED(status)) {
    std::signal(WTERMSIG(status), SIG_DFL);
    std::raise(WTERMSIG(status));
  }
  return WEXITSTATUS(status);
}
