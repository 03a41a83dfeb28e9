// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "host/mcap/mcap_reader.hpp"
#include "host/recording/session_event.hpp"
#include "host/recording/session_messages.hpp"

namespace echomap::recording {

/// A frame on the line, and in which direction it went.
struct RecordedFrame {
  bool is_sent = false;  ///< From the host to the robot.
  LineFrame frame;
};

/// What a replay takes of a session, in the order in which it happened.
using SessionEntry = std::variant<RecordedFrame, SessionEvent>;

/// Whether the file is the recording of a session of echomap. Throws files::FileError where it
/// cannot be read or is no MCAP file.
bool is_session_file(const std::filesystem::path& path);

/// Reads a session's file, and those that it was split into, from beginning to end.
class SessionReader {
 public:
  /// `path` is the first file. Throws files::FileError where it is not the recording of a session.
  explicit SessionReader(const std::filesystem::path& path);

  /// The next entry; empty at the end. Throws files::FileError where the file is damaged, and
  /// mcap::CutOffFile where it ends early: everything before has been read.
  std::optional<SessionEntry> next();
  /// Reads on to the end for what stands there, whatever comes before it. Does not throw.
  void read_ending();

  /// Log time of the last entry, nanoseconds.
  std::uint64_t time_ns() const { return time_ns_; }
  /// Seconds of the recording at the last entry, without the pauses between its sessions.
  double elapsed_s() const;

  /// What is wrong with the head of the file; empty where nothing is.
  const std::string& head_damage() const { return head_damage_; }
  /// A fact of the metadata of that name that was read so far; empty where there is none.
  std::string fact(const std::string& metadata, const std::string& key) const;
  /// The attachment of that name that was read so far.
  std::optional<std::string> attachment(const std::string& name) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  /// Reads the head: what stands before the first message.
  void read_head();
  /// Goes on with the next file, if there is one and it is of the same session.
  bool open_next_part();
  /// The next record, valid until the next call; null at the end.
  const mcap::Record* next_record();
  std::optional<SessionEntry> entry_of(const mcap::Message& message);
  void keep(const mcap::Record& record);

  std::filesystem::path path_;
  std::size_t part_ = 0;
  std::unique_ptr<mcap::McapReader> reader_;
  std::optional<mcap::Record> record_;  ///< The last.
  bool is_read_ahead_ = false;          ///< With the head.
  std::string head_damage_;
  std::uint64_t time_ns_ = 0;
  std::optional<std::uint64_t> begin_ns_;
  std::uint64_t pauses_ns_ = 0;  ///< Between the sessions so far.
  std::map<std::string, std::map<std::string, std::string>> metadata_;
  std::map<std::string, std::string> attachments_;
};

}  // namespace echomap::recording
