// SPDX-License-Identifier: MIT
#include "firmware/boards/ev3/guard.hpp"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <sys/prctl.h>
#include <sys/wait.h>

#include "firmware/boards/ev3/clock.hpp"
#include "firmware/boards/ev3/options.hpp"
#include "firmware/boards/ev3/parts.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint64_t kUsPerMs = 1000;
constexpr uint64_t kLookUs = 10 * kUsPerMs;
/// Between a death and the next life, so that the motors and the host notice.
constexpr uint64_t kPauseUs = 100 * kUsPerMs;
/// A robot that starts has no motor on, and a busy brick reads it from its card.
constexpr int kStartLimitMs = 10000;

/// Another than the program's, so that `killall -9` does not kill the guard with its robot.
constexpr const char* kGuardName = "echomap-guard";
/// Of the longest name of a process, its end included.
constexpr size_t kNameBytes = 16;

int beats_to_guard = -1;
uint16_t starts = 0;
uint16_t id = 0;
volatile sig_atomic_t has_to_end = 0;

void note_end(int /*signal*/) { has_to_end = 1; }

void stop_and_end(int /*signal*/) {
  stop_all_motors();
  _exit(0);
}

void handle_ends(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigfillset(&action.sa_mask);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
}

void draw_id() {
  const int source = open("/dev/urandom", O_RDONLY | O_CLOEXEC);
  if (source < 0 || read(source, &id, sizeof id) != static_cast<ssize_t>(sizeof id)) {
    id = static_cast<uint16_t>(getpid());
  }
  close(source);
}

/// A simulated start has to be the same every time.
void choose_id() {
  if (is_simulated()) {
    id = static_cast<uint16_t>(started_at_us() / kUsPerMs);
  } else {
    draw_id();
  }
}

/// False at the robot's end.
bool take_beats(int beats, uint64_t& last_us) {
  uint8_t bytes[64];
  ssize_t count = 0;
  while ((count = read(beats, bytes, sizeof bytes)) > 0) {
    last_us = clock_us();
  }
  return count < 0 && (errno == EAGAIN || errno == EINTR);
}

/// In simulated time the guard may not sleep before the robot has asked for the time, too: the
/// world would go on without it.
void wait_for_first_beat(int beats) {
  pollfd wait = {beats, POLLIN, 0};
  while (poll(&wait, 1, kStartLimitMs) < 0 && errno == EINTR && !has_to_end) {
  }
}

/// Until the robot has ended, hangs or shall end.
void watch(int beats) {
  wait_for_first_beat(beats);
  uint64_t last_us = clock_us();
  while (!has_to_end && take_beats(beats, last_us)) {
    const uint64_t now_us = clock_us();
    const uint64_t limit_us = last_us + kGuardMs * kUsPerMs;
    if (now_us >= limit_us) {
      return;
    }
    pollfd wait = {beats, POLLIN, 0};
    const uint64_t look_us = now_us + kLookUs;
    sleep_until(look_us < limit_us ? look_us : limit_us, &wait, 1);
  }
}

/// Ends both unless the robot has died of something else than its own will. One of whose end
/// nothing is known has crashed.
void bury(pid_t robot) {
  kill(robot, SIGKILL);
  stop_all_motors();  // It may take the kernel a while.
  int status = 0;
  pid_t buried = 0;
  do {
    buried = waitpid(robot, &status, 0);
  } while (buried < 0 && errno == EINTR);
  stop_all_motors();
  if (has_to_end) {
    _exit(0);
  }
  if (buried == robot && WIFEXITED(status)) {
    _exit(WEXITSTATUS(status));
  }
  const bool was_killed = buried != robot || WTERMSIG(status) == SIGKILL;
  fprintf(stderr,
          "echomap-ev3: the robot died (%s), motors are off, it starts again\n",
          was_killed ? "hung or killed" : strsignal(WTERMSIG(status)));
}

void become_robot(pid_t guard, const char* name) {
  prctl(PR_SET_NAME, name);
  handle_ends(stop_and_end);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != guard) {
    stop_and_end(SIGTERM);
  }
}

}  // namespace

void start_guard(const char* sysfs, const char* clock) {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGCHLD, SIG_DFL);  // Who ignores it does not hear how a child has died.
  handle_ends(note_end);
  char name[kNameBytes];
  prctl(PR_GET_NAME, name);
  prctl(PR_SET_NAME, kGuardName);
  start_clock(clock);
  choose_id();
  open_motors(sysfs);
  for (const pid_t guard = getpid();; ++starts) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) {
      fail("no pipe", "guard");
    }
    const pid_t robot = fork();
    if (robot < 0) {
      fail("cannot fork", "guard");
    }
    if (robot == 0) {
      close(ends[0]);
      beats_to_guard = ends[1];
      become_robot(guard, name);
      start_clock(clock);
      return;
    }
    close(ends[1]);
    watch(ends[0]);
    bury(robot);
    close(ends[0]);
    sleep_until(clock_us() + kPauseUs, nullptr, 0);
  }
}

void tell_guard() {
  const uint8_t beat = 0;
  // A full pipe is full of beats.
  static_cast<void>(!write(beats_to_guard, &beat, sizeof beat));
}

uint16_t starts_before() { return starts; }

uint16_t guard_id() { return id; }

}  // namespace boards
}  // namespace echomap
