// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/usb_control.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace echomap::boards::usb {
namespace {

using testing::ElementsAre;
using Packet = std::vector<std::uint8_t>;

/// The host's side of endpoint 0, a packet at a time; what is refused is std::nullopt.
class Host {
 public:
  explicit Host(ControlTransfers& device) : device_(device) {}

  Step setup(std::uint8_t type,
             std::uint8_t request,
             std::uint16_t value,
             std::uint16_t index,
             std::uint16_t length) {
    const std::uint8_t packet[8] = {type,
                                    request,
                                    static_cast<std::uint8_t>(value),
                                    static_cast<std::uint8_t>(value >> 8),
                                    static_cast<std::uint8_t>(index),
                                    static_cast<std::uint8_t>(index >> 8),
                                    static_cast<std::uint8_t>(length),
                                    static_cast<std::uint8_t>(length >> 8)};
    return device_.on_setup(packet);
  }

  /// A transfer to the host, up to its status; the packets' sizes are in `sizes`.
  std::optional<Packet> get(std::uint8_t type,
                            std::uint8_t request,
                            std::uint16_t value,
                            std::uint16_t index,
                            std::uint16_t length) {
    Packet all;
    sizes.clear();
    Step step = setup(type, request, value, index, length);
    if (step.next == Next::kStall) {
      return std::nullopt;
    }
    while (step.next == Next::kSend) {
      all.insert(all.end(), step.packet.data, step.packet.data + step.packet.size);
      sizes.push_back(step.packet.size);
      step = device_.on_sent();
    }
    EXPECT_EQ(step.next, Next::kReceive);
    EXPECT_EQ(device_.on_received({nullptr, 0}).next, Next::kWait);
    return all;
  }

  std::optional<Packet> descriptor(std::uint8_t type, std::uint8_t index, std::uint16_t length) {
    return get(0x80, 6, static_cast<std::uint16_t>(type << 8 | index), 0, length);
  }

  /// A transfer without data; false where it is refused. The last effect is in `effect`.
  bool set(std::uint8_t type, std::uint8_t request, std::uint16_t value, std::uint16_t index) {
    const Step step = setup(type, request, value, index, 0);
    effect = step.effect;
    if (step.next == Next::kStall) {
      return false;
    }
    EXPECT_EQ(step.next, Next::kSend);
    EXPECT_EQ(step.packet.size, 0);
    const Step last = device_.on_sent();
    EXPECT_EQ(last.next, Next::kWait);
    if (effect == Effect::kNone) {
      effect = last.effect;
    }
    return true;
  }

  std::vector<std::uint8_t> sizes;
  Effect effect = Effect::kNone;

 private:
  ControlTransfers& device_;
};

class UsbControl : public testing::Test {
 protected:
  void configure() { ASSERT_TRUE(host.set(0x00, 9, 1, 0)); }
  void open() {
    configure();
    ASSERT_TRUE(host.set(0x21, 0x22, 3, 0));
  }

  ControlTransfers device;
  Host host{device};
};

TEST_F(UsbControl, TheDeviceIsAPicosSerialPort) {
  const Packet device_descriptor = host.descriptor(1, 0, 64).value();
  ASSERT_EQ(device_descriptor.size(), 18U);
  EXPECT_EQ(device_descriptor[7], 64) << "bytes of a packet";
  EXPECT_EQ(device_descriptor[8] | device_descriptor[9] << 8, 0x2E8A);
  EXPECT_EQ(device_descriptor[10] | device_descriptor[11] << 8, 0x000A);
}

TEST_F(UsbControl, AnAnswerIsNoLongerThanAskedFor) {
  EXPECT_THAT(host.descriptor(1, 0, 8).value(), ElementsAre(18, 1, 0, 2, 0xEF, 2, 1, 64));
}

TEST_F(UsbControl, TheConfigurationComesInTwoPacketsAndCountsItself) {
  const Packet all = host.descriptor(2, 0, 255).value();
  EXPECT_THAT(host.sizes, ElementsAre(64, 11));
  EXPECT_EQ(all[2] | all[3] << 8, 75);
  std::size_t at = 0;
  int interfaces = 0;
  while (at < all.size()) {
    ASSERT_GT(all[at], 1);
    interfaces += all[at + 1] == kInterface ? 1 : 0;
    at += all[at];
  }
  EXPECT_EQ(at, all.size());
  EXPECT_EQ(interfaces, all[4]);
}

TEST_F(UsbControl, NoInterfaceSpeaksModemCommands) {
  const Packet all = host.descriptor(2, 0, 255).value();
  for (std::size_t at = 0; at < all.size(); at += all[at]) {
    if (all[at + 1] == kInterface) {
      EXPECT_EQ(all[at + 7], 0) << "bInterfaceProtocol";
    }
  }
}

TEST_F(UsbControl, AFullLastPacketIsFollowedByAnEmptyOneOnlyWhereMoreWasAskedFor) {
  EXPECT_TRUE(host.descriptor(2, 0, 64).has_value());
  EXPECT_THAT(host.sizes, ElementsAre(64));
}

TEST_F(UsbControl, StringsAreTextOf16BitsACharacter) {
  EXPECT_THAT(host.descriptor(3, 0, 255).value(), ElementsAre(4, 3, 9, 4));
  const Packet maker = host.descriptor(3, 1, 255).value();
  std::string text;
  for (std::size_t at = 2; at < maker.size(); at += 2) {
    text.push_back(static_cast<char>(maker[at]));
    EXPECT_EQ(maker[at + 1], 0);
  }
  EXPECT_EQ(text, "echomap");
  EXPECT_TRUE(host.descriptor(3, 3, 255).has_value()) << "serial number";
}

TEST_F(UsbControl, WhatItDoesNotHaveIsRefused) {
  EXPECT_FALSE(host.descriptor(6, 0, 10).has_value()) << "of high speed";
  EXPECT_FALSE(host.descriptor(3, 4, 255).has_value());
  EXPECT_FALSE(host.descriptor(2, 1, 255).has_value());
  EXPECT_FALSE(host.get(0x80, 12, 0, 0, 2).has_value()) << "frame number";
  EXPECT_FALSE(host.set(0x00, 3, 1, 0)) << "remote wake-up";
  EXPECT_FALSE(host.set(0x00, 5, 128, 0)) << "address";
  EXPECT_FALSE(host.set(0x00, 9, 2, 0)) << "configuration";
  EXPECT_FALSE(host.set(0x40, 1, 0, 0)) << "of a vendor";
  EXPECT_FALSE(host.set(0x21, 0x23, 0, 0)) << "break";
  EXPECT_FALSE(host.set(0x21, 0x22, 3, 1)) << "line state of the data interface";
}

TEST_F(UsbControl, AnAddressHoldsFromTheEndOfItsTransferOn) {
  const Step step = host.setup(0x00, 5, 42, 0, 0);
  EXPECT_EQ(step.effect, Effect::kNone);
  EXPECT_EQ(device.address(), 0);
  EXPECT_EQ(device.on_sent().effect, Effect::kAddress);
  EXPECT_EQ(device.address(), 42);
}

TEST_F(UsbControl, TheConfigurationCanBeReadBackAndTakenAway) {
  EXPECT_THAT(host.get(0x80, 8, 0, 0, 1).value(), ElementsAre(0));
  configure();
  EXPECT_EQ(host.effect, Effect::kConfigure);
  EXPECT_THAT(host.get(0x80, 8, 0, 0, 1).value(), ElementsAre(1));
  EXPECT_TRUE(host.set(0x00, 9, 0, 0));
  EXPECT_EQ(host.effect, Effect::kConfigure);
  EXPECT_FALSE(device.is_configured());
}

TEST_F(UsbControl, ThePortIsOpenWhileConfiguredWithTerminalReady) {
  EXPECT_TRUE(host.set(0x21, 0x22, 1, 0));
  EXPECT_FALSE(device.is_open()) << "not configured";
  open();
  EXPECT_TRUE(device.is_open());
  EXPECT_TRUE(host.set(0x21, 0x22, 2, 0));
  EXPECT_FALSE(device.is_open()) << "RTS alone";
}

TEST_F(UsbControl, ABusResetTakesAddressConfigurationAndPort) {
  EXPECT_TRUE(host.set(0x00, 5, 9, 0));
  open();
  device.on_bus_reset();
  EXPECT_EQ(device.address(), 0);
  EXPECT_FALSE(device.is_configured());
  EXPECT_FALSE(device.is_open());
  open();
  EXPECT_TRUE(device.is_open());
}

TEST_F(UsbControl, ALineCodingIsReadBackAsItWasSet) {
  EXPECT_THAT(host.get(0xA1, 0x21, 0, 0, 7).value(), ElementsAre(0x90, 0xD0, 0x03, 0, 0, 0, 8));
  EXPECT_EQ(host.setup(0x21, 0x20, 0, 0, 7).next, Next::kReceive);
  const std::uint8_t coding[] = {0x00, 0xC2, 0x01, 0x00, 0, 0, 8};
  const Step status = device.on_received({coding, 7});
  EXPECT_EQ(status.next, Next::kSend);
  EXPECT_EQ(status.packet.size, 0);
  EXPECT_EQ(device.on_sent().next, Next::kWait);
  EXPECT_THAT(host.get(0xA1, 0x21, 0, 0, 7).value(), testing::ElementsAreArray(coding));
}

TEST_F(UsbControl, ALineCodingOfAnotherLengthIsRefused) {
  EXPECT_EQ(host.setup(0x21, 0x20, 0, 0, 8).next, Next::kStall);
  EXPECT_EQ(host.setup(0x21, 0x20, 0, 0, 7).next, Next::kReceive);
  const std::uint8_t coding[] = {1, 2, 3};
  EXPECT_EQ(device.on_received({coding, 3}).next, Next::kStall);
  EXPECT_THAT(host.get(0xA1, 0x21, 0, 0, 7).value(), ElementsAre(0x90, 0xD0, 0x03, 0, 0, 0, 8));
}

TEST_F(UsbControl, AnEndpointIsHaltedAndSetGoing) {
  EXPECT_FALSE(host.set(0x02, 3, 0, 0x82)) << "not configured";
  configure();
  EXPECT_TRUE(host.set(0x02, 3, 0, 0x82));
  EXPECT_EQ(host.effect, Effect::kHalt);
  EXPECT_TRUE(device.halted(0x82));
  EXPECT_FALSE(device.halted(0x02));
  EXPECT_THAT(host.get(0x82, 0, 0, 0x82, 2).value(), ElementsAre(1, 0));
  EXPECT_THAT(host.get(0x82, 0, 0, 0x02, 2).value(), ElementsAre(0, 0));
  EXPECT_TRUE(host.set(0x02, 1, 0, 0x82));
  EXPECT_FALSE(device.halted(0x82));
  EXPECT_FALSE(host.set(0x02, 3, 0, 0x83)) << "no such endpoint";
}

TEST_F(UsbControl, ASetupEndsTheTransferBeforeIt) {
  EXPECT_EQ(host.setup(0x80, 6, 0x0200, 0, 255).next, Next::kSend);
  EXPECT_THAT(host.descriptor(3, 0, 255).value(), ElementsAre(4, 3, 9, 4));
  EXPECT_EQ(host.setup(0x00, 5, 42, 0, 0).next, Next::kSend);
  EXPECT_TRUE(host.descriptor(1, 0, 64).has_value());
  configure();
  EXPECT_EQ(device.address(), 0) << "a host that gave up has given no address";
}

TEST_F(UsbControl, InterfacesHaveOneSettingEach) {
  EXPECT_FALSE(host.get(0x81, 10, 0, 0, 1).has_value()) << "not configured";
  configure();
  EXPECT_THAT(host.get(0x81, 10, 0, 1, 1).value(), ElementsAre(0));
  EXPECT_TRUE(host.set(0x01, 11, 0, 1));
  EXPECT_FALSE(host.set(0x01, 11, 1, 1));
  EXPECT_FALSE(host.get(0x81, 10, 0, 2, 1).has_value());
}

}  // namespace
}  // namespace echomap::boards::usb
