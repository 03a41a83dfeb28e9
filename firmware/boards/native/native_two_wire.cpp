// SPDX-License-Identifier: MIT
#include "firmware/boards/native/native_two_wire.hpp"

#include <limits>

namespace echomap {
namespace native {

using hal::TwiState;

void NativeTwoWire::start_write(std::int64_t now_ns,
                                std::uint8_t address,
                                std::uint8_t device_register,
                                std::uint8_t value) {
  const bool answered = on_write && on_write(address, device_register, value);
  end(now_ns + (answered ? kWriteNs : kRefusedNs), answered);
}

void NativeTwoWire::start_read(std::int64_t now_ns,
                               std::uint8_t address,
                               std::uint8_t device_register) {
  const std::optional<std::int16_t> word =
      on_read ? on_read(address, device_register) : std::nullopt;
  value_ = word.value_or(0);
  end(now_ns + (word ? kReadNs : kRefusedNs), word.has_value());
}

TwiState NativeTwoWire::state(std::int64_t now_ns, std::int16_t& value) const {
  if (state_ != TwiState::kIdle && now_ns < end_ns_) {
    return TwiState::kBusy;
  }
  if (state_ == TwiState::kDone) {
    value = value_;
  }
  return state_;
}

void NativeTwoWire::end(std::int64_t end_ns, bool answered) {
  state_ = answered ? TwiState::kDone : TwiState::kFailed;
  end_ns_ = held ? std::numeric_limits<std::int64_t>::max() : end_ns;
}

}  // namespace native
}  // namespace echomap
