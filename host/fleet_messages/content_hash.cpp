// SPDX-License-Identifier: MIT
#include "host/fleet_messages/content_hash.hpp"

#include <algorithm>
#include <cstring>

#include <openssl/sha.h>

namespace echomap::fleet_messages {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

}  // namespace

ContentHash content_hash(std::string_view bytes) {
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), digest.data());
  ContentHash hash;
  std::copy_n(digest.begin(), hash.bytes.size(), hash.bytes.begin());
  return hash;
}

ContentHash set_hash(std::vector<ContentHash> objects) {
  std::sort(objects.begin(), objects.end());
  std::string names;
  names.reserve(objects.size() * sizeof(ContentHash));
  for (const ContentHash& object : objects) {
    names.append(object.bytes.begin(), object.bytes.end());
  }
  return content_hash(names);
}

std::string hex(const ContentHash& hash) {
  std::string text;
  for (const std::uint8_t byte : hash.bytes) {
    text += kHexDigits[byte / 16U];
    text += kHexDigits[byte % 16U];
  }
  return text;
}

std::optional<ContentHash> parse_hash(std::string_view text) {
  ContentHash hash;
  if (text.size() != 2 * hash.bytes.size()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t digit = kHexDigits.find(text[i]);
    if (digit == std::string_view::npos) {
      return std::nullopt;
    }
    std::uint8_t& byte = hash.bytes[i / 2];
    byte = static_cast<std::uint8_t>(byte * 16U + digit);
  }
  return hash;
}

std::size_t ContentHashBucket::operator()(const ContentHash& hash) const {
  std::size_t bucket = 0;
  std::memcpy(&bucket, hash.bytes.data(), sizeof(bucket));
  return bucket;
}

}  // namespace echomap::fleet_messages
