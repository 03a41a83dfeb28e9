// SPDX-License-Identifier: MIT
#include "host/session/recording_log.hpp"

#include <algorithm>
#include <mutex>
#include <string>

#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include "host/ros_messages/rcl_interfaces.hpp"

namespace echomap::session {
namespace {

std::uint8_t ros_level(spdlog::level::level_enum level) {
  using ros_messages::Log;
  switch (level) {
    case spdlog::level::warn:
      return Log::kWarn;
    case spdlog::level::err:
    case spdlog::level::critical:
      return Log::kError;
    case spdlog::level::info:
      return Log::kInfo;
    default:
      return Log::kDebug;
  }
}

class RecordingSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit RecordingSink(recording::SessionRecorder& recorder) : recorder_(recorder) {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    recorder_.add_log(ros_level(message.level),
                      std::string(message.payload.data(), message.payload.size()));
  }
  void flush_() override {}

  recording::SessionRecorder& recorder_;
};

}  // namespace

RecordingLog::RecordingLog(recording::SessionRecorder& recorder)
    : sink_(std::make_shared<RecordingSink>(recorder)) {
  spdlog::default_logger()->sinks().push_back(sink_);
}

RecordingLog::~RecordingLog() { std::erase(spdlog::default_logger()->sinks(), sink_); }

}  // namespace echomap::session
