// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/elf_program.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <gelf.h>
#include <sim_elf.h>
#include <span>
#include <stdexcept>
#include <string_view>
#include <unistd.h>

namespace echomap::emulator {
namespace {

[[noreturn]] void fail(const std::filesystem::path& elf, const std::string& what) {
  throw std::runtime_error(elf.string() + ": " + what);
}

/// An ELF file that is open for reading.
class ElfFile {
 public:
  explicit ElfFile(const std::filesystem::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) {
      fail(path, std::strerror(errno));
    }
    elf_version(EV_CURRENT);
    elf_ = elf_begin(descriptor_, ELF_C_READ, nullptr);
  }
  ~ElfFile() {
    elf_end(elf_);
    ::close(descriptor_);
  }
  ElfFile(const ElfFile&) = delete;
  ElfFile& operator=(const ElfFile&) = delete;

  bool is_avr() const {
    GElf_Ehdr header{};
    return gelf_getehdr(elf_, &header) != nullptr && header.e_machine == EM_AVR;
  }

  /// The bytes of a section; empty where there is none. They live as long as the file is open.
  std::string_view section(std::string_view name) const {
    std::size_t names = 0;
    elf_getshdrstrndx(elf_, &names);
    for (Elf_Scn* at = nullptr; (at = elf_nextscn(elf_, at)) != nullptr;) {
      GElf_Shdr header{};
      gelf_getshdr(at, &header);
      const char* const its_name = elf_strptr(elf_, names, header.sh_name);
      const Elf_Data* const data = elf_rawdata(at, nullptr);
      const bool has_bytes = data != nullptr && data->d_buf != nullptr;
      if (its_name != nullptr && its_name == name && has_bytes) {
        return {static_cast<const char*>(data->d_buf), data->d_size};
      }
    }
    return {};
  }

 private:
  int descriptor_;
  Elf* elf_ = nullptr;
};

/// Device name in .note.gnu.avr.deviceinfo: the note's header and owner (16 bytes), six words of
/// memory sizes, a table of two words, then the name between zeros. Source: GNU binutils,
/// od-elf32_avr.c.
std::string device_name(std::string_view note) {
  constexpr std::size_t kNameAt = 16 + 6 * 4 + 2 * 4 + 1;
  if (note.size() <= kNameAt) {
    return "";
  }
  const std::string_view name = note.substr(kNameAt);
  return std::string(name.substr(0, name.find('\0')));
}

void free_firmware(elf_firmware_t& firmware) {
  for (avr_symbol_t* symbol : std::span(firmware.symbol, firmware.symbolcount)) {
    std::free(symbol);
  }
  std::free(static_cast<void*>(firmware.symbol));
  std::free(firmware.flash);
  std::free(firmware.eeprom);
}

}  // namespace

std::string chip_of_elf(const std::filesystem::path& elf) {
  const ElfFile file(elf);
  if (!file.is_avr()) {
    fail(elf, "is no ELF file of an AVR program");
  }
  std::string chip = device_name(file.section(".note.gnu.avr.deviceinfo"));
  if (chip.empty()) {
    fail(elf, "does not say for which chip it is: avr-gcc notes it when it links");
  }
  return chip;
}

void load_elf_program(const std::filesystem::path& elf, avr_t& avr) {
  elf_firmware_t firmware{};
  if (elf_read_firmware(elf.c_str(), &firmware) != 0) {
    fail(elf, "cannot be read as an ELF file");
  }
  const bool fits = firmware.flashsize > 0 && firmware.flashsize <= avr.flashend + 1;
  if (fits) {
    avr_loadcode(&avr, firmware.flash, firmware.flashsize, firmware.flashbase);
    avr.codeend = firmware.flashbase + firmware.flashsize - firmware.datasize;
  }
  free_firmware(firmware);
  if (!fits) {
    fail(elf, "holds no program that fits into the flash");
  }
}

}  // namespace echomap::emulator
