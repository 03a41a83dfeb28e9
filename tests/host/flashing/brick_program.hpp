// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace echomap::flashing {

/// Where brick_program() has the kind of its first segment, and the note that it is for Linux.
constexpr std::size_t kFirstSegment = 52;
constexpr std::size_t kLinuxNote = 132;

/// The headers of a static ELF for Linux on a 32-bit ARM: a segment to load and one of two notes.
inline std::string brick_program() {
  std::string elf(164, '\0');
  elf.replace(0,
              7,
              std::string("\x7f"
                          "ELF\x01\x01\x01",
                          7));
  elf[16] = 2;                  // A program,
  elf[18] = 40;                 // of an ARM.
  elf[28] = 52;                 // Its program headers follow,
  elf[37] = 2;                  // (calls as without a floating-point unit)
  elf[42] = 32;                 // each of 32 bytes,
  elf[44] = 2;                  // two of them:
  elf[kFirstSegment] = 1;       // a segment to load,
  elf[kFirstSegment + 32] = 4;  // and one of notes,
  elf[kFirstSegment + 36] = 116;
  elf[kFirstSegment + 48] = 48;
  elf[116] = 4;  // the first of which has a name of 4 bytes, tells nothing,
  elf[124] = 3;  // and is the number of the build,
  elf.replace(128, 4, std::string("GNU\0", 4));
  elf[kLinuxNote] = 4;       // and the second has such a name, too,
  elf[kLinuxNote + 4] = 16;  // tells four numbers, the first of them 0: Linux,
  elf[kLinuxNote + 8] = 1;   // and is the tag of the system.
  elf.replace(kLinuxNote + 12, 4, std::string("GNU\0", 4));
  return elf;
}

}  // namespace echomap::flashing
