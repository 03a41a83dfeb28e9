// SPDX-License-Identifier: MIT
#include "host/session/profile_driver.hpp"

#include <regex>
#include <sstream>

#include "host/console/exit_code.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::session {

std::string with_driver(const std::string& toml, const std::string& driver) {
  static const std::regex any_table(R"(\s*\[.*)");
  static const std::regex drive_table(R"(\s*\[\s*drive\s*\]\s*(#.*)?)");
  static const std::regex driver_key(R"(\s*driver\s*=.*)");
  std::istringstream lines(toml);
  std::string edited;
  bool in_drive = false;
  for (std::string line; std::getline(lines, line);) {
    if (in_drive && std::regex_match(line, driver_key)) {
      continue;
    }
    edited += line + '\n';
    if (std::regex_match(line, any_table)) {
      in_drive = std::regex_match(line, drive_table);
      edited += in_drive ? "driver = \"" + driver + "\"\n" : "";
    }
  }
  if (driver_of(edited) != driver) {
    throw console::CommandError(
        console::ExitCode::kUsage,
        "--driver needs a profile with a line [drive]\n  next: write driver = \"" + driver +
            "\" into the profile");
  }
  return edited;
}

std::string driver_of(const std::string& toml) {
  const auto profile = files::TomlReader::parse(toml, "profile");
  return profile.has("drive") ? profile.table("drive").text_or("driver", "") : "";
}

}  // namespace echomap::session
