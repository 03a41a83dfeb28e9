// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace echomap::ev3 {

/// A folder that lasts as long as its owner.
class OwnFolder {
 public:
  /// In memory where the machine has such a place. Throws std::system_error where it cannot.
  OwnFolder();
  ~OwnFolder();
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace echomap::ev3
