// SPDX-License-Identifier: MIT
#include "host/recording/session_file.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/mcap/crc32.hpp"

namespace echomap::recording {
namespace {

std::uint32_t crc_of_text(const std::string& text, std::uint32_t crc_before) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  return mcap::crc32_of(bytes, crc_before);
}

}  // namespace

std::filesystem::path part_of(const std::filesystem::path& first, std::size_t number) {
  if (number == 0) {
    return first;
  }
  const std::string name = first.stem().string() + "_" + std::to_string(number);
  return first.parent_path() / (name + first.extension().string());
}

void SessionFile::open(const std::filesystem::path& path, std::uint64_t split_bytes) {
  path_ = path;
  split_bytes_ = split_bytes;
  session_id_ = session_id();
  try {
    begin_part();
  } catch (const files::FileError&) {
    path_.clear();
    throw;
  }
  write_waiting();
}

/// Other facts, or another instant, are another session.
std::string SessionFile::session_id() const {
  std::uint32_t crc = 0;
  for (const auto& [name, facts] : facts_) {
    for (const auto& [key, value] : facts) {
      for (const std::string& text : {name, key, value}) {
        crc = crc_of_text(text, crc);
      }
    }
  }
  const std::uint64_t begin_ns = waiting_.empty() ? 0 : waiting_.front().time_ns;
  return fmt::format("{:08x}-{:x}", crc, begin_ns);
}

void SessionFile::begin_part() {
  const std::filesystem::path part = part_of(path_, parts_);
  auto writer = std::make_unique<mcap::McapWriter>(
      mcap::HeaderInfo{"ros2", std::string(kWriterName) + " " ECHOMAP_VERSION}, params_);
  for (const auto& [name, facts] : facts_) {
    writer->add_metadata({name, facts});
  }
  writer->add_metadata(
      {kPartMetadata, {{"session", session_id_}, {"number", std::to_string(parts_)}}});
  for (const mcap::Attachment& attachment : attachments_) {
    writer->attach(attachment);
  }
  writer->open(part);
  writer_ = std::move(writer);
  ++parts_;
  schemas_.clear();
  channels_.clear();
  contents_.begin_part(part.filename().string());
}

void SessionFile::end_part_if_due() {
  if (writer_ && split_bytes_ > 0 && writer_->bytes_written() >= split_bytes_) {
    writer_->finish();
    writer_.reset();
  }
}

void SessionFile::listen(TopicListener* listener) {
  listener_ = listener;
  told_topics_.clear();
}

void SessionFile::add(Waiting message) {
  if (listener_ != nullptr) {
    tell(message);
  }
  waiting_.push_back(std::move(message));
  write_waiting();
}

void SessionFile::tell(const Waiting& message) {
  const auto id = static_cast<std::uint32_t>(told_topics_.size() + 1);
  const auto [topic, is_new] = told_topics_.try_emplace(message.topic, id);
  if (is_new) {
    listener_->on_topic({id, message.topic, std::string(message.type), message.definition()});
  }
  listener_->on_message(topic->second, message.time_ns, message.data);
}

void SessionFile::write_waiting() {
  while (!path_.empty() && !waiting_.empty()) {
    end_part_if_due();
    if (!writer_) {
      begin_part();
    }
    const std::uint16_t channel = channel_of(waiting_.front());
    // The writer keeps what it is given, also where it throws.
    const Waiting message = std::move(waiting_.front());
    waiting_.pop_front();
    contents_.add(message.topic, message.type, message.time_ns);
    writer_->write(channel, message.time_ns, message.time_ns, message.data);
  }
}

std::uint16_t SessionFile::channel_of(const Waiting& message) {
  const auto known = channels_.find(message.topic);
  if (known != channels_.end()) {
    return known->second;
  }
  auto schema = schemas_.find(message.type);
  if (schema == schemas_.end()) {
    const std::uint16_t id =
        writer_->add_schema({std::string(message.type), "ros2msg", message.definition()});
    schema = schemas_.emplace(std::string(message.type), id).first;
  }
  // ROS 2 asks for the key; empty means its defaults.
  const std::uint16_t channel =
      writer_->add_channel({message.topic, schema->second, "cdr", {{"offered_qos_profiles", ""}}});
  channels_.emplace(message.topic, channel);
  return channel;
}

void SessionFile::flush() {
  write_waiting();
  if (writer_) {
    writer_->flush();
  }
}

void SessionFile::attach(const mcap::Attachment& attachment) {
  flush();
  writer_->attach(attachment);
}

void SessionFile::add_metadata(const std::string& name, const mcap::TextMap& facts) {
  flush();
  writer_->add_metadata({name, facts});
}

void SessionFile::finish() {
  if (path_.empty()) {
    throw std::logic_error("SessionFile::finish: it was never opened");
  }
  write_waiting();
  if (writer_) {
    writer_->finish();
  }
  files::write_text_file(path_.parent_path() / kBagMetadataName, contents_.yaml());
}

}  // namespace echomap::recording
