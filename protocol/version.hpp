// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace protocol {

/// Another major: frames of the two sides cannot be understood. The minor goes up whenever the
/// messages or their values change, so that a mismatch can name the older side.
constexpr uint8_t kProtocolMajor = 1;
constexpr uint8_t kProtocolMinor = 4;

/// Version of the firmware, that of the project, as HelloReply tells it: 123 is 1.2.3. Minor and
/// patch are 0 .. 9.
constexpr uint16_t kFirmwareVersion = 10;

/// Such a version in words: "1.2.3".
class VersionText {
 public:
  constexpr explicit VersionText(uint16_t version) {
    uint8_t length = 0;
    for (uint16_t unit = 10000; unit != 0; unit = static_cast<uint16_t>(unit / 10)) {
      const uint8_t digit = static_cast<uint8_t>(version / unit % 10);
      if (length != 0 || digit != 0 || unit <= 100) {
        text_[length++] = static_cast<char>('0' + digit);
      }
      if (unit == 100 || unit == 10) {
        text_[length++] = '.';
      }
    }
  }
  constexpr const char* text() const { return text_; }

 private:
  char text_[sizeof("655.3.5")] = {};
};

}  // namespace protocol
}  // namespace echomap
