// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>

#include <spdlog/details/console_globals.h>
#include <spdlog/sinks/ansicolor_sink.h>

namespace echomap::console {

/// Where the log goes, in colours on a terminal that has them: a progress bar makes way for its
/// lines.
class LogSink final : public spdlog::sinks::ansicolor_sink<spdlog::details::console_mutex> {
 public:
  explicit LogSink(std::FILE* out);

  void log(const spdlog::details::log_msg& message) override;
};

}  // namespace echomap::console
