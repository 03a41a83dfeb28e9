// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/usb_host.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace echomap::rp2040 {
namespace {

/// A device that answers every control transfer, or stalls the strings.
class FakeDevice final : public UsbCable {
 public:
  void plug(bool plugged) override { plugged_ = plugged; }
  bool is_attached() const override { return plugged_; }
  bool has_bulk_in() const override { return has_bulk_in_; }
  void reset_bus() override {
    ++resets_;
    address_ = 0;
  }
  void suspend_bus() override { suspended_ = true; }
  void resume_bus(UsbResume) override { suspended_ = false; }
  UsbAnswer setup(std::uint8_t address, std::span<const std::uint8_t> packet) override {
    if (address != address_) {
      return UsbAnswer::kNone;
    }
    request_.assign(packet.begin(), packet.end());
    answer_.clear();
    data1_ = true;
    if (request_[1] == 6 && request_[3] == 1) {
      answer_ = {18, 1, 0, 2, 2, 0, 0, 64, 0x8a, 0x2e, 0x0a, 0, 0, 1, 0, 2, 0, 1};
    } else if (request_[1] == 6 && request_[3] == 2) {
      answer_ = {9, 2, 9, 0, 2, 1, 0, 0x80, 50};
    } else if (request_[1] == 6) {
      answer_ = {4, 3, 'E', 0};
    }
    answer_.resize(std::min<std::size_t>(answer_.size(), request_[6]));
    return UsbAnswer::kAck;
  }
  UsbData in(std::uint8_t address, std::uint8_t endpoint) override {
    if (address != address_ || endpoint != 0) {
      return {UsbAnswer::kNak, false, {}};
    }
    if (stalls_strings_ && request_[1] == 6 && request_[3] == 3) {
      return {UsbAnswer::kStall, false, {}};
    }
    if (request_[1] == 5) {
      address_ = request_[2];
    }
    return {UsbAnswer::kAck, true, answer_};
  }
  UsbAnswer out(std::uint8_t,
                std::uint8_t endpoint,
                bool,
                std::span<const std::uint8_t> bytes) override {
    EXPECT_FALSE(suspended_);
    if (endpoint == 2) {
      received_.insert(received_.end(), bytes.begin(), bytes.end());
    }
    return UsbAnswer::kAck;
  }

  bool plugged_ = false;
  bool suspended_ = false;
  bool has_bulk_in_ = false;
  bool stalls_strings_ = false;
  bool data1_ = false;
  unsigned resets_ = 0;
  std::uint8_t address_ = 0;
  std::vector<std::uint8_t> request_;
  std::vector<std::uint8_t> answer_;
  std::vector<std::uint8_t> received_;
};

void run_until_s(UsbHost& host, std::int64_t& now_ns, double until_s) {
  while (static_cast<double>(now_ns) < until_s * 1e9) {
    now_ns = host.service(now_ns);
  }
}

TEST(UsbHost, OpensThePortOfADeviceThatAnswers) {
  FakeDevice device;
  UsbHost host(device);
  std::int64_t now_ns = 0;
  host.plug(true, 0);
  run_until_s(host, now_ns, 1.0);
  EXPECT_TRUE(host.is_open());
  EXPECT_EQ(host.device_descriptor().size(), 18U);
  host.send(std::vector<std::uint8_t>{1, 2, 3});
  run_until_s(host, now_ns, 1.1);
  EXPECT_EQ(device.received_, (std::vector<std::uint8_t>{1, 2, 3}));
}

TEST(UsbHost, OpensThePortOfADeviceThatStallsItsStrings) {
  FakeDevice device;
  device.stalls_strings_ = true;
  UsbHost host(device);
  std::int64_t now_ns = 0;
  host.plug(true, 0);
  run_until_s(host, now_ns, 1.0);
  EXPECT_TRUE(host.is_open());
}

TEST(UsbHost, EnumeratesAgainAfterReplug) {
  FakeDevice device;
  UsbHost host(device);
  std::int64_t now_ns = 0;
  host.plug(true, 0);
  run_until_s(host, now_ns, 1.0);
  host.plug(false, now_ns);
  run_until_s(host, now_ns, 1.1);
  EXPECT_FALSE(host.is_open());
  host.plug(true, now_ns);
  run_until_s(host, now_ns, 2.0);
  EXPECT_TRUE(host.is_open());
  EXPECT_EQ(host.enumerations(), 2U);
  EXPECT_EQ(device.resets_, 2U);
}

TEST(UsbHost, OnlyPollsWhileNeitherSideHasBytes) {
  FakeDevice device;
  UsbHost host(device);
  std::int64_t now_ns = 0;
  host.plug(true, 0);
  EXPECT_FALSE(host.only_polls()) << "it enumerates";
  run_until_s(host, now_ns, 1.0);
  EXPECT_TRUE(host.only_polls());
  device.has_bulk_in_ = true;
  EXPECT_FALSE(host.only_polls()) << "the device has a packet";
  device.has_bulk_in_ = false;
  host.send(std::vector<std::uint8_t>{1});
  EXPECT_FALSE(host.only_polls()) << "the host has";
  run_until_s(host, now_ns, 1.1);
  EXPECT_TRUE(host.only_polls());
  device.plugged_ = false;
  EXPECT_FALSE(host.only_polls()) << "the device is gone";
}

TEST(UsbHost, SendsNothingWhileItSleepsAndThenTheRestWithoutEnumeratingAgain) {
  FakeDevice device;
  UsbHost host(device);
  std::int64_t now_ns = 0;
  host.plug(true, 0);
  run_until_s(host, now_ns, 1.0);
  host.suspend();
  EXPECT_TRUE(device.suspended_);
  EXPECT_FALSE(host.only_polls());
  host.send(std::vector<std::uint8_t>{1});
  run_until_s(host, now_ns, 1.5);
  EXPECT_TRUE(device.received_.empty());
  host.resume(UsbResume::kNoticed);
  run_until_s(host, now_ns, 1.6);
  EXPECT_EQ(device.received_, std::vector<std::uint8_t>{1});
  EXPECT_EQ(host.enumerations(), 1U);
}

TEST(UsbHost, IsAwakeAfterAReplug) {
  FakeDevice device;
  UsbHost host(device);
  std::int64_t now_ns = 0;
  host.plug(true, 0);
  run_until_s(host, now_ns, 1.0);
  host.suspend();
  host.plug(false, now_ns);
  run_until_s(host, now_ns, 1.1);
  device.suspended_ = false;
  host.plug(true, now_ns);
  run_until_s(host, now_ns, 2.0);
  EXPECT_TRUE(host.is_open());
}

TEST(UsbHost, ForgetsWhatWasNotSentBeforeItsCableWasPulled) {
  FakeDevice device;
  UsbHost host(device);
  std::int64_t now_ns = 0;
  host.plug(true, 0);
  run_until_s(host, now_ns, 1.0);
  host.send(std::vector<std::uint8_t>{1});
  host.plug(false, now_ns);
  host.send(std::vector<std::uint8_t>{2});
  run_until_s(host, now_ns, 1.1);
  host.plug(true, now_ns);
  host.send(std::vector<std::uint8_t>{3});
  run_until_s(host, now_ns, 2.0);
  EXPECT_EQ(device.received_, std::vector<std::uint8_t>{3});
}

}  // namespace
}  // namespace echomap::rp2040
