// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/live_page/history.hpp"
#include "host/live_page/message.hpp"

namespace echomap::live_page {

/// Bytes before a message's body.
constexpr std::size_t kHeaderBytes = 16;

/// The number at that offset, which fails the test where the bytes end before.
template <class Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  Number number{};
  if (offset + sizeof number > bytes.size()) {
    ADD_FAILURE() << bytes.size() << " bytes have nothing at " << offset;
    return number;
  }
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

inline double f64_at(const std::string& bytes, std::size_t offset) {
  return number_at<double>(bytes, offset);
}
inline float f32_at(const std::string& bytes, std::size_t offset) {
  return number_at<float>(bytes, offset);
}
inline std::uint32_t u32_at(const std::string& bytes, std::size_t offset) {
  return number_at<std::uint32_t>(bytes, offset);
}
inline std::int32_t i32_at(const std::string& bytes, std::size_t offset) {
  return number_at<std::int32_t>(bytes, offset);
}
inline unsigned byte_at(const std::string& bytes, std::size_t offset) {
  return number_at<std::uint8_t>(bytes, offset);
}

inline std::string body_of(const Message& message) { return message.bytes.substr(kHeaderBytes); }
inline nlohmann::json json_in(const Message& message) {
  return nlohmann::json::parse(body_of(message));
}

/// Those of one kind that the history keeps, in their order.
inline std::vector<SharedMessage> of_kind(const History& history, MessageKind kind) {
  std::vector<SharedMessage> found;
  for (const SharedMessage& message : history.since(0)) {
    if (message->kind == kind) {
      found.push_back(message);
    }
  }
  return found;
}

/// The same of an answer to `GET .../history`: each message behind its length.
inline std::vector<Message> messages_in(const std::string& encoded) {
  std::vector<Message> messages;
  for (std::size_t at = 0; at < encoded.size();) {
    const std::uint32_t size = u32_at(encoded, at);
    Message message;
    message.bytes = encoded.substr(at + 4, size);
    message.kind = static_cast<MessageKind>(byte_at(message.bytes, 0));
    message.time_s = f64_at(message.bytes, 8);
    messages.push_back(message);
    at += 4 + size;
  }
  return messages;
}

}  // namespace echomap::live_page
