// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/usb_control.hpp"

namespace echomap {
namespace boards {
namespace usb {
namespace {

constexpr Step kWaitForSetup{Next::kWait, Effect::kNone, {nullptr, 0}, 0};
constexpr Step kReceivePacket{Next::kReceive, Effect::kNone, {nullptr, 0}, 0};
constexpr uint8_t kLastAddress = 127;

uint16_t word(const uint8_t* bytes) { return static_cast<uint16_t>(bytes[0] | bytes[1] << 8); }

}  // namespace

bool ControlTransfers::halted(uint8_t endpoint) const {
  return endpoint == (kToHost | kNotificationEndpoint) ? halts_[0] != 0
         : endpoint == (kToHost | kDataEndpoint)       ? halts_[1] != 0
         : endpoint == kDataEndpoint                   ? halts_[2] != 0
                                                       : false;
}

uint8_t* ControlTransfers::halt_of(uint16_t endpoint) {
  switch (endpoint) {
    case kToHost | kNotificationEndpoint:
      return &halts_[0];
    case kToHost | kDataEndpoint:
      return &halts_[1];
    case kDataEndpoint:
      return &halts_[2];
    default:
      return nullptr;
  }
}

Step ControlTransfers::on_setup(const uint8_t (&setup)[8]) {
  const Request request{setup[0], setup[1], word(setup + 2), word(setup + 4), word(setup + 6)};
  stage_ = Stage::kIdle;
  next_address_ = address_;
  const uint8_t type = request.type & kTypeMask;
  if (type == kStandard) {
    return standard(request);
  }
  if (type == kClass && (request.type & kRecipientMask) == kOfInterface &&
      request.index == kControlInterface) {
    return to_port(request);
  }
  return refuse();
}

Step ControlTransfers::on_sent() {
  if (stage_ == Stage::kSendData) {
    if (left_.size != 0 || ends_with_empty_) {
      return send_packet();
    }
    stage_ = Stage::kReceiveStatus;
    return kReceivePacket;
  }
  const bool was_status = stage_ == Stage::kSendStatus;
  stage_ = Stage::kIdle;
  Step step = kWaitForSetup;
  if (was_status && next_address_ != address_) {
    address_ = next_address_;
    step.effect = Effect::kAddress;
  }
  return step;
}

Step ControlTransfers::on_received(Bytes packet) {
  if (stage_ != Stage::kReceiveData) {
    stage_ = Stage::kIdle;
    return kWaitForSetup;
  }
  if (packet.size != kLineCodingBytes) {
    return refuse();
  }
  for (uint8_t i = 0; i < kLineCodingBytes; ++i) {
    line_coding_[i] = packet.data[i];
  }
  return acknowledge();
}

Step ControlTransfers::standard(const Request& request) {
  switch (request.type & kRecipientMask) {
    case kOfDevice:
      return to_device(request);
    case kOfInterface:
      return to_interface(request);
    case kOfEndpoint:
      return to_endpoint(request);
    default:
      return refuse();
  }
}

Step ControlTransfers::to_device(const Request& request) {
  switch (request.request) {
    case kGetStatus:
      return answer(request, 0, 0, 2);
    case kSetAddress:
      if (request.value > kLastAddress) {
        return refuse();
      }
      next_address_ = static_cast<uint8_t>(request.value);
      return acknowledge();
    case kGetDescriptor:
      return answer(request,
                    descriptor(static_cast<uint8_t>(request.value >> 8),
                               static_cast<uint8_t>(request.value)));
    case kGetConfiguration:
      return answer(request, configuration_, 0, 1);
    case kSetConfiguration:
      if (request.value > 1) {
        return refuse();
      }
      configuration_ = static_cast<uint8_t>(request.value);
      terminal_ready_ = false;
      halts_[0] = halts_[1] = halts_[2] = 0;
      return acknowledge(Effect::kConfigure);
    default:
      return refuse();
  }
}

/// Each interface has one setting.
Step ControlTransfers::to_interface(const Request& request) {
  if (!is_configured() || request.index > kDataInterface) {
    return refuse();
  }
  switch (request.request) {
    case kGetStatus:
      return answer(request, 0, 0, 2);
    case kGetInterface:
      return answer(request, 0, 0, 1);
    case kSetInterface:
      return request.value == 0 ? acknowledge() : refuse();
    default:
      return refuse();
  }
}

Step ControlTransfers::to_endpoint(const Request& request) {
  const bool of_control = (request.index & ~uint16_t{kToHost}) == 0;
  if (of_control && request.request == kGetStatus) {
    return answer(request, 0, 0, 2);
  }
  uint8_t* const halt = is_configured() ? halt_of(request.index) : nullptr;
  if (halt == nullptr) {
    return refuse();
  }
  if (request.request == kGetStatus) {
    return answer(request, *halt, 0, 2);
  }
  if (request.value != kHaltFeature ||
      (request.request != kSetFeature && request.request != kClearFeature)) {
    return refuse();
  }
  *halt = request.request == kSetFeature ? 1 : 0;
  return acknowledge(Effect::kHalt, static_cast<uint8_t>(request.index));
}

/// The bit rate is kept for the host to read back: this line has its own.
Step ControlTransfers::to_port(const Request& request) {
  switch (request.request) {
    case kSetLineCoding:
      if (request.length != kLineCodingBytes) {
        return refuse();
      }
      stage_ = Stage::kReceiveData;
      return kReceivePacket;
    case kGetLineCoding:
      return answer(request, {line_coding_, kLineCodingBytes});
    case kSetControlLineState:
      terminal_ready_ = (request.value & kDataTerminalReady) != 0;
      return acknowledge();
    default:
      return refuse();
  }
}

Step ControlTransfers::answer(const Request& request, Bytes bytes) {
  if (bytes.size == 0 || (request.type & kToHost) == 0) {
    return refuse();
  }
  if (request.length == 0) {
    return acknowledge();
  }
  left_ = bytes;
  ends_with_empty_ = request.length > bytes.size && bytes.size % kControlPacketBytes == 0;
  if (request.length < bytes.size) {
    left_.size = static_cast<uint8_t>(request.length);
  }
  stage_ = Stage::kSendData;
  return send_packet();
}

Step ControlTransfers::answer(const Request& request, uint8_t first, uint8_t second, uint8_t size) {
  reply_[0] = first;
  reply_[1] = second;
  return answer(request, {reply_, size});
}

Step ControlTransfers::acknowledge(Effect effect, uint8_t endpoint) {
  stage_ = Stage::kSendStatus;
  return {Next::kSend, effect, {nullptr, 0}, endpoint};
}

Step ControlTransfers::send_packet() {
  const uint8_t size = left_.size < kControlPacketBytes ? left_.size : kControlPacketBytes;
  if (size == 0) {
    ends_with_empty_ = false;
  }
  const Bytes packet{left_.data, size};
  left_ = {left_.data + size, static_cast<uint8_t>(left_.size - size)};
  return {Next::kSend, Effect::kNone, packet, 0};
}

Step ControlTransfers::refuse() {
  stage_ = Stage::kIdle;
  return {Next::kStall, Effect::kNone, {nullptr, 0}, 0};
}

}  // namespace usb
}  // namespace boards
}  // namespace echomap
