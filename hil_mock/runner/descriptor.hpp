// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include <sys/socket.h>

namespace echomap::runner {

/// For the type of a socket whose calls return at once and that no child keeps.
inline constexpr int kSocketFlags = SOCK_NONBLOCK | SOCK_CLOEXEC;

/// Owns a file descriptor and closes it.
class Descriptor {
 public:
  Descriptor() = default;
  /// Takes over `number`; a negative one is a failed call: throws std::system_error of errno that
  /// says what was `tried`.
  Descriptor(int number, const std::string& tried);
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  /// Negative where there is none.
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close();

 private:
  int number_ = -1;
};

/// Throws std::system_error of errno, which says what was `tried`, where `result` is negative.
void check_call(int result, const std::string& tried);

/// Makes reads and writes return at once.
void set_non_blocking(int descriptor);

}  // namespace echomap::runner
