// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/control_pipe.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace echomap::rp2040 {
namespace {

/// Linux gives a control transfer up after five seconds, a device's first after less.
constexpr std::int64_t kPatienceNs = 500'000'000;
constexpr std::uint8_t kFirstMaxPacket = 8;
constexpr std::uint8_t kSetAddress = 5;

std::vector<std::uint8_t> packet_of(const UsbRequest& request) {
  const auto low = [](std::uint16_t word) { return static_cast<std::uint8_t>(word & 0xFF); };
  const auto high = [](std::uint16_t word) { return static_cast<std::uint8_t>(word >> 8); };
  return {request.type,
          request.request,
          low(request.value),
          high(request.value),
          low(request.index),
          high(request.index),
          low(request.length),
          high(request.length)};
}

bool reads(const UsbRequest& request) { return (request.type & 0x80) != 0 && request.length > 0; }

}  // namespace

void ControlPipe::request(const UsbRequest& request,
                          std::vector<std::uint8_t> data,
                          std::function<void(const UsbTransfer&)> on_end) {
  transfers_.push_back({.request = request, .data = std::move(data), .on_end = std::move(on_end)});
}

void ControlPipe::clear() {
  address_ = 0;
  max_packet_ = kFirstMaxPacket;
  transfers_.clear();
  received_.clear();
}

bool ControlPipe::is_setting_address() const {
  return !is_idle() && transfers_.front().stage == Stage::kStatus &&
         transfers_.front().request.type == 0 && transfers_.front().request.request == kSetAddress;
}

bool ControlPipe::step(std::int64_t now_ns) {
  Transfer& transfer = transfers_.front();
  if (transfer.until_ns == 0) {
    transfer.until_ns = now_ns + kPatienceNs;
  }
  if (now_ns > transfer.until_ns) {
    end(UsbTransfer::End::kTimeout);
    return false;
  }
  switch (transfer.stage) {
    case Stage::kSetup:
      received_.clear();
      if (cable_.setup(address_, packet_of(transfer.request)) == UsbAnswer::kAck) {
        transfer.stage = transfer.request.length > 0 ? Stage::kData : Stage::kStatus;
      }
      break;
    case Stage::kData:
      step_data();
      break;
    case Stage::kStatus:
      step_status();
      break;
  }
  return true;
}

void ControlPipe::step_data() {
  Transfer& transfer = transfers_.front();
  if (!reads(transfer.request)) {
    const std::size_t length =
        std::min<std::size_t>(transfer.data.size() - transfer.sent, max_packet_);
    const std::span<const std::uint8_t> bytes =
        std::span(transfer.data).subspan(transfer.sent, length);
    const UsbAnswer answer = cable_.out(address_, 0, transfer.data1, bytes);
    if (answer == UsbAnswer::kStall) {
      end(UsbTransfer::End::kStalled);
    } else if (answer == UsbAnswer::kAck) {
      transfer.data1 = !transfer.data1;
      transfer.sent += length;
      transfer.stage = transfer.sent == transfer.data.size() ? Stage::kStatus : Stage::kData;
    }
    return;
  }
  const UsbData data = cable_.in(address_, 0);
  if (data.answer == UsbAnswer::kStall) {
    end(UsbTransfer::End::kStalled);
  } else if (data.answer == UsbAnswer::kAck && data.data1 == transfer.data1) {
    transfer.data1 = !transfer.data1;
    received_.insert(received_.end(), data.bytes.begin(), data.bytes.end());
    if (data.bytes.size() < max_packet_ || received_.size() >= transfer.request.length) {
      transfer.stage = Stage::kStatus;
    }
  }
}

void ControlPipe::step_status() {
  UsbAnswer answer = UsbAnswer::kNone;
  if (reads(transfers_.front().request)) {
    answer = cable_.out(address_, 0, true, {});
  } else {
    const UsbData data = cable_.in(address_, 0);
    answer = data.answer == UsbAnswer::kAck && !data.data1 ? UsbAnswer::kNak : data.answer;
  }
  if (answer == UsbAnswer::kAck) {
    end(UsbTransfer::End::kDone);
  } else if (answer == UsbAnswer::kStall) {
    end(UsbTransfer::End::kStalled);
  }
}

void ControlPipe::end(UsbTransfer::End how) {
  const Transfer transfer = std::move(transfers_.front());
  transfers_.pop_front();
  transfer.on_end({how, std::exchange(received_, {})});
}

}  // namespace echomap::rp2040
