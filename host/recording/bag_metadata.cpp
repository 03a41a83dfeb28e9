// SPDX-License-Identifier: MIT
#include "host/recording/bag_metadata.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace echomap::recording {

void BagMetadata::Span::add(std::uint64_t time_ns) {
  begin_ns = messages == 0 ? time_ns : std::min(begin_ns, time_ns);
  end_ns = std::max(end_ns, time_ns);
  ++messages;
}

void BagMetadata::begin_part(const std::string& file_name) { parts_.push_back({file_name, {}}); }

void BagMetadata::add(std::string_view topic, std::string_view type, std::uint64_t time_ns) {
  auto known = topics_.find(topic);
  if (known == topics_.end()) {
    known = topics_.emplace(std::string(topic), Topic{std::string(type), 0}).first;
  }
  ++known->second.messages;
  span_.add(time_ns);
  if (!parts_.empty()) {
    parts_.back().span.add(time_ns);
  }
}

std::string BagMetadata::yaml() const {
  std::string text = fmt::format(
      "rosbag2_bagfile_information:\n"
      "  version: 5\n"
      "  storage_identifier: mcap\n"
      "  duration:\n"
      "    nanoseconds: {}\n"
      "  starting_time:\n"
      "    nanoseconds_since_epoch: {}\n"
      "  message_count: {}\n"
      "  topics_with_message_count:\n",
      span_.end_ns - span_.begin_ns,
      span_.begin_ns,
      span_.messages);
  for (const auto& [name, topic] : topics_) {
    text += fmt::format(
        "    - topic_metadata:\n"
        "        name: {}\n"
        "        type: {}\n"
        "        serialization_format: cdr\n"
        "        offered_qos_profiles: \"\"\n"
        "      message_count: {}\n",
        name,
        topic.type,
        topic.messages);
  }
  text += "  compression_format: \"\"\n  compression_mode: \"\"\n  relative_file_paths:\n";
  for (const Part& part : parts_) {
    text += fmt::format("    - {}\n", part.file_name);
  }
  text += "  files:\n";
  for (const Part& part : parts_) {
    text += fmt::format(
        "    - path: {}\n"
        "      starting_time:\n"
        "        nanoseconds_since_epoch: {}\n"
        "      duration:\n"
        "        nanoseconds: {}\n"
        "      message_count: {}\n",
        part.file_name,
        part.span.begin_ns,
        part.span.end_ns - part.span.begin_ns,
        part.span.messages);
  }
  return text;
}

}  // namespace echomap::recording
