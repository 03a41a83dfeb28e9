// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace echomap::tests {

/// From which file each instruction of an image comes, by its line table: link-time optimisation
/// leaves few functions to go by.
class SourceLines {
 public:
  /// Throws std::runtime_error where avr-objdump finds no line table.
  explicit SourceLines(const std::filesystem::path& elf);

  /// The file of the instruction at byte `address`, below the repository:
  /// "firmware/tasks/safety.cpp"; empty for the compiler's library.
  const std::string& file_at(std::uint32_t address) const;

 private:
  std::map<std::uint32_t, std::string> files_;
};

}  // namespace echomap::tests
