// SPDX-License-Identifier: MIT
#include "host/transport/line_speed.hpp"

#include <asm/termbits.h>  // Of termios2; it cannot be included with <termios.h>.
#include <sys/ioctl.h>

namespace echomap::transport {

bool set_line_speed(int fd, int baud) {
  termios2 settings{};
  if (baud <= 0 || ::ioctl(fd, TCGETS2, &settings) != 0) {
    return false;
  }
  constexpr tcflag_t kInputShift = IBSHIFT;
  settings.c_cflag &= ~(tcflag_t{CBAUD} | (tcflag_t{CBAUD} << kInputShift));
  settings.c_cflag |= tcflag_t{BOTHER} | (tcflag_t{BOTHER} << kInputShift);
  settings.c_ispeed = settings.c_ospeed = static_cast<speed_t>(baud);
  return ::ioctl(fd, TCSETS2, &settings) == 0;
}

}  // namespace echomap::transport
