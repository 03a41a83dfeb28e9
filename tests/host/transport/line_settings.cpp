// SPDX-License-Identifier: MIT
#include "tests/host/transport/line_settings.hpp"

#include <stdexcept>

#include <asm/termbits.h>
#include <sys/ioctl.h>

namespace echomap::transport {

LineSettings line_settings(int fd) {
  termios2 settings{};
  if (::ioctl(fd, TCGETS2, &settings) != 0) {
    throw std::runtime_error("not a tty");
  }
  const bool edits_or_echoes = (settings.c_lflag & (ICANON | ECHO | ISIG | IEXTEN)) != 0;
  const bool translates =
      (settings.c_iflag & (ICRNL | INLCR | IGNCR | ISTRIP | IXON | IXOFF)) != 0 ||
      (settings.c_oflag & OPOST) != 0;
  return {.baud = settings.c_ospeed,
          .min_bytes_per_read = settings.c_cc[VMIN],
          .is_raw = !edits_or_echoes && !translates,
          .has_8_bits = (settings.c_cflag & (CSIZE | PARENB | CSTOPB)) == CS8,
          .hangs_up_on_close = (settings.c_cflag & HUPCL) != 0};
}

}  // namespace echomap::transport
