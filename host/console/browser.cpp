// SPDX-License-Identifier: MIT
#include "host/console/browser.hpp"

#include <array>
#include <cstdlib>
#include <spawn.h>
#include <unistd.h>

#include <sys/wait.h>

namespace echomap::console {
namespace {

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool has_desktop() {
  return (is_set("DISPLAY") || is_set("WAYLAND_DISPLAY")) && !is_set("SSH_CONNECTION");
}

/// The shell puts the opener into the background and ends, so that nobody has to wait for it.
bool open_in_browser(const std::string& url) {
  std::string program = "sh";
  std::string option = "-c";
  std::string script =
      "command -v xdg-open >/dev/null || exit 1; xdg-open \"$0\" </dev/null >/dev/null 2>&1 &";
  std::string argument = url;
  const std::array<char*, 5> command{
      program.data(), option.data(), script.data(), argument.data(), nullptr};
  pid_t pid = 0;
  if (::posix_spawnp(&pid, "sh", nullptr, nullptr, command.data(), environ) != 0) {
    return false;
  }
  int status = 0;
  return ::waitpid(pid, &status, 0) == pid && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace echomap::console
