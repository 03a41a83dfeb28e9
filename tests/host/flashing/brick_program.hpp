// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::flashing {

/// The headers of a static ELF of a 32-bit ARM, with one segment to load.
inline std::string brick_program() {
  std::string elf(84, '\0');
  elf.replace(0,
              7,
              std::string("\x7f"
                          "ELF\x01\x01\x01",
                          7));
  elf[16] = 2;   // A program,
  elf[18] = 40;  // of an ARM.
  elf[28] = 52;  // Its program headers follow,
  elf[42] = 32;  // each of 32 bytes,
  elf[44] = 1;   // one of them:
  elf[52] = 1;   // a segment to load.
  return elf;
}

}  // namespace echomap::flashing
