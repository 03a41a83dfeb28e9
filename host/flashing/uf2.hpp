// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

namespace echomap::flashing {

/// Bytes of an image or a file.
using Bytes = std::vector<std::uint8_t>;

/// A file is no UF2 file for an RP2040; what() says what is wrong with it.
class Uf2Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where the RP2040's flash is in its memory.
constexpr std::uint32_t kFlashBegin = 0x10000000;

/// The UF2 file of an image for the beginning of an RP2040's flash: blocks of 512 bytes with 256
/// bytes each, as the boot loader in its ROM takes them (github.com/microsoft/uf2). The image is
/// filled with 0xff to whole sectors of 4 kB, the unit in which the flash is erased, so that no
/// page of an older program stays in the last one.
Bytes uf2_of(std::span<const std::uint8_t> image);

/// Whether a file begins as UF2 files do.
bool begins_as_uf2(std::span<const std::uint8_t> file);

/// The image in a UF2 file. Throws Uf2Error where a block is broken, of another family of chips or
/// does not follow the one before from the beginning of the flash on.
Bytes image_in_uf2(std::span<const std::uint8_t> file);

}  // namespace echomap::flashing
