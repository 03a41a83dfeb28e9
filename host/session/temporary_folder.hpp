// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace echomap::session {

/// An empty folder of its own below the system's temporary one, removed with all that is in it when
/// this ends. Its path is short enough for a socket's.
class TemporaryFolder {
 public:
  /// Throws std::system_error.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace echomap::session
