// SPDX-License-Identifier: MIT
#include "hil_mock/runner/outgoing_bytes.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <unistd.h>

namespace echomap::runner {
namespace {

constexpr std::size_t kMaxUnread = 4096;

}  // namespace

void OutgoingBytes::push(std::span<const std::uint8_t> bytes) {
  std::size_t taken = bytes.size();
  if (when_unread_ == WhenUnread::kDrop) {
    taken = std::min(taken, kMaxUnread - std::min(kMaxUnread, bytes_.size()));
    dropped_ += bytes.size() - taken;
  }
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(taken));
}

bool OutgoingBytes::write_to(int descriptor) {
  while (!bytes_.empty()) {
    std::array<std::uint8_t, 512> chunk{};
    const std::size_t size = std::min(chunk.size(), bytes_.size());
    std::copy_n(bytes_.begin(), size, chunk.begin());
    const ssize_t written = ::write(descriptor, chunk.data(), size);
    if (written < 0) {
      return errno == EAGAIN || errno == EINTR;
    }
    bytes_.erase(bytes_.begin(), bytes_.begin() + written);
  }
  return true;
}

void OutgoingBytes::discard() {
  dropped_ += bytes_.size();
  bytes_.clear();
}

}  // namespace echomap::runner
