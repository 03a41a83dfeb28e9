// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/mcap/mcap_writer.hpp"
#include "host/recording/bag_metadata.hpp"
#include "host/recording/topic_listener.hpp"
#include "host/ros_messages/message_definition.hpp"
#include "host/ros_messages/serialization.hpp"

namespace echomap::recording {

/// Name of a session's file in a run directory.
inline constexpr const char* kSessionFileName = "session.mcap";
/// What the header of a session's file names as its writer, the version behind it.
inline constexpr std::string_view kWriterName = "echomap";
/// The metadata by which the files of one session know each other: `session`, the same in all, and
/// `number`, from 0 on.
inline constexpr const char* kPartMetadata = "part";

/// The file of that number of a session whose first one is `first`: session.mcap, session_1.mcap,
/// session_2.mcap, ...
std::filesystem::path part_of(const std::filesystem::path& first, std::size_t number);

/// An MCAP file of ROS 2 messages, or several where it is split: each is whole and says what the
/// session is. Until `open`, and while the disk is full, messages wait in memory.
class SessionFile {
 public:
  explicit SessionFile(const mcap::McapWriterParams& params = {}) : params_(params) {}
  SessionFile(const SessionFile&) = delete;
  SessionFile& operator=(const SessionFile&) = delete;

  /// Says what the session is, at the head of each file. Before `open`.
  void describe(const std::string& name, const mcap::TextMap& facts) { facts_[name] = facts; }
  void describe(const mcap::Attachment& attachment) { attachments_.push_back(attachment); }

  /// Names the first file, which is made. A file of at least `split_bytes` is ended and another one
  /// begun; 0: never. Throws files::FileError.
  void open(const std::filesystem::path& path, std::uint64_t split_bytes = 0);

  /// The listener hears of all messages from now on, before they are in a file. Null for nobody;
  /// else it outlives this.
  void listen(TopicListener* listener);

  /// Throws files::FileError where what is due cannot be written; it is tried again with the next.
  template <class M>
  void write(std::string_view topic, std::uint64_t time_ns, const M& message) {
    add({std::string(topic),
         M::kName,
         &ros_messages::message_definition<M>,
         time_ns,
         ros_messages::serialize(message)});
  }

  /// Hands everything so far to the system. Throws files::FileError.
  void flush();
  /// Both add to the current file, behind all messages so far. They throw files::FileError.
  void attach(const mcap::Attachment& attachment);
  void add_metadata(const std::string& name, const mcap::TextMap& facts);
  /// Ends the file, and writes metadata.yaml beside it. Nothing may be written after. Throws
  /// files::FileError; it may then be called again.
  void finish();

 private:
  struct Waiting {
    std::string topic;
    std::string_view type;
    std::string (*definition)();
    std::uint64_t time_ns = 0;
    std::vector<std::uint8_t> data;
  };

  void add(Waiting message);
  void tell(const Waiting& message);
  void write_waiting();
  /// Makes the next file and writes its head.
  void begin_part();
  void end_part_if_due();
  std::uint16_t channel_of(const Waiting& message);
  std::string session_id() const;

  mcap::McapWriterParams params_;
  std::filesystem::path path_;
  std::uint64_t split_bytes_ = 0;
  std::map<std::string, mcap::TextMap> facts_;
  std::vector<mcap::Attachment> attachments_;  ///< At the head of each file.
  std::deque<Waiting> waiting_;
  TopicListener* listener_ = nullptr;
  std::map<std::string, std::uint32_t, std::less<>> told_topics_;
  std::unique_ptr<mcap::McapWriter> writer_;  ///< Of the current file; null between two.
  std::size_t parts_ = 0;
  std::string session_id_;
  std::map<std::string, std::uint16_t, std::less<>> schemas_;
  std::map<std::string, std::uint16_t, std::less<>> channels_;
  BagMetadata contents_;
};

}  // namespace echomap::recording
