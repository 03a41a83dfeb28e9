// SPDX-License-Identifier: MIT
#include "host/terminal_view/unflushed_terminal.hpp"

#include <termios.h>
#include <unistd.h>

namespace echomap::terminal_view {
namespace {

/// A program in the background would be stopped for changing its terminal.
bool may_be_changed(int terminal) {
  const pid_t foreground = ::tcgetpgrp(terminal);
  return foreground == -1 || foreground == ::getpgrp();
}

/// Whether a flag of a terminal was changed to that.
bool change_noflsh(int terminal, bool on) {
  termios settings{};
  if (!may_be_changed(terminal) || ::tcgetattr(terminal, &settings) != 0 ||
      ((settings.c_lflag & NOFLSH) != 0) == on) {
    return false;
  }
  settings.c_lflag ^= NOFLSH;
  return ::tcsetattr(terminal, TCSANOW, &settings) == 0;
}

}  // namespace

UnflushedTerminal::UnflushedTerminal(int terminal)
    : terminal_(terminal), is_changed_(change_noflsh(terminal, true)) {}

UnflushedTerminal::~UnflushedTerminal() {
  if (is_changed_) {
    change_noflsh(terminal_, false);
  }
}

}  // namespace echomap::terminal_view
