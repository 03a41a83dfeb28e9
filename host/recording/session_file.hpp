// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/mcap/mcap_writer.hpp"
#include "host/recording/bag_metadata.hpp"
#include "host/ros_messages/message_definition.hpp"
#include "host/ros_messages/serialization.hpp"

namespace echomap::recording {

/// Name of a session's file in a run directory.
inline constexpr const char* kSessionFileName = "session.mcap";
/// What the header of a session's file names as its writer, the version behind it.
inline constexpr std::string_view kWriterName = "echomap";

/// The file of that number of a session whose first one is `first`: session.mcap, session_1.mcap,
/// session_2.mcap, ...
std::filesystem::path part_of(const std::filesystem::path& first, std::size_t number);

/// An MCAP file of ROS 2 messages, or several where it is split: each is whole and says what the
/// session is. Until `open` everything is in memory.
class SessionFile {
 public:
  explicit SessionFile(const mcap::McapWriterParams& params = {});
  SessionFile(const SessionFile&) = delete;
  SessionFile& operator=(const SessionFile&) = delete;

  /// Names the first file, which is made. A file of at least `split_bytes` is ended and another one
  /// begun; 0: never. Throws files::FileError.
  void open(const std::filesystem::path& path, std::uint64_t split_bytes = 0);

  /// Throws files::FileError where what is due cannot be written; it is tried again with the next.
  template <class M>
  void write(std::string_view topic, std::uint64_t time_ns, const M& message) {
    split_if_due();
    ros_messages::serialize(message, buffer_);
    const std::uint16_t channel = channel_of(topic, M::kName, &ros_messages::message_definition<M>);
    contents_.add(topic, M::kName, time_ns);
    writer_->write(channel, time_ns, time_ns, buffer_);
  }

  /// Says what the session is, at the head of each file.
  void describe(const std::string& name, const std::map<std::string, std::string>& facts);
  void describe(const mcap::Attachment& attachment);
  /// Adds something to the current file.
  void attach(const mcap::Attachment& attachment) { writer_->attach(attachment); }
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& facts) {
    writer_->add_metadata({name, facts});
  }

  /// Hands everything so far to the system.
  void flush() { writer_->flush(); }
  /// Ends the file, and writes metadata.yaml beside it. Nothing may be written after.
  void finish();

 private:
  std::unique_ptr<mcap::McapWriter> new_writer() const;
  std::uint16_t channel_of(std::string_view topic,
                           std::string_view type,
                           std::string (*definition)());
  void split_if_due();

  mcap::McapWriterParams params_;
  std::uint64_t split_bytes_ = 0;
  std::unique_ptr<mcap::McapWriter> writer_;
  std::filesystem::path path_;
  std::size_t parts_ = 1;
  std::map<std::string, std::map<std::string, std::string>> facts_;
  std::vector<mcap::Attachment> attachments_;  ///< At the head of each file.
  std::map<std::string, std::uint16_t, std::less<>> schemas_;
  std::map<std::string, std::uint16_t, std::less<>> channels_;
  std::vector<std::uint8_t> buffer_;
  BagMetadata contents_;
};

}  // namespace echomap::recording
