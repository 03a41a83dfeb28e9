// SPDX-License-Identifier: MIT
#include <iterator>

#include "protocol/messages.hpp"
#include "protocol/schema_reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

namespace protocol = echomap::protocol;

constexpr auto kDescription = protocol::describe_schema<protocol::AllMessages>();

}  // namespace

/// The description of this program's messages, whole and by its beginnings.
std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  std::vector<Input> seeds;
  for (std::size_t size = 1; size <= std::size(kDescription.bytes); size *= 2) {
    seeds.emplace_back(kDescription.bytes, kDescription.bytes + size);
  }
  seeds.emplace_back(std::begin(kDescription.bytes), std::end(kDescription.bytes));
  return seeds;
}

/// One input is a description as another robot may send it, in a heap block of its own.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::uint8_t> bytes(data, data + std::min<std::size_t>(size, UINT16_MAX));
  protocol::SchemaReader reader(bytes.data(), static_cast<std::uint16_t>(bytes.size()));
  for (std::size_t items = 0; items <= bytes.size(); ++items) {
    const protocol::SchemaItem item = reader.next();
    if (item == protocol::SchemaItem::kEnd || item == protocol::SchemaItem::kMalformed) {
      return 0;
    }
    const std::size_t length = std::string_view(reader.name()).size();
    echomap::fuzz::require(length >= 1 && length <= protocol::SchemaFormat::kMaxName,
                           "a name has 1 .. 31 characters");
  }
  echomap::fuzz::require(false, "every item takes a byte");
  return 0;
}
