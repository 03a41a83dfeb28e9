// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::tests {

/// How many of `replugs` a stream survives: a CH340 without a serial number is unplugged and comes
/// back in its socket under another name, half of the times while its twin has taken the old one.
/// A replug counts when bytes go both ways again, and the twin got none.
int measure_survived_replugs(int replugs);

}  // namespace echomap::tests
