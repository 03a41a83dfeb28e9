// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/boot2.hpp"

namespace echomap {
namespace boards {
namespace {

/// The first 256 bytes of the flash: the boot program of the chip copies them to RAM, and runs them
/// if the checksum is right (RP2040 data sheet, 2.8.1).
__attribute__((section(".boot2"), used)) constexpr Boot2 boot2{};

}  // namespace
}  // namespace boards
}  // namespace echomap
