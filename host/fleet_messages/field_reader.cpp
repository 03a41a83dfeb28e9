// SPDX-License-Identifier: MIT
#include "host/fleet_messages/field_reader.hpp"

#include <algorithm>

#include "host/mqtt/fleet_name.hpp"

namespace echomap::fleet_messages {

void FieldReader::operator()(std::string_view /*name*/, std::string& text) {
  const std::string_view characters = take(read(1));
  if (!refused_ && !mqtt::is_fleet_name(characters)) {
    refuse(RefusedReason::kOutOfRange);
  }
  text = characters;
}

void FieldReader::operator()(std::string_view /*name*/, ContentHash& hash) {
  const std::string_view bytes = take(hash.bytes.size());
  std::copy(bytes.begin(), bytes.end(), hash.bytes.begin());
}

void FieldReader::operator()(std::string_view name, std::vector<ContentHash>& hashes) {
  hashes.resize(read_count(sizeof(ContentHash)));
  for (ContentHash& hash : hashes) {
    (*this)(name, hash);
  }
}

std::optional<RefusedReason> FieldReader::finish() {
  if (!bytes_.empty()) {
    refuse(RefusedReason::kTrailingBytes);
  }
  return refused_;
}

std::uint64_t FieldReader::read(std::size_t size) {
  std::uint64_t value = 0;
  unsigned shift = 0;
  for (const char byte : take(size)) {
    value |= std::uint64_t{static_cast<std::uint8_t>(byte)} << shift;
    shift += 8;
  }
  return value;
}

std::int32_t FieldReader::read_signed(unsigned bits) {
  std::uint64_t zigzag = 0;
  unsigned shift = 0;
  std::uint64_t group = 0x80;
  for (; (group & 0x80U) != 0 && shift < bits; shift += 7) {
    group = read(1);
    zigzag |= (group & 0x7FU) << shift;
  }
  const bool is_longer_than_needed = group == 0 && shift > 7;
  if ((group & 0x80U) != 0 || zigzag >> bits != 0 || is_longer_than_needed) {
    refuse(RefusedReason::kMalformed);
    return 0;
  }
  const auto magnitude = static_cast<std::int32_t>(zigzag >> 1U);
  return (zigzag & 1U) != 0 ? -magnitude - 1 : magnitude;
}

std::size_t FieldReader::read_count(std::size_t element_bytes) {
  const std::uint64_t count = read(2);
  if (count > kMaxElements) {
    refuse(RefusedReason::kMalformed);
  } else if (count * element_bytes > bytes_.size()) {
    refuse(RefusedReason::kCutShort);
  }
  return refused_ ? 0 : count;
}

std::string_view FieldReader::take(std::size_t size) {
  if (!refused_ && size > bytes_.size()) {
    refuse(RefusedReason::kCutShort);
  }
  if (refused_) {
    return {};
  }
  const std::string_view taken = bytes_.substr(0, size);
  bytes_.remove_prefix(size);
  return taken;
}

void FieldReader::refuse(RefusedReason reason) {
  if (!refused_) {
    refused_ = reason;
    bytes_ = {};
  }
}

}  // namespace echomap::fleet_messages
