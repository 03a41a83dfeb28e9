// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::transport {

/// The modem lines that pty_as_serial_port.cpp makes up for all ptys.
struct ModemLines {
  int up = 0;  ///< TIOCM_DTR, TIOCM_RTS, ...
  int falls_of_dtr = 0;
  int driver_flags = -1;  ///< ASYNC_.., those of TIOCGSERIAL; negative: the driver has none.
  int requests_until_failure = -1;  ///< Then every request fails; negative: none does.
};

ModemLines& modem_lines();

}  // namespace echomap::transport
