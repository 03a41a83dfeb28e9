// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "host/mcap/mcap_reader.hpp"
#include "host/mcap/records.hpp"

namespace echomap::datasets {

/// Whether a folder is a bag as ROS 2 records it: `metadata.yaml` beside files NAME.mcap.
bool is_bag_folder(const std::filesystem::path& folder);

/// The messages of a bag: of one MCAP file, or of those in a folder one after the other, in the
/// order of their numbers.
class BagFiles {
 public:
  /// Throws files::FileError where there is no such file, or a folder has none.
  explicit BagFiles(const std::filesystem::path& path);

  /// The next message; empty at the end. Throws files::FileError where a file is damaged, and
  /// CutOffLine, behind all other messages, where a file merely ends too early.
  std::optional<mcap::Message> next();
  /// The share of the files that has been read, 0 .. 1.
  double progress() const;

 private:
  /// Empty at the end of a file, also where that is cut off.
  std::optional<mcap::Message> next_in_file();

  std::vector<std::filesystem::path> paths_;
  std::size_t index_ = 0;                     ///< Of the file that is read.
  std::unique_ptr<mcap::McapReader> reader_;  ///< Null behind the last file.
  std::exception_ptr cut_off_;
};

}  // namespace echomap::datasets
