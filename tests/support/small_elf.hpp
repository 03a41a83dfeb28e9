// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <elf.h>
#include <string>

namespace echomap::tests {

/// The bytes of a structure, as a file holds them.
template <class T>
std::string bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

/// The header of an ELF file of 32 bits, little endian.
inline Elf32_Ehdr elf_header(std::uint16_t machine) {
  Elf32_Ehdr header{};
  header.e_ident[EI_MAG0] = ELFMAG0;
  header.e_ident[EI_MAG1] = ELFMAG1;
  header.e_ident[EI_MAG2] = ELFMAG2;
  header.e_ident[EI_MAG3] = ELFMAG3;
  header.e_ident[EI_CLASS] = ELFCLASS32;
  header.e_ident[EI_DATA] = ELFDATA2LSB;
  header.e_ident[EI_VERSION] = EV_CURRENT;
  header.e_type = ET_EXEC;
  header.e_machine = machine;
  header.e_version = EV_CURRENT;
  header.e_ehsize = sizeof(header);
  return header;
}

/// An ARM program of four bytes for 0x08000100, which will run at 0x20000000.
struct SmallArmElf {
  SmallArmElf() {
    header.e_phoff = sizeof(header);
    header.e_phentsize = sizeof(segment);
    header.e_phnum = 1;
    segment.p_type = PT_LOAD;
    segment.p_offset = sizeof(header) + sizeof(segment);
    segment.p_paddr = 0x08000100;
    segment.p_vaddr = 0x20000000;
    segment.p_filesz = 4;
  }

  std::string text() const { return bytes_of(header) + bytes_of(segment) + "\1\2\3\4"; }

  Elf32_Ehdr header = elf_header(EM_ARM);
  Elf32_Phdr segment{};
};

/// An AVR file with nothing but the note that says for which chip it is, as avr-gcc writes it.
struct SmallAvrElf {
  explicit SmallAvrElf(const std::string& chip)
      : note_(std::string(16 + 6 * 4 + 2 * 4 + 1, '\0') + chip + '\0') {
    header.e_shoff = sizeof(header);
    header.e_shentsize = sizeof(Elf32_Shdr);
    header.e_shnum = 3;
    header.e_shstrndx = 2;
    const std::uint32_t end_of_table = sizeof(header) + 3 * sizeof(Elf32_Shdr);
    note.sh_name = 1;
    note.sh_type = SHT_NOTE;
    note.sh_offset = end_of_table;
    note.sh_size = static_cast<std::uint32_t>(note_.size());
    names.sh_name = 26;
    names.sh_type = SHT_STRTAB;
    names.sh_offset = end_of_table + note.sh_size;
    names.sh_size = sizeof(kNames);
  }

  std::string text() const {
    return bytes_of(header) + bytes_of(Elf32_Shdr{}) + bytes_of(note) + bytes_of(names) + note_ +
           std::string(kNames, sizeof(kNames));
  }

  Elf32_Ehdr header = elf_header(EM_AVR);
  Elf32_Shdr note{};
  Elf32_Shdr names{};

 private:
  /// Of the sections, from 1 and from 26.
  static constexpr char kNames[] = "\0.note.gnu.avr.deviceinfo\0.shstrtab";

  std::string note_;
};

}  // namespace echomap::tests
