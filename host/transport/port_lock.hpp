// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/transport/transport_error.hpp"

namespace echomap::transport {

/// Another program has the port.
class PortHeldError : public TransportError {
 public:
  using TransportError::TransportError;
};

/// Throws PortHeldError where another program has a live /var/lock/LCK..NAME of `path`, or has it
/// open. Opens nothing.
void refuse_if_held(const std::string& path);

/// Opens the serial device or pty `path` for this process alone, and changes nothing of it: no
/// byte, no setting, no modem line but DTR, which the kernel raises at the first opening. Returns a
/// descriptor that the caller closes; -1 with errno where open(2) fails. Throws PortHeldError, with
/// the process and its command where they are readable, where another program
/// - has a serial device by a LCK file or open at all (`refuse_if_held`),
/// - has a pty by TIOCEXCL: that it is open alone says nothing, for an emulator may hold its own,
/// - has it by flock(2), which root cannot pass either.
///
/// While the descriptor is open, flock(2) keeps the port from whoever asks. The caller adds
/// `exclude_others` when it needs no other descriptor any more.
int open_port_alone(const std::string& path);

/// Sets TIOCEXCL on a serial device: open(2) fails for all but root, also in programs that ask for
/// no lock. Not for a pty, which keeps TIOCEXCL when its owner is killed: nobody could reach the
/// simulated robot at its other end again.
void exclude_others(int fd);

/// Takes `exclude_others` back.
void admit_others(int fd);

}  // namespace echomap::transport
