// SPDX-License-Identifier: MIT
#include "host/console/progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <unistd.h>

#include <fmt/format.h>
#include <sys/ioctl.h>

namespace echomap::console {

ProgressBar::ProgressBar(std::FILE* out, bool enabled)
    : out_(out), active_(enabled && ::isatty(::fileno(out)) == 1) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::show(double share, const std::string& text) {
  if (is_due()) {
    draw(fmt::format("{} {:3.0f} %  {}", bar_of(share, 24), 100.0 * share, text));
  }
}

void ProgressBar::show(const std::string& text) {
  if (is_due()) {
    draw(text);
  }
}

bool ProgressBar::is_due() const {
  const auto now = std::chrono::steady_clock::now();
  return active_ && (!drawn_ || now - last_ >= std::chrono::milliseconds(100));
}

void ProgressBar::draw(const std::string& line) {
  last_ = std::chrono::steady_clock::now();
  drawn_ = true;
  note_drawn();
  winsize size{};
  const bool is_known = ::ioctl(::fileno(out_), TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  const std::size_t width = is_known ? size.ws_col - 1U : 0U;
  std::fprintf(out_, "\r\033[K%s", clipped(line, width).c_str());
  std::fflush(out_);
}

void ProgressBar::clear() {
  if (drawn_) {
    std::fputs("\r\033[K", out_);
    std::fflush(out_);
    drawn_ = false;
    note_gone();
  }
}

std::string clipped(const std::string& line, std::size_t width) {
  return width == 0 ? line : line.substr(0, width);
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

}  // namespace echomap::console
