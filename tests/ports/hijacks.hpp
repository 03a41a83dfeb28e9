// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::tests {

/// How many of `tries` to open a port that another process has are refused with that process named,
/// and without a byte, a flush or a changed setting for its robot. The other keeps the port by
/// flock(2) and by TIOCEXCL in turn. As root, whom TIOCEXCL does not stop, it is as true.
int measure_refused_hijacks(int tries);

}  // namespace echomap::tests
