// SPDX-License-Identifier: MIT
#include "tests/structure/file_rules.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

namespace echomap::structure {
namespace {

constexpr std::size_t kMaxLines = 500;
const std::string spdx_start = "// SPDX-License-Identifier: ";

/// The emulators have the licences of what they link: libsimavr is GPL-3, Unicorn GPL-2; all else
/// is MIT.
std::string licence_of(const std::string& path) {
  if (is_below(path, "hil_mock/unicorn")) {
    return "GPL-2.0-or-later";
  }
  return is_below(path, "hil_mock/emulator") ? "GPL-3.0-or-later" : "MIT";
}

std::string at_line(const SourceFile& file, std::size_t index) {
  return file.path + ":" + std::to_string(index + 1) + ": ";
}

/// Reports every line of `file` that `pattern` finds.
void find_in_lines(const SourceFile& file,
                   const std::regex& pattern,
                   const std::string& what,
                   Problems& problems) {
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    if (std::regex_search(file.lines[i], pattern)) {
      problems.push_back(at_line(file, i) + what);
    }
  }
}

bool is_portable_firmware(const std::string& path) {
  const std::vector<std::string> folders{"protocol",
                                         "firmware/hal",
                                         "firmware/drivers",
                                         "firmware/control",
                                         "firmware/tasks",
                                         "firmware/app"};
  return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
    return is_below(path, folder);
  });
}

/// True where line `index` opens a paragraph of declarations that needs a comment. What is only
/// announced, specialised or defined here has it elsewhere, and an operator says it itself.
bool wants_comment(const std::vector<std::string>& lines, std::size_t index) {
  static const std::regex declaration("[A-Za-z_\\[].*");
  static const std::regex namespace_body("(inline )?namespace .*\\{");
  static const std::regex needs_none(
      "namespace .*|(class|struct|enum class) \\w+;|extern "
      "\"C\".*|.*\\w::\\w+\\(.*|.*\\boperator\\b.*|template <.*> ?(class|struct) \\w+<.*");
  const std::string& line = lines[index];
  const std::string& before = lines[index - 1];
  if (!std::regex_match(line, declaration) ||
      !(before.empty() || std::regex_match(before, namespace_body))) {
    return false;
  }
  const bool goes_on = line.rfind("template", 0) == 0 && index + 1 < lines.size();
  return !std::regex_match(goes_on ? line + lines[index + 1] : line, needs_none);
}

}  // namespace

Problems first_line_problems(const std::vector<SourceFile>& files) {
  Problems problems;
  for (const SourceFile& file : files) {
    if (file.lines.empty() || file.lines[0] != spdx_start + licence_of(file.path)) {
      problems.push_back(file.path + ": the first line is not " + spdx_start +
                         licence_of(file.path));
    } else if (is_header(file) && (file.lines.size() < 2 || file.lines[1] != "#pragma once")) {
      problems.push_back(file.path + ": the second line is not #pragma once");
    }
  }
  return problems;
}

Problems length_problems(const std::vector<SourceFile>& files) {
  Problems problems;
  for (const SourceFile& file : files) {
    if (file.lines.size() > kMaxLines) {
      problems.push_back(file.path + ": " + std::to_string(file.lines.size()) + " lines");
    }
  }
  return problems;
}

Problems untested_source_problems(const std::vector<SourceFile>& files,
                                  const std::vector<std::string>& exceptions) {
  std::set<std::string> paths;
  for (const SourceFile& file : files) {
    paths.insert(file.path);
  }
  const auto is_excepted = [&](const std::string& path) {
    return std::any_of(exceptions.begin(), exceptions.end(), [&](const std::string& exception) {
      return is_below(path, exception);
    });
  };
  Problems problems;
  for (const SourceFile& file : files) {
    if (is_header(file) || is_below(file.path, "tests") || is_excepted(file.path)) {
      continue;
    }
    const std::string test = "tests/" + file.path.substr(0, file.path.size() - 4) + "_test.cpp";
    if (paths.count(test) == 0) {
      problems.push_back(file.path + ": there is no " + test);
    }
  }
  return problems;
}

Problems folder_name_problems(const std::vector<SourceFile>& files) {
  static const std::set<std::string> no_purpose{
      "util", "utils", "common", "core", "helpers", "misc"};
  Problems problems;
  for (const SourceFile& file : files) {
    for (const auto& part : std::filesystem::path(file.path).parent_path()) {
      if (no_purpose.count(part.string()) > 0) {
        problems.push_back(file.path + ": a folder named " + part.string() + " has no purpose");
      }
    }
  }
  return problems;
}

Problems portability_problems(const std::vector<SourceFile>& files) {
  static const std::regex cpp_header("^\\s*#\\s*include\\s*<[^.>]*>");
  static const std::regex std_pattern("^(?!\\s*//).*\\bstd::");
  Problems problems;
  for (const SourceFile& file : files) {
    if (is_portable_firmware(file.path)) {
      find_in_lines(file, cpp_header, "avr-g++ has no C++ headers", problems);
      find_in_lines(file, std_pattern, "avr-g++ has no namespace std", problems);
    }
  }
  return problems;
}

Problems undocumented_problems(const std::vector<SourceFile>& files) {
  Problems problems;
  for (const SourceFile& file : files) {
    if (!is_header(file) || is_below(file.path, "tests")) {
      continue;
    }
    for (std::size_t i = 1; i < file.lines.size(); ++i) {
      if (wants_comment(file.lines, i)) {
        problems.push_back(at_line(file, i) + "no /// before: " + file.lines[i]);
      }
    }
  }
  return problems;
}

Problems reminder_problems(const std::vector<SourceFile>& files) {
  // The brackets keep this line from being one itself.
  static const std::regex reminder("\\b(TOD[O]|FIXM[E]|XX[X])\\b");
  Problems problems;
  for (const SourceFile& file : files) {
    find_in_lines(file, reminder, "a reminder belongs into an issue", problems);
  }
  return problems;
}

}  // namespace echomap::structure
