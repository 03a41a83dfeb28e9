// SPDX-License-Identifier: MIT
#include "host/ros_messages/cdr_writer.hpp"

#include <bit>
#include <iterator>
#include <limits>
#include <string>

#include "host/ros_messages/cdr_error.hpp"

namespace echomap::ros_messages {

CdrWriter::CdrWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {
  bytes_.assign({0x00, 0x01, 0x00, 0x00});
}

void CdrWriter::write_numbers(const void* numbers, std::size_t count, std::size_t size) {
  if (count == 0) {
    return;
  }
  const std::size_t padding = (size - (bytes_.size() - kHeaderBytes) % size) % size;
  bytes_.resize(bytes_.size() + padding);
  const auto* first = static_cast<const std::uint8_t*>(numbers);
  if constexpr (std::endian::native == std::endian::little) {
    bytes_.insert(bytes_.end(), first, first + count * size);
  } else {
    for (const auto* number = first; number != first + count * size; number += size) {
      bytes_.insert(bytes_.end(),
                    std::make_reverse_iterator(number + size),
                    std::make_reverse_iterator(number));
    }
  }
}

void CdrWriter::write_count(std::size_t count) {
  if (count > std::numeric_limits<std::uint32_t>::max()) {
    throw CdrError("a sequence of " + std::to_string(count) + " elements is too long for CDR");
  }
  write(static_cast<std::uint32_t>(count));
}

void CdrWriter::write_text(std::string_view text) {
  write_count(text.size() + 1);
  bytes_.insert(bytes_.end(), text.begin(), text.end());
  bytes_.push_back(0);
}

}  // namespace echomap::ros_messages
