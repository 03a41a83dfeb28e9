// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// A ByteStream over an open descriptor, which it closes. A tty must be raw with VMIN at 1: with
/// VMIN at 0 an empty read looks like the end of the stream. `before_close` is done with the
/// descriptor just before it is closed.
std::unique_ptr<ByteStream> descriptor_stream(int fd,
                                              const std::string& name,
                                              std::function<void(int fd)> before_close = {});

/// The same for a serial device, whose speed can be changed.
std::unique_ptr<ByteStream> serial_stream(int fd,
                                          const std::string& name,
                                          std::function<void(int fd)> before_close = {});

}  // namespace echomap::transport
