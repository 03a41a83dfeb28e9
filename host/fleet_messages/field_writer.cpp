// SPDX-License-Identifier: MIT
#include "host/fleet_messages/field_writer.hpp"

#include "host/mqtt/fleet_name.hpp"

namespace echomap::fleet_messages {

void FieldWriter::operator()(std::string_view /*name*/, const std::string& text) {
  fits_ = fits_ && mqtt::is_fleet_name(text);
  put(text.size(), 1);
  bytes_ += text;
}

void FieldWriter::operator()(std::string_view /*name*/, const ContentHash& hash) {
  bytes_.append(hash.bytes.begin(), hash.bytes.end());
}

void FieldWriter::operator()(std::string_view name, const std::vector<ContentHash>& hashes) {
  put_count(hashes.size());
  for (const ContentHash& hash : hashes) {
    (*this)(name, hash);
  }
}

void FieldWriter::put(std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes_ += static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

void FieldWriter::put_count(std::size_t count) {
  fits_ = fits_ && count <= kMaxElements;
  put(count, 2);
}

void FieldWriter::put_signed(std::int32_t value) {
  const auto sign = static_cast<std::uint32_t>(value < 0 ? -1 : 0);
  std::uint32_t rest = (static_cast<std::uint32_t>(value) << 1U) ^ sign;
  for (; rest >= 0x80U; rest >>= 7U) {
    bytes_ += static_cast<char>(static_cast<std::uint8_t>(rest | 0x80U));
  }
  bytes_ += static_cast<char>(static_cast<std::uint8_t>(rest));
}

}  // namespace echomap::fleet_messages
