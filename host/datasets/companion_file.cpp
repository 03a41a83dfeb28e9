// SPDX-License-Identifier: MIT
#include "host/datasets/companion_file.hpp"

#include <system_error>

#include "host/files/atomic_file.hpp"

namespace echomap::datasets {
namespace {

std::string unpacked_name(const std::filesystem::path& path) {
  return path.extension() == ".gz" ? path.stem().string() : path.filename().string();
}

/// `path` with the other ending, unpacked.
std::filesystem::path renamed(const std::filesystem::path& path,
                              std::string_view ending,
                              std::string_view other) {
  if (!has_ending(path, ending)) {
    throw files::FileError(path.string() + ": the name of a log of this format ends in " +
                           std::string(ending));
  }
  std::string name = unpacked_name(path);
  name.replace(name.size() - ending.size(), ending.size(), other);
  return path.parent_path() / name;
}

}  // namespace

bool has_ending(const std::filesystem::path& path, std::string_view ending) {
  return unpacked_name(path).ends_with(ending);
}

std::optional<std::filesystem::path> companion_file(const std::filesystem::path& path,
                                                    std::string_view ending,
                                                    std::string_view other) {
  const std::filesystem::path plain = renamed(path, ending, other);
  for (const auto& candidate : {plain, std::filesystem::path(plain.string() + ".gz")}) {
    std::error_code unreadable;
    if (std::filesystem::exists(candidate, unreadable)) {
      return candidate;
    }
  }
  return std::nullopt;
}

std::filesystem::path required_companion(const std::filesystem::path& path,
                                         std::string_view ending,
                                         std::string_view other) {
  const auto companion = companion_file(path, ending, other);
  if (!companion) {
    throw files::FileError(path.string() + ": the log lacks its file " +
                           renamed(path, ending, other).string());
  }
  return *companion;
}

std::optional<FieldCursor> CompanionLines::next() {
  while (const auto line = lines_.next()) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    const FieldCursor fields(lines_, *line);
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    if (!fields.at_end() && !line->starts_with('#')) {
      return fields;
    }
  }
  return std::nullopt;
}

FieldCursor CompanionLines::require(const LineReader& needed_by) {
  if (auto fields = next()) {
    return *fields;
  }
  needed_by.fail("no line of " + lines_.path().string() + " is left for this one");
}

}  // namespace echomap::datasets
