// SPDX-License-Identifier: MIT
#include "host/recording/session_file.hpp"

#include <utility>

#include "host/files/atomic_file.hpp"

namespace echomap::recording {

std::filesystem::path part_of(const std::filesystem::path& first, std::size_t number) {
  if (number == 0) {
    return first;
  }
  const std::string name = first.stem().string() + "_" + std::to_string(number);
  return first.parent_path() / (name + first.extension().string());
}

SessionFile::SessionFile(const mcap::McapWriterParams& params)
    : params_(params), writer_(new_writer()) {
  contents_.begin_part(kSessionFileName);
}

std::unique_ptr<mcap::McapWriter> SessionFile::new_writer() const {
  return std::make_unique<mcap::McapWriter>(
      mcap::HeaderInfo{"ros2", std::string(kWriterName) + " " ECHOMAP_VERSION}, params_);
}

void SessionFile::open(const std::filesystem::path& path, std::uint64_t split_bytes) {
  path_ = path;
  split_bytes_ = split_bytes;
  writer_->open(path);
}

std::uint16_t SessionFile::channel_of(std::string_view topic,
                                      std::string_view type,
                                      std::string (*definition)()) {
  const auto known = channels_.find(topic);
  if (known != channels_.end()) {
    return known->second;
  }
  auto schema = schemas_.find(type);
  if (schema == schemas_.end()) {
    const std::uint16_t id = writer_->add_schema({std::string(type), "ros2msg", definition()});
    schema = schemas_.emplace(std::string(type), id).first;
  }
  // ROS 2 asks for the key; empty means its defaults.
  const std::uint16_t channel = writer_->add_channel(
      {std::string(topic), schema->second, "cdr", {{"offered_qos_profiles", ""}}});
  channels_.emplace(std::string(topic), channel);
  return channel;
}

void SessionFile::describe(const std::string& name,
                           const std::map<std::string, std::string>& facts) {
  facts_[name] = facts;
  writer_->add_metadata({name, facts});
}

void SessionFile::describe(const mcap::Attachment& attachment) {
  attachments_.push_back(attachment);
  writer_->attach(attachment);
}

void SessionFile::split_if_due() {
  if (split_bytes_ == 0 || path_.empty() || writer_->bytes_written() < split_bytes_) {
    return;
  }
  writer_->finish();
  writer_ = new_writer();
  schemas_.clear();
  channels_.clear();
  for (const auto& [name, facts] : facts_) {
    writer_->add_metadata({name, facts});
  }
  for (const mcap::Attachment& attachment : attachments_) {
    writer_->attach(attachment);
  }
  const std::filesystem::path part = part_of(path_, parts_++);
  contents_.begin_part(part.filename().string());
  writer_->open(part);
}

void SessionFile::finish() {
  writer_->finish();
  files::write_text_file(path_.parent_path() / kBagMetadataName, contents_.yaml());
}

}  // namespace echomap::recording
