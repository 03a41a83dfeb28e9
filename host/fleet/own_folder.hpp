// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace echomap::fleet {

/// Keeps what a robot is the source of over the end of its host: one file for each object, in their
/// order, and one for each map's latest graph. Without a path it keeps nothing.
class OwnFolder {
 public:
  /// Makes the folder where there is none. Throws files::FileError where that is not possible.
  explicit OwnFolder(std::filesystem::path path);

  /// Payloads of objects in the order that they were saved in, then those of graphs.
  std::vector<std::string> load();
  /// False where it could not be written.
  bool save_object(const std::string& payload);
  bool save_graph(std::uint16_t map_number, const std::string& payload) const;

 private:
  bool save(const std::string& name, const std::string& payload) const;

  std::filesystem::path path_;
  std::size_t next_object_ = 0;  ///< An object's number is not used again.
};

}  // namespace echomap::fleet
