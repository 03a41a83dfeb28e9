// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace echomap::fleet {

/// Stores what a robot has published, for the next start of its host: one file for each object, in
/// their order, and one for each map's latest graph. Without a path it stores nothing.
class OwnFolder {
 public:
  /// Creates the folder where it is missing. Throws files::FileError where that fails.
  explicit OwnFolder(std::filesystem::path path);

  /// Payloads of objects in the order in which they were saved, then those of graphs.
  std::vector<std::string> load();
  /// Writes the payload of an object or a graph. False where that fails.
  bool save_object(const std::string& payload);
  bool save_graph(std::uint16_t map_number, const std::string& payload) const;

 private:
  bool save(const std::string& name, const std::string& payload) const;

  std::filesystem::path path_;
  std::size_t next_object_ = 0;  ///< Numbers are not used again.
};

}  // namespace echomap::fleet
