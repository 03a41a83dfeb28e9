// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "host/flashing/uf2.hpp"

namespace echomap::flashing {

/// Of the flash on a Raspberry Pi Pico.
constexpr std::size_t kPicoFlashBytes = std::size_t{2} * 1024 * 1024;

/// The checksum that the RP2040's ROM wants of the first 252 bytes: CRC32 of polynomial 04C11DB7,
/// not reflected, from ffffffff on, without a final inversion (RP2040 datasheet, boot sequence).
std::uint32_t boot_checksum(std::span<const std::uint8_t> bytes);

/// What is wrong with an image for a Pico; empty where nothing is. The chip starts nothing but an
/// image whose boot stage has the right checksum, and that one jumps to the vectors behind it.
std::string fault_of_rp2040_image(std::span<const std::uint8_t> image);

/// The image in a file of bare bytes (.bin) or a UF2 file. Throws CommandError 1 with what is wrong
/// with it and the next step.
Bytes read_rp2040_image(const std::filesystem::path& file);

}  // namespace echomap::flashing
