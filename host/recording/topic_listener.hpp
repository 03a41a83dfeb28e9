// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace echomap::recording {

/// A topic of a session as it is recorded: its messages are CDR, its schema is a `ros2msg` text.
struct RecordedTopic {
  std::uint32_t id = 0;  ///< From 1 on; the session's alone, not that of a channel in a file.
  std::string name;
  std::string schema_name;
  std::string schema_text;
};

/// Hears what a session records while it takes place, in the thread that records it. It must not
/// wait, and write nothing to the log: lines of the log are recorded as well.
class TopicListener {
 public:
  virtual ~TopicListener() = default;
  /// Comes once, before the topic's first message.
  virtual void on_topic(const RecordedTopic& topic) = 0;
  /// `bytes` are those of the recording, and valid for the call alone.
  virtual void on_message(std::uint32_t topic,
                          std::uint64_t log_time_ns,
                          std::span<const std::uint8_t> bytes) = 0;
};

}  // namespace echomap::recording
