// SPDX-License-Identifier: MIT
#include "host/flashing/rp2040_image.hpp"

#include <string_view>

#include <fmt/format.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::flashing {
namespace {

constexpr std::size_t kBootStageBytes = 252;
constexpr std::size_t kVectors = 256;

constexpr std::uint32_t kRamBegin = 0x20000000;
constexpr std::uint32_t kRamBytes = 264 * 1024;

std::uint32_t little_endian(std::span<const std::uint8_t> image, std::size_t at) {
  return std::uint32_t{image[at]} | std::uint32_t{image[at + 1]} << 8 |
         std::uint32_t{image[at + 2]} << 16 | std::uint32_t{image[at + 3]} << 24;
}

bool begins_with(std::span<const std::uint8_t> image, std::string_view text) {
  return image.size() >= text.size() &&
         std::string_view(reinterpret_cast<const char*>(image.data()), text.size()) == text;
}

/// Whether the program behind the boot stage has a stack in RAM and begins in its own image.
bool has_vectors(std::span<const std::uint8_t> image) {
  const std::uint32_t stack = little_endian(image, kVectors);
  const std::uint32_t start = little_endian(image, kVectors + 4);
  const bool is_in_ram = stack > kRamBegin && stack <= kRamBegin + kRamBytes && stack % 4 == 0;
  const bool is_thumb = start % 2 == 1;
  return is_in_ram && is_thumb && start > kFlashBegin + kVectors &&
         start < kFlashBegin + image.size();
}

}  // namespace

std::uint32_t boot_checksum(std::span<const std::uint8_t> bytes) {
  std::uint32_t checksum = 0xffffffff;
  for (const std::uint8_t byte : bytes) {
    checksum ^= std::uint32_t{byte} << 24;
    for (int bit = 0; bit < 8; ++bit) {
      checksum = (checksum << 1) ^ ((checksum & 0x80000000) != 0 ? 0x04c11db7 : 0);
    }
  }
  return checksum;
}

std::string fault_of_rp2040_image(std::span<const std::uint8_t> image) {
  if (begins_with(image,
                  "\x7f"
                  "ELF")) {
    return "it is an ELF file; take the .bin or .uf2 beside it";
  }
  if (image.size() < kVectors + 8) {
    return fmt::format("it has {} bytes, too few for a boot stage and a program", image.size());
  }
  if (image.size() > kPicoFlashBytes) {
    return fmt::format(
        "it has {} bytes, more than the {} of a Pico's flash", image.size(), kPicoFlashBytes);
  }
  const std::uint32_t computed = boot_checksum(image.first(kBootStageBytes));
  const std::uint32_t stored = little_endian(image, kBootStageBytes);
  if (computed != stored) {
    return fmt::format(
        "it is not for an RP2040: its boot stage has the checksum {:08x}, and {:08x} is right",
        stored,
        computed);
  }
  if (!has_vectors(image)) {
    return "it is not for an RP2040: no program is behind its boot stage";
  }
  return "";
}

Bytes read_rp2040_image(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& fault) {
    return console::CommandError(
        console::ExitCode::kRuntimeError,
        fmt::format("will not flash {}: {}\n  next: ./run build firmware_pico, and flash without "
                    "--image, or name another file",
                    file.string(),
                    fault));
  };
  const std::string text = files::read_text_file(file);
  Bytes bytes(text.begin(), text.end());
  if (begins_as_uf2(bytes)) {
    try {
      bytes = image_in_uf2(bytes);
    } catch (const Uf2Error& error) {
      throw refuse(error.what());
    }
  }
  if (const std::string fault = fault_of_rp2040_image(bytes); !fault.empty()) {
    throw refuse(fault);
  }
  return bytes;
}

}  // namespace echomap::flashing
