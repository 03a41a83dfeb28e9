// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace echomap::apps {

/// One line on a terminal that is drawn again in place; says nothing where `out` is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::FILE* out, bool enabled = true);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Whether anything is ever drawn.
  bool is_active() const { return active_; }
  /// `share` of the work is done, 0 .. 1; at most ten drawings a second.
  void show(double share, const std::string& text);
  /// Wipes the line, for other output.
  void clear();

 private:
  std::FILE* out_;
  bool active_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_{};
};

/// `share` 0 .. 1 as a bar of `width` characters: "[=====>    ]".
std::string bar_of(double share, int width);

}  // namespace echomap::apps
