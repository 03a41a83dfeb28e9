// SPDX-License-Identifier: MIT
#include "host/apps/progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <unistd.h>

namespace echomap::apps {

ProgressBar::ProgressBar(std::FILE* out, bool enabled)
    : out_(out), active_(enabled && ::isatty(::fileno(out)) == 1) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::show(double share, const std::string& text) {
  const auto now = std::chrono::steady_clock::now();
  if (!active_ || (drawn_ && now - last_ < std::chrono::milliseconds(100))) {
    return;
  }
  last_ = now;
  drawn_ = true;
  std::fprintf(
      out_, "\r\033[K%s %3.0f %%  %s", bar_of(share, 24).c_str(), 100.0 * share, text.c_str());
  std::fflush(out_);
}

void ProgressBar::clear() {
  if (drawn_) {
    std::fputs("\r\033[K", out_);
    std::fflush(out_);
    drawn_ = false;
  }
}

std::string bar_of(double share, int width) {
  const int done = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * width));
  std::string bar(static_cast<std::size_t>(width), ' ');
  std::fill_n(bar.begin(), done, '=');
  if (done > 0 && done < width) {
    bar[static_cast<std::size_t>(done - 1)] = '>';
  }
  return "[" + bar + "]";
}

}  // namespace echomap::apps
