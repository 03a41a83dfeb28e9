// SPDX-License-Identifier: MIT
#include "tests/hil/measure/source_lines.hpp"

#include <array>
#include <cstdio>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace echomap::tests {
namespace {

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "re"), &::pclose);
  std::string output;
  std::array<char, 4096> piece{};
  while (pipe && std::fgets(piece.data(), int(piece.size()), pipe.get()) != nullptr) {
    output += piece.data();
  }
  return output;
}

/// The part of a path that begins at a folder of the repository with firmware sources.
std::string below_repository(const std::string& path) {
  for (const char* folder : {"/firmware/", "/protocol/", "/tests/"}) {
    if (const std::size_t at = path.rfind(folder); at != std::string::npos) {
      return path.substr(at + 1);
    }
  }
  return "";
}

}  // namespace

/// Lines of the dump are "/folders/firmware/a.cpp:" (perhaps after "CU: "), which says where files
/// of that name are, and "a.cpp  LINE  0xADDRESS".
SourceLines::SourceLines(const std::filesystem::path& elf) {
  std::istringstream dump(output_of("avr-objdump --dwarf=decodedline '" + elf.string() + "'"));
  std::map<std::string, std::string> paths;
  for (std::string text; std::getline(dump, text);) {
    if (text.ends_with(':')) {
      const std::string path = text.substr(0, text.size() - 1);
      paths[path.substr(path.rfind('/') + 1)] = below_repository(path);
      continue;
    }
    std::istringstream words(text);
    std::string name;
    std::string line;
    std::string address;
    if (words >> name >> line >> address && address.starts_with("0x")) {
      files_[static_cast<std::uint32_t>(std::stoul(address, nullptr, 16))] = paths[name];
    }
  }
  if (files_.empty()) {
    throw std::runtime_error(elf.string() + ": avr-objdump finds no line table");
  }
}

const std::string& SourceLines::file_at(std::uint32_t address) const {
  static const std::string none;
  const auto behind = files_.upper_bound(address);
  return behind == files_.begin() ? none : std::prev(behind)->second;
}

}  // namespace echomap::tests
