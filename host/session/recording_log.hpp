// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <spdlog/sinks/sink.h>

#include "host/recording/session_recorder.hpp"

namespace echomap::session {

/// Records the lines of the log for as long as it exists.
class RecordingLog {
 public:
  /// `recorder` outlives this.
  explicit RecordingLog(recording::SessionRecorder& recorder);
  ~RecordingLog();
  RecordingLog(const RecordingLog&) = delete;
  RecordingLog& operator=(const RecordingLog&) = delete;

 private:
  std::shared_ptr<spdlog::sinks::sink> sink_;
};

}  // namespace echomap::session
