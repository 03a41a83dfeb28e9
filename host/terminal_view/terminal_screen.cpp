// SPDX-License-Identifier: MIT
#include "host/terminal_view/terminal_screen.hpp"

#include <algorithm>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <sys/ioctl.h>

#include "host/console/interrupt.hpp"
#include "host/terminal_view/text_line.hpp"

namespace echomap::terminal_view {
namespace {

constexpr std::chrono::milliseconds kFramePeriod(200);
constexpr std::chrono::seconds kPrintPeriod(30);

std::string lines_up(int lines) { return lines > 0 ? fmt::format("\r\033[{}A", lines) : "\r"; }

}  // namespace

TextSize terminal_size(std::FILE* out) {
  winsize size{};
  const bool is_known =
      ::ioctl(::fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
  return is_known ? TextSize{size.ws_col, size.ws_row} : TextSize();
}

ScreenSurroundings surroundings_of(std::FILE* out) {
  return {[out] { return terminal_size(out); },
          [] { return std::chrono::steady_clock::now(); },
          terminal_kind()};
}

TerminalScreen::TerminalScreen(std::FILE* out, bool enabled)
    : TerminalScreen(out, enabled, surroundings_of(out)) {}

TerminalScreen::TerminalScreen(std::FILE* out, bool enabled, ScreenSurroundings surroundings)
    : out_(out),
      active_(enabled && ::isatty(::fileno(out)) == 1),
      surroundings_(std::move(surroundings)) {
  if (active_ && surroundings_.kind.moves_cursor) {
    unflushed_.emplace(::fileno(out));
  }
}

TextSize TerminalScreen::room() const {
  const TextSize size = surroundings_.size();
  // A full last column would make some terminals wrap.
  return {std::max(size.columns - 1, 1), std::max(size.lines * 3 / 4, 1)};
}

bool TerminalScreen::is_due() const {
  const auto period = surroundings_.kind.moves_cursor
                          ? std::chrono::steady_clock::duration(kFramePeriod)
                          : std::chrono::steady_clock::duration(kPrintPeriod);
  return active_ && (!has_drawn_ || surroundings_.now() - last_ >= period);
}

void TerminalScreen::show(const std::vector<std::string>& frame) {
  if (is_due()) {
    draw(frame);
  }
}

void TerminalScreen::finish(const std::vector<std::string>& frame) {
  if (active_) {
    draw(frame);
    block_.clear();
    note_gone();
  }
}

void TerminalScreen::draw(const std::vector<std::string>& frame) {
  last_ = surroundings_.now();
  has_drawn_ = true;
  if (!surroundings_.kind.moves_cursor) {
    write(fmt::format("{}\n", fmt::join(frame, "\n")));
    return;
  }
  const TextSize size = surroundings_.size();
  // The terminal may have echoed ^C into the middle of a line.
  const bool is_interrupted = console::interrupted();
  const bool is_damaged = is_interrupted != was_interrupted_;
  if (block_.size() == frame.size() && size == size_ && !is_damaged) {
    write(changed_lines(frame));
  } else {
    write(wiped_block() + (frame.empty() ? "" : fmt::format("{}\n", fmt::join(frame, "\n"))));
  }
  block_ = frame;
  size_ = size;
  was_interrupted_ = is_interrupted;
  note_drawn();
}

void TerminalScreen::clear() {
  write(wiped_block());
  block_.clear();
  note_gone();
}

std::string TerminalScreen::wiped_block() const {
  if (block_.empty()) {
    return "";
  }
  // Terminals that have become narrower have wrapped the lines.
  const int columns = surroundings_.size().columns;
  int lines = 0;
  for (const std::string& line : block_) {
    lines += std::max(1, (columns_of(line) + columns - 1) / columns);
  }
  return lines_up(lines) + "\033[J";
}

std::string TerminalScreen::changed_lines(const std::vector<std::string>& frame) const {
  if (frame == block_) {
    return "";
  }
  std::string text = lines_up(static_cast<int>(frame.size()));
  for (std::size_t i = 0; i < frame.size(); ++i) {
    text += (frame[i] == block_[i] ? "" : frame[i] + "\033[K") + "\n";
  }
  return text;
}

void TerminalScreen::write(const std::string& text) const {
  if (!text.empty()) {
    std::fwrite(text.data(), 1, text.size(), out_);
    std::fflush(out_);
  }
}

}  // namespace echomap::terminal_view
