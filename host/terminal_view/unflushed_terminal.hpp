// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::terminal_view {

/// While it exists, Ctrl-C does not discard what was written to a terminal and is not yet on it, so
/// that the lines of a frame can be counted. Leaves the terminal of another foreground program as
/// it is.
class UnflushedTerminal {
 public:
  explicit UnflushedTerminal(int terminal);
  ~UnflushedTerminal();
  UnflushedTerminal(const UnflushedTerminal&) = delete;
  UnflushedTerminal& operator=(const UnflushedTerminal&) = delete;

 private:
  int terminal_;
  bool is_changed_ = false;
};

}  // namespace echomap::terminal_view
