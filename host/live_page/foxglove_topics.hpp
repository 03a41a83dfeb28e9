// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "host/recording/topic_listener.hpp"

namespace echomap::live_page {

/// A topic that clients of the Foxglove protocol can subscribe to, there called a channel.
struct FoxgloveChannel {
  std::uint32_t id = 0;  ///< From 1 on; never that of another topic or schema.
  std::string topic;
  std::string schema_name;
  std::string schema_text;  ///< Its encoding is ros2msg, that of the messages cdr.
};

/// A message of a channel.
struct FoxgloveMessage {
  std::uint32_t channel = 0;
  std::uint64_t number = 0;  ///< Of all messages; from 1 on.
  std::uint64_t log_time_ns = 0;
  std::vector<std::uint8_t> data;
};

/// Made once, read by every client.
using SharedFoxgloveChannel = std::shared_ptr<const FoxgloveChannel>;
using SharedFoxgloveMessage = std::shared_ptr<const FoxgloveMessage>;

/// The topics of a run as it is recorded, their newest messages and the last ones of all. One
/// thread adds, others read: every call is safe beside the others.
class FoxgloveTopics final : public recording::TopicListener {
 public:
  /// Something is new; called by the thread that adds it. It must not wait.
  using WakeUp = std::function<void()>;

  /// What is later than a message.
  struct News {
    /// In their order, as far as they are still kept; of topics whose messages are not, the newest.
    std::vector<SharedFoxgloveMessage> messages;
    std::uint64_t last_number = 0;  ///< Of the last message that there is; 0 before the first.
    std::uint64_t log_time_ns = 0;  ///< Of that message.
    std::uint64_t generation = 0;   ///< Another one where the channels are others.
  };

  /// `session_id` is another one in every run of the program.
  explicit FoxgloveTopics(std::string session_id) : session_id_(std::move(session_id)) {}

  /// A topic that comes again with another name or schema is another channel.
  void on_topic(const recording::RecordedTopic& topic) override;
  void on_message(std::uint32_t topic,
                  std::uint64_t log_time_ns,
                  std::span<const std::uint8_t> bytes) override;
  /// Forgets everything: another run begins.
  void clear();
  /// By the number that it gives the call is ended: when `unlisten` returns, it is over.
  std::uint64_t listen(WakeUp wake_up);
  void unlisten(std::uint64_t number);

  const std::string& session_id() const { return session_id_; }
  std::vector<SharedFoxgloveChannel> channels() const;
  /// Null where the channel has none.
  SharedFoxgloveMessage newest(std::uint32_t channel) const;
  News since(std::uint64_t number) const;

  static constexpr std::size_t kMaxChannels = 256;
  static constexpr std::size_t kMaxKeptMessages = 4096;
  static constexpr std::size_t kMaxKeptBytes = std::size_t{4} << 20;

 private:
  void forget(std::uint32_t channel);
  void keep(SharedFoxgloveMessage message);
  void wake_up() const;

  std::string session_id_;
  mutable std::mutex mutex_;
  mutable std::mutex wake_up_mutex_;
  std::map<std::uint64_t, WakeUp> wake_ups_;
  std::uint64_t last_wake_up_ = 0;
  std::uint32_t last_channel_ = 0;
  std::uint64_t last_number_ = 0;
  std::uint64_t log_time_ns_ = 0;
  std::uint64_t generation_ = 0;
  std::map<std::uint32_t, std::uint32_t> channel_of_topic_;
  std::map<std::uint32_t, SharedFoxgloveChannel> channels_;
  std::map<std::uint32_t, SharedFoxgloveMessage> newest_;
  std::deque<SharedFoxgloveMessage> kept_;
  std::size_t kept_bytes_ = 0;
};

}  // namespace echomap::live_page
