// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/usb_host.hpp"

#include <algorithm>
#include <utility>

namespace echomap::rp2040 {
namespace {

/// From the plug to the reset: USB 2.0, 7.1.7.3, debounce.
constexpr std::int64_t kDebounceNs = 100'000'000;
constexpr std::int64_t kResetNs = 50'000'000;
constexpr std::int64_t kSetAddressNs = 10'000'000;
constexpr std::int64_t kTransactionNs = 50'000;
constexpr std::int64_t kFrameNs = 1'000'000;
constexpr std::int64_t kRetryNs = 200'000'000;
constexpr unsigned kAttempts = 4;
constexpr std::size_t kMaxBulk = 64;
constexpr std::uint8_t kBulkEndpoint = 2;
constexpr std::uint16_t kEnglish = 0x0409;
constexpr std::uint32_t kBaud = 250'000;

constexpr UsbRequest descriptor(std::uint8_t kind,
                                std::uint8_t index,
                                std::uint16_t language,
                                std::uint16_t length) {
  return {0x80, 6, static_cast<std::uint16_t>(kind << 8 | index), language, length};
}

/// The letters of a string descriptor that fit into one byte.
std::string text_of(const std::vector<std::uint8_t>& string) {
  std::string text;
  for (std::size_t at = 2; at + 1 < string.size(); at += 2) {
    text += static_cast<char>(string[at]);
  }
  return text;
}

}  // namespace

std::int64_t UsbHost::service(std::int64_t now_ns) {
  if (!plugged_ || suspended_) {
    return now_ns + kFrameNs;
  }
  if (!cable_.is_attached()) {
    seen_ = false;
    give_up();
    return now_ns + kFrameNs;
  }
  if (!seen_) {
    seen_ = true;
    attempts_ = 0;
    wait_until_ns_ = now_ns + kDebounceNs;
    begin_enumeration(now_ns);
  }
  if (now_ns < wait_until_ns_) {
    return wait_until_ns_;
  }
  if (!control_.is_idle()) {
    step_control(now_ns);
    return std::max(now_ns + kTransactionNs, wait_until_ns_);
  }
  return now_ns + (step_bulk() ? kTransactionNs : kFrameNs);
}

void UsbHost::plug(bool plugged, std::int64_t now_ns) {
  plugged_ = plugged;
  if (!plugged) {
    outgoing_.clear();
  }
  seen_ = false;
  give_up();
  wait_until_ns_ = now_ns;
  cable_.plug(plugged);
}

void UsbHost::reset(std::int64_t now_ns) {
  attempts_ = 0;
  begin_enumeration(now_ns);
}

void UsbHost::suspend() {
  suspended_ = true;
  cable_.suspend_bus();
}

void UsbHost::resume(UsbResume resume) {
  suspended_ = false;
  cable_.resume_bus(resume);
}

void UsbHost::send(std::span<const std::uint8_t> bytes) {
  if (plugged_) {
    outgoing_.insert(outgoing_.end(), bytes.begin(), bytes.end());
  }
}

void UsbHost::request(const UsbRequest& request,
                      std::vector<std::uint8_t> data,
                      std::function<void(const UsbTransfer&)> on_end) {
  control_.request(request, std::move(data), std::move(on_end));
}

void UsbHost::give_up() {
  open_ = false;
  suspended_ = false;
  configured_ = false;
  control_.clear();
}

void UsbHost::begin_enumeration(std::int64_t now_ns) {
  give_up();
  ++enumerations_;
  ++attempts_;
  cable_.reset_bus();
  wait_until_ns_ = std::max(wait_until_ns_, now_ns) + kResetNs;
  ask(descriptor(1, 0, 0, 8), [this](const UsbTransfer& first) {
    if (first.bytes.size() < 8) {
      return;
    }
    control_.set_max_packet(first.bytes[7]);
    const std::uint8_t address = next_address_;
    next_address_ = static_cast<std::uint8_t>(next_address_ % 127 + 1);
    ask({0x00, 5, address, 0, 0}, [this, address](const UsbTransfer&) {
      control_.set_address(address);
      ask(descriptor(1, 0, 0, 18), [this](const UsbTransfer& whole) {
        device_ = whole.bytes;
        read_configuration();
      });
    });
  });
}

void UsbHost::ask(const UsbRequest& what, std::function<void(const UsbTransfer&)> on_end) {
  request(what, {}, std::move(on_end));
}

void UsbHost::read_configuration() {
  ask(descriptor(2, 0, 0, 9), [this](const UsbTransfer& head) {
    if (head.bytes.size() < 4) {
      return;
    }
    const auto length = static_cast<std::uint16_t>(head.bytes[2] | head.bytes[3] << 8);
    ask(descriptor(2, 0, 0, length), [this](const UsbTransfer& whole) {
      configuration_ = whole.bytes;
      read_strings();
    });
  });
}

void UsbHost::read_strings() {
  strings_.clear();
  ask(descriptor(3, 0, 0, 255), [](const UsbTransfer&) {});
  for (const std::size_t at : {std::size_t{14}, std::size_t{15}, std::size_t{16}}) {
    if (at < device_.size() && device_[at] != 0) {
      ask(descriptor(3, device_[at], kEnglish, 255),
          [this](const UsbTransfer& text) { strings_.push_back(text_of(text.bytes)); });
    }
  }
  set_up_line();
}

void UsbHost::set_up_line() {
  ask({0x00, 9, 1, 0, 0}, [this](const UsbTransfer& end) {
    configured_ = end.end == UsbTransfer::End::kDone;
    in_data1_ = false;
    out_data1_ = false;
  });
  const std::vector<std::uint8_t> coding{static_cast<std::uint8_t>(kBaud & 0xFF),
                                         static_cast<std::uint8_t>(kBaud >> 8 & 0xFF),
                                         static_cast<std::uint8_t>(kBaud >> 16 & 0xFF),
                                         0,
                                         0,
                                         0,
                                         8};
  request({0x21, 0x20, 0, 0, 7}, coding, [](const UsbTransfer&) {});
  ask({0x21, 0x22, 3, 0, 0}, [this](const UsbTransfer& end) {
    open_ = configured_ && end.end == UsbTransfer::End::kDone;
  });
}

void UsbHost::step_control(std::int64_t now_ns) {
  if (control_.is_setting_address()) {
    wait_until_ns_ = now_ns + kSetAddressNs;
  }
  const bool given_up = !control_.step(now_ns);
  if (given_up && !configured_ && attempts_ < kAttempts) {
    wait_until_ns_ = now_ns + kRetryNs;
    begin_enumeration(now_ns);
  }
}

/// Whether bytes have gone over the cable.
bool UsbHost::step_bulk() {
  if (!open_) {
    return false;
  }
  const bool reads = reads_bulk();
  return writes_bulk() || reads;
}

bool UsbHost::reads_bulk() {
  if (!cable_.has_bulk_in()) {
    return false;
  }
  const UsbData data = cable_.in(control_.address(), kBulkEndpoint);
  if (data.answer != UsbAnswer::kAck || data.data1 != in_data1_) {
    return false;
  }
  in_data1_ = !in_data1_;
  for (const std::uint8_t byte : data.bytes) {
    if (on_byte) {
      on_byte(byte);
    }
  }
  return true;
}

bool UsbHost::writes_bulk() {
  const std::size_t length = std::min(outgoing_.size(), kMaxBulk);
  if (length == 0) {
    return false;
  }
  const std::vector<std::uint8_t> bytes(outgoing_.begin(),
                                        outgoing_.begin() + static_cast<std::ptrdiff_t>(length));
  if (cable_.out(control_.address(), kBulkEndpoint, out_data1_, bytes) != UsbAnswer::kAck) {
    return false;
  }
  out_data1_ = !out_data1_;
  outgoing_.erase(outgoing_.begin(), outgoing_.begin() + static_cast<std::ptrdiff_t>(length));
  return true;
}

}  // namespace echomap::rp2040
