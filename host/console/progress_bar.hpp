// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "host/console/drawn_in_place.hpp"

namespace echomap::console {

/// One line on a terminal that is drawn again in place, no longer than it is wide; says nothing
/// where `out` is no terminal.
class ProgressBar final : public DrawnInPlace {
 public:
  explicit ProgressBar(std::FILE* out, bool enabled = true);
  ~ProgressBar() override;

  /// Whether anything is ever drawn.
  bool is_active() const { return active_; }
  /// `share` of the work is done, 0 .. 1; at most ten drawings a second.
  void show(double share, const std::string& text);
  /// The same where nobody knows how much is done.
  void show(const std::string& text);
  /// Whether a drawing now would be seen.
  bool is_due() const;
  /// Wipes the line, for other output.
  void clear() override;

 private:
  void draw(const std::string& line);

  std::FILE* out_;
  bool active_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_{};
};

/// The first `width` characters of a line, which a terminal would wrap else; all of it for 0.
std::string clipped(const std::string& line, std::size_t width);

/// `share` 0 .. 1 as a bar of `width` characters: "[=====>    ]".
std::string bar_of(double share, int width);

}  // namespace echomap::console
