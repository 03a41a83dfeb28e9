// SPDX-License-Identifier: MIT
#include "tests/hil/measure/image_size.hpp"

#include <fcntl.h>
#include <gelf.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unistd.h>

namespace echomap::tests {
namespace {

/// Of an AVR: neither flash nor RAM.
constexpr std::string_view kEeprom = ".eeprom";

void add(const GElf_Shdr& section, ImageSize& size) {
  if ((section.sh_flags & SHF_ALLOC) == 0) {
    return;
  }
  if ((section.sh_flags & SHF_WRITE) != 0) {
    size.ram_bytes += section.sh_size;
  }
  if (section.sh_type != SHT_NOBITS) {
    size.flash_bytes += section.sh_size;
  }
}

}  // namespace

ImageSize size_of_image(const std::filesystem::path& elf_path) {
  elf_version(EV_CURRENT);
  const int file = ::open(elf_path.c_str(), O_RDONLY | O_CLOEXEC);
  Elf* const elf = elf_begin(file, ELF_C_READ, nullptr);
  if (elf == nullptr) {
    throw std::runtime_error(elf_path.string() + ": " + elf_errmsg(-1));
  }
  std::size_t names = 0;
  elf_getshdrstrndx(elf, &names);
  ImageSize size;
  for (Elf_Scn* at = nullptr; (at = elf_nextscn(elf, at)) != nullptr;) {
    GElf_Shdr section{};
    gelf_getshdr(at, &section);
    if (std::string_view(elf_strptr(elf, names, section.sh_name)) != kEeprom) {
      add(section, size);
    }
  }
  elf_end(elf);
  ::close(file);
  return size;
}

}  // namespace echomap::tests
