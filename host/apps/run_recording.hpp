// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "host/apps/commands.hpp"
#include "host/exports/summary_json.hpp"
#include "host/session/robot_context.hpp"

namespace echomap::apps {

/// The size at which the recording of a run goes on in another file, bytes; 0: never.
inline std::uint64_t split_bytes(const RunOptions& run) {
  constexpr std::uint64_t kBytesPerMegabyte = 1'000'000;
  return run.split_mb * kBytesPerMegabyte;
}

/// Begins the recording of a robot that has answered in the run directory `out`, and says in it
/// what the run is: `command` makes it. A file of at least `split_bytes` is followed by another
/// one; 0: never. Throws files::FileError.
void begin_recording(session::RobotContext& robot,
                     const std::string& command,
                     const exports::RunSummary& summary,
                     const std::filesystem::path& out,
                     std::uint64_t split_bytes);

/// Ends the recording with what came of the run: its report, without the time that the program
/// took, and the map that stands in `out`. Does nothing where none was begun. Throws
/// files::FileError.
void end_recording(session::RobotContext& robot,
                   const nlohmann::ordered_json& report,
                   const std::filesystem::path& out);

}  // namespace echomap::apps
