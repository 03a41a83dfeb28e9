// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/console/drawn_in_place.hpp"
#include "host/terminal_view/terminal_kind.hpp"
#include "host/terminal_view/unflushed_terminal.hpp"

namespace echomap::terminal_view {

/// Size of the terminal that a stream writes to; 80 x 24 where it does not know its own.
TextSize terminal_size(std::FILE* out);

/// What a screen asks of the world, for tests to answer in its place.
struct ScreenSurroundings {
  std::function<TextSize()> size;
  std::function<std::chrono::steady_clock::time_point()> now;
  TerminalKind kind;
};

/// The terminal that a stream writes to, by the clock and the environment of this process.
ScreenSurroundings surroundings_of(std::FILE* out);

/// A block of lines below the log of a terminal, drawn again in place at most five times a second.
/// Lines that are printed meanwhile stay above it. The cursor waits below the block, shown, and
/// colours are reset after every frame: however the program ends, the terminal is as before. Where
/// the terminal cannot move its cursor, a frame is printed below the last one every half minute.
/// Says nothing where `out` is no terminal.
class TerminalScreen final : public console::DrawnInPlace {
 public:
  explicit TerminalScreen(std::FILE* out, bool enabled = true);
  TerminalScreen(std::FILE* out, bool enabled, ScreenSurroundings surroundings);
  /// Leaves the last frame where it is.
  ~TerminalScreen() override = default;

  /// Whether anything is ever drawn.
  bool is_active() const { return active_; }
  Glyphs glyphs() const { return surroundings_.kind.glyphs; }
  /// How large a frame may be: three quarters of the terminal's height, so that the log is seen.
  TextSize room() const;
  /// Whether a frame now would be seen.
  bool is_due() const;
  /// Draws the frame where one is due. It fits into `room()`.
  void show(const std::vector<std::string>& frame);
  /// Draws a last frame now, which stays: what comes next is printed below it.
  void finish(const std::vector<std::string>& frame);
  void clear() override;

 private:
  void draw(const std::vector<std::string>& frame);
  /// Moves to the first line of the block and wipes it; what to write for that.
  std::string wiped_block() const;
  /// The lines that differ from those of the block, written over them.
  std::string changed_lines(const std::vector<std::string>& frame) const;
  void write(const std::string& text) const;

  std::FILE* out_;
  bool active_;
  ScreenSurroundings surroundings_;
  std::optional<UnflushedTerminal> unflushed_;
  std::vector<std::string> block_;  ///< On the terminal; empty: none.
  TextSize size_;                   ///< Of the terminal when the block was drawn.
  bool has_drawn_ = false;
  bool was_interrupted_ = false;  ///< When the block was drawn.
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace echomap::terminal_view
