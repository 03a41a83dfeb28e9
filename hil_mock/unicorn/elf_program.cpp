// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/elf_program.hpp"

#include <cstring>
#include <elf.h>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace echomap::unicorn {
namespace {

/// A file's bytes, read with its bounds checked.
class ElfFile {
 public:
  explicit ElfFile(const std::filesystem::path& path) : path_(path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
      fail("cannot be opened");
    }
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
  }

  template <class T>
  T at(std::size_t offset) const {
    T value{};
    std::memcpy(&value, slice(offset, sizeof(T)).data(), sizeof(T));
    return value;
  }

  std::vector<std::uint8_t> slice(std::size_t offset, std::size_t size) const {
    if (offset > bytes_.size() || size > bytes_.size() - offset) {
      fail("is cut short");
    }
    const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(offset);
    return {first, first + static_cast<std::ptrdiff_t>(size)};
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(path_.string() + ": " + what);
  }

 private:
  std::filesystem::path path_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<ProgramSegment> read_elf_program(const std::filesystem::path& elf) {
  const ElfFile file(elf);
  const auto header = file.at<Elf32_Ehdr>(0);
  if (std::memcmp(static_cast<const void*>(header.e_ident), ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_machine != EM_ARM) {
    file.fail("is no ELF file of an ARM program");
  }
  std::vector<ProgramSegment> segments;
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    const auto entry = file.at<Elf32_Phdr>(header.e_phoff + i * sizeof(Elf32_Phdr));
    if (entry.p_type == PT_LOAD && entry.p_filesz != 0) {
      segments.push_back({entry.p_paddr, file.slice(entry.p_offset, entry.p_filesz)});
    }
  }
  if (segments.empty()) {
    file.fail("holds no program");
  }
  return segments;
}

}  // namespace echomap::unicorn
