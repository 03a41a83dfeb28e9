// SPDX-License-Identifier: MIT
#include "host/transport/usb_table.hpp"

#include <algorithm>
#include <array>

namespace echomap::transport {
namespace {

/// Arduino and its sister firm arduino.org: boards.txt of ArduinoCore-avr 1.8.7. Serial chips: the
/// drivers ch341, ftdi_sio and cp210x of Linux. ST-Links that stand alone: the udev rules of
/// stlink-tools; those soldered to a Nucleo or Discovery board are left out, for that is another
/// board. STM32 and RP2040: what ST's USB library and the pico-sdk give to any program, and the
/// RP2040's boot loader in its ROM. EV3: what Linux's g_serial gives to any machine whose USB
/// serial gadget it is (drivers/usb/gadget/legacy/serial.c), and LEGO's id of the brick.
constexpr std::array kKnownUsbIds{
    KnownUsbId{{0x2341, 0x0043}, UsbRole::kBoard, "Arduino Uno R3", "uno"},
    KnownUsbId{{0x2341, 0x0001}, UsbRole::kBoard, "Arduino Uno", "uno"},
    KnownUsbId{{0x2341, 0x0243}, UsbRole::kBoard, "Arduino Uno R3", "uno"},
    KnownUsbId{{0x2341, 0x006a}, UsbRole::kBoard, "Arduino Uno", "uno"},
    KnownUsbId{{0x2a03, 0x0043}, UsbRole::kBoard, "Arduino Uno R3", "uno"},
    KnownUsbId{{0x2341, 0x0010}, UsbRole::kBoard, "Arduino Mega 2560", "mega"},
    KnownUsbId{{0x2341, 0x0042}, UsbRole::kBoard, "Arduino Mega 2560 R3", "mega"},
    KnownUsbId{{0x2341, 0x0210}, UsbRole::kBoard, "Arduino Mega 2560", "mega"},
    KnownUsbId{{0x2341, 0x0242}, UsbRole::kBoard, "Arduino Mega 2560 R3", "mega"},
    KnownUsbId{{0x2a03, 0x0010}, UsbRole::kBoard, "Arduino Mega 2560", "mega"},
    KnownUsbId{{0x2a03, 0x0042}, UsbRole::kBoard, "Arduino Mega 2560 R3", "mega"},
    KnownUsbId{{0x1a86, 0x7523}, UsbRole::kSerialChip, "CH340", ""},
    KnownUsbId{{0x1a86, 0x5523}, UsbRole::kSerialChip, "CH341", ""},
    KnownUsbId{{0x1a86, 0x55d4}, UsbRole::kSerialChip, "CH9102", ""},
    KnownUsbId{{0x0403, 0x6001}, UsbRole::kSerialChip, "FTDI FT232R", ""},
    KnownUsbId{{0x0403, 0x6015}, UsbRole::kSerialChip, "FTDI FT231X", ""},
    KnownUsbId{{0x10c4, 0xea60}, UsbRole::kSerialChip, "CP2102", ""},
    KnownUsbId{{0x0483, 0x3748}, UsbRole::kProgrammer, "ST-Link V2", ""},
    KnownUsbId{{0x0483, 0x374d}, UsbRole::kProgrammer, "ST-Link V3", ""},
    KnownUsbId{{0x0483, 0x374e}, UsbRole::kProgrammer, "ST-Link V3", ""},
    KnownUsbId{{0x0483, 0x374f}, UsbRole::kProgrammer, "ST-Link V3", ""},
    KnownUsbId{{0x0483, 0x3753}, UsbRole::kProgrammer, "ST-Link V3", ""},
    KnownUsbId{{0x0483, 0x5740}, UsbRole::kOwnUsb, "STM32", ""},
    KnownUsbId{{0x2e8a, 0x000a}, UsbRole::kOwnUsb, "RP2040", ""},
    KnownUsbId{{0x0525, 0xa4a7}, UsbRole::kOwnUsb, "Linux serial gadget, as of an EV3", ""},
    KnownUsbId{{0x0694, 0x0005}, UsbRole::kOwnUsb, "LEGO EV3", ""},
    KnownUsbId{{0x2e8a, 0x0003}, UsbRole::kBootDrive, "RP2040 in its boot loader", ""},
};

}  // namespace

std::span<const KnownUsbId> known_usb_ids() { return kKnownUsbIds; }

const KnownUsbId* known_usb_id(UsbId id) {
  const auto found = std::find_if(kKnownUsbIds.begin(),
                                  kKnownUsbIds.end(),
                                  [&](const KnownUsbId& known) { return known.id == id; });
  return found == kKnownUsbIds.end() ? nullptr : &*found;
}

bool may_be_robot(UsbId id) {
  const KnownUsbId* known = known_usb_id(id);
  return known != nullptr && known->role != UsbRole::kProgrammer &&
         known->role != UsbRole::kBootDrive;
}

}  // namespace echomap::transport
