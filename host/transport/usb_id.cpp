// SPDX-License-Identifier: MIT
#include "host/transport/usb_id.hpp"

#include <array>
#include <cstdio>

namespace echomap::transport {

std::string to_string(UsbId id) {
  std::array<char, 10> text{};
  std::snprintf(text.data(), text.size(), "%04x:%04x", unsigned{id.vendor}, unsigned{id.product});
  return text.data();
}

}  // namespace echomap::transport
