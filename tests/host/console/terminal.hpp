// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <unistd.h>

#include "tests/host/transport/pty_pair.hpp"

namespace echomap::console {

/// A terminal to write to, as wide as one likes.
class Terminal {
 public:
  std::FILE* file() const { return file_.get(); }
  /// All that was written to it.
  std::string shown() const {
    constexpr char kEnd = '\x04';
    std::fputc(kEnd, file());
    std::fflush(file());
    std::string text;
    char next = 0;
    while (::read(pty_.fd(), &next, 1) == 1 && next != kEnd) {
      text += next;
    }
    return text;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  transport::PtyPair pty_;
  std::unique_ptr<std::FILE, Close> file_{std::fopen(pty_.name().c_str(), "we")};
};

}  // namespace echomap::console
