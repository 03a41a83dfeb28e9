// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hil_mock/runner/descriptor.hpp"

namespace echomap::ev3 {

/// A plain file that stands for an attribute of sysfs: a line of text, kept open by both sides.
class SysfsFile {
 public:
  /// Creates it. Throws std::system_error where that fails.
  SysfsFile(const std::filesystem::path& path, std::string_view text);

  /// Replaces what stands in it; costs nothing where that stood there before.
  void show(std::string_view text);
  void show(long number) { show(std::to_string(number)); }
  /// Its first line, as whoever wrote last has left it.
  std::string text() const;
  /// Throws std::runtime_error that names the file where no number stands in it.
  long number() const;
  /// Whether somebody else has written something else since `show`.
  bool has_changed() const { return text() != shown_; }

 private:
  runner::Descriptor file_;
  std::string name_;
  std::string shown_;
};

}  // namespace echomap::ev3
