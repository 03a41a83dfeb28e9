// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "host/apps/explore_run.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exports/summary_json.hpp"

namespace echomap::apps {

/// Saves the map so far, with how far the exploration has come. A map that was set aside is saved
/// in a run directory of its own beside it, previous_1, previous_2, ...
class RunWriter {
 public:
  /// All of them outlive this.
  RunWriter(session::RobotContext& robot,
            const exploration::Explorer& explorer,
            const ExploreRun& run,
            exports::RunSummary& summary);

  /// Moves an earlier run in the directory aside and begins the file of the recording. To be called
  /// once the robot has answered, before anything is saved. Throws files::FileError.
  void begin();
  /// With the summary as it is, but for the time, link and map, which are told in it. Throws
  /// files::FileError.
  void save();
  /// A disk that is full now need not be so at the end: warns once and lets the robot go on.
  void save_in_passing();

 private:
  void describe_clock();
  void describe_link();
  void save_current_map();
  void save_previous_maps();
  /// Their stops are in the map that is saved by then.
  void remove_joined_maps();

  session::RobotContext& robot_;
  const exploration::Explorer& explorer_;
  std::filesystem::path out_;
  bool align_;       ///< The pictures with the room.
  double before_s_;  ///< The robot's time in the run that this one resumes.
  exports::RunSummary& summary_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool warned_ = false;
  std::uint64_t split_bytes_;
  std::size_t changes_saved_ = 0;   ///< Of the atlas's maps, when the previous ones were saved.
  std::size_t previous_saved_ = 0;  ///< Directories of maps that were set aside.
};

}  // namespace echomap::apps
