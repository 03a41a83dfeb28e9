// SPDX-License-Identifier: MIT
#include "host/recording/session_reader.hpp"

#include <algorithm>
#include <utility>

#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"
#include "host/ros_messages/serialization.hpp"

namespace echomap::recording {
namespace {

bool is_of_echomap(const mcap::HeaderInfo& header) {
  return header.library.starts_with(kWriterName);
}

}  // namespace

bool is_session_file(const std::filesystem::path& path) {
  return path.extension() == ".mcap" && is_of_echomap(mcap::McapReader(path).header());
}

SessionReader::SessionReader(const std::filesystem::path& path)
    : path_(path), reader_(std::make_unique<mcap::McapReader>(path)) {
  if (!is_of_echomap(reader_->header())) {
    throw files::FileError(path.string() + ": not the recording of a session of echomap, but of '" +
                           reader_->header().library + "'\n  next: --format ros2-bag maps a bag");
  }
  read_head();
}

void SessionReader::read_head() {
  try {
    const mcap::Record* record = next_record();
    while (record != nullptr && !std::holds_alternative<mcap::Message>(*record)) {
      keep(*record);
      record = next_record();
    }
    is_read_ahead_ = record != nullptr;
  } catch (const files::FileError& error) {
    head_damage_ = error.what();  // The reader throws it again at the next record.
  }
}

bool SessionReader::open_next_part() {
  const std::filesystem::path next = part_of(path_, part_ + 1);
  const std::string session = fact(kPartMetadata, "session");
  if (session.empty() || !std::filesystem::exists(next)) {
    return false;
  }
  auto reader = std::make_unique<mcap::McapReader>(next);
  const mcap::TextMap expected{{"session", session}, {"number", std::to_string(part_ + 1)}};
  for (auto record = reader->next(); record; record = reader->next()) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    const auto* metadata = std::get_if<mcap::Metadata>(&*record);
    if (metadata != nullptr && metadata->name == kPartMetadata) {
      if (metadata->entries != expected) {
        return false;
      }
      reader_ = std::move(reader);
      ++part_;
      return true;
    }
  }
  return false;
}

const mcap::Record* SessionReader::next_record() {
  if (!std::exchange(is_read_ahead_, false)) {
    record_ = reader_->next();
    while (!record_ && open_next_part()) {
      record_ = reader_->next();
    }
  }
  return record_ ? &*record_ : nullptr;
}

void SessionReader::keep(const mcap::Record& record) {
  if (const auto* metadata = std::get_if<mcap::Metadata>(&record)) {
    metadata_[metadata->name] = metadata->entries;
  } else if (const auto* attachment = std::get_if<mcap::Attachment>(&record)) {
    attachments_[attachment->name] = {attachment->data.begin(), attachment->data.end()};
  }
}

std::optional<SessionEntry> SessionReader::next() {
  while (const mcap::Record* const record = next_record()) {
    if (const auto* message = std::get_if<mcap::Message>(record)) {
      if (auto entry = entry_of(*message)) {
        return entry;
      }
    } else {
      keep(*record);
    }
  }
  return std::nullopt;
}

void SessionReader::read_ending() {
  try {
    while (const mcap::Record* const record = next_record()) {
      keep(*record);
    }
  } catch (const files::FileError&) {
    return;  // Whoever needs the ending finds that it is not there.
  }
}

std::optional<SessionEntry> SessionReader::entry_of(const mcap::Message& message) {
  const std::uint64_t last_ns = std::exchange(time_ns_, message.log_time_ns);
  begin_ns_ = begin_ns_.value_or(time_ns_);
  const std::string& topic = message.channel->info.topic;
  try {
    if (topic == kReceivedTopic || topic == kSentTopic) {
      return RecordedFrame{topic == kSentTopic, ros_messages::deserialize<LineFrame>(message.data)};
    }
    if (topic != kEventTopic) {
      return std::nullopt;
    }
    const auto event = ros_messages::deserialize<SessionEventMessage>(message.data);
    if (const auto kind = event_kind(event.kind)) {
      if (kind == SessionEventKind::kBeginSession && last_ns != 0) {
        pauses_ns_ += time_ns_ - std::min(time_ns_, last_ns);
      }
      return SessionEvent{*kind, event.value, {event.pose.x, event.pose.y, event.pose.theta}};
    }
    throw files::FileError("'" + event.kind + "' is no event of a session");
  } catch (const std::runtime_error& error) {
    throw files::FileError(path_.string() + ": a message of " + topic + " at " +
                           std::to_string(elapsed_s()) + " s is damaged: " + error.what());
  }
}

double SessionReader::elapsed_s() const {
  const std::uint64_t begin_ns = begin_ns_.value_or(0) + pauses_ns_;
  return 1e-9 * static_cast<double>(time_ns_ - std::min(time_ns_, begin_ns));
}

std::string SessionReader::fact(const std::string& metadata, const std::string& key) const {
  const auto facts = metadata_.find(metadata);
  if (facts == metadata_.end()) {
    return "";
  }
  const auto fact = facts->second.find(key);
  return fact == facts->second.end() ? "" : fact->second;
}

std::optional<std::string> SessionReader::attachment(const std::string& name) const {
  const auto found = attachments_.find(name);
  return found == attachments_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace echomap::recording
