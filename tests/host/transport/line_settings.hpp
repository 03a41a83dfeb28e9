// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::transport {

/// What a tty is set to, as the kernel tells it (termios2, so any baud rate).
struct LineSettings {
  unsigned baud = 0;
  unsigned min_bytes_per_read = 0;  ///< VMIN.
  bool is_raw = false;              ///< No echo, no line editing, no translation of bytes.
  bool has_8_bits = false;          ///< 8 data bits, no parity, one stop bit.
  bool hangs_up_on_close = false;   ///< HUPCL: drops DTR.
};

/// Settings of the tty behind `fd`; either end of a pty will do.
LineSettings line_settings(int fd);

}  // namespace echomap::transport
