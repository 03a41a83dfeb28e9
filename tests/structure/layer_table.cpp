// SPDX-License-Identifier: MIT
#include "tests/structure/layer_table.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

namespace echomap::structure {
namespace {

/// A name of a "may include" cell as a folder: siblings are named without their parent.
std::string qualified(const std::string& name, const std::string& folder) {
  static const std::string everything_of = "everything of ";
  if (name.rfind(everything_of, 0) == 0) {
    return name.substr(everything_of.size());
  }
  const bool is_path = name.find('/') != std::string::npos;
  const bool is_top = std::count(source_folders.begin(), source_folders.end(), name) > 0;
  return is_path || is_top ? name : folder.substr(0, folder.find('/')) + "/" + name;
}

std::set<std::string> folders_in(const std::string& cell, const std::string& folder) {
  static const std::regex name_pattern(R"(\s*([a-z0-9_/ ]*[a-z0-9_/])\s*)");
  std::set<std::string> folders;
  std::istringstream names(cell);
  for (std::string name; std::getline(names, name, ',');) {
    std::smatch match;
    if (std::regex_match(name, match, name_pattern) && match[1] != "nothing") {
      folders.insert(qualified(match[1], folder));
    }
  }
  return folders;
}

}  // namespace

LayerRules read_layer_rules(const std::vector<std::string>& markdown) {
  static const std::regex row_pattern(R"(\| `([a-z0-9_/]+)` \|.*\| ([^|(]*)(?:\(([^)]*)\))? *\|)");
  static const std::regex also_pattern(R"(([a-z0-9_]+): also ([a-z0-9_/, ]+))");
  LayerRules rules;
  for (const std::string& line : markdown) {
    std::smatch row;
    if (!std::regex_match(line, row, row_pattern)) {
      continue;
    }
    const std::string folder = row[1];
    rules[folder] = folders_in(row[2], folder);
    const std::string note = row[3];
    std::smatch also;
    if (std::regex_match(note, also, also_pattern)) {
      std::set<std::string>& inner = rules[folder + "/" + also[1].str()];
      inner = folders_in(also[2], folder);
      inner.insert(rules[folder].begin(), rules[folder].end());
    }
  }
  return rules;
}

std::string LayerTable::folder_of(const std::string& path) const {
  std::string longest;
  for (const auto& [folder, allowed] : rules_) {
    if (is_below(path, folder) && folder.size() > longest.size()) {
      longest = folder;
    }
  }
  return longest;
}

std::set<std::string> LayerTable::named_by(const std::string& folder) const {
  std::set<std::string> named;
  for (const auto& [ruled, allowed] : rules_) {
    if (is_below(ruled, folder)) {
      named.insert(allowed.begin(), allowed.end());
    }
  }
  return named;
}

std::set<std::string> LayerTable::reachable_from(const std::string& folder) const {
  std::set<std::string> reached = rules_.at(folder);
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const std::string& lower : std::set<std::string>(reached)) {
      reached.merge(named_by(lower));
    }
  }
  return reached;
}

bool LayerTable::permits(const std::string& folder, const std::string& path) const {
  const std::set<std::string> reachable = reachable_from(folder);
  return folder_of(path) == folder ||
         std::any_of(reachable.begin(), reachable.end(), [&](const std::string& allowed) {
           return is_below(path, allowed);
         });
}

std::string LayerTable::violation(const SourceFile& file,
                                  const Include& include,
                                  const std::set<std::string>& paths) const {
  const std::string top = include.target.substr(0, include.target.find('/'));
  if (!include.quoted) {
    const bool is_ours = top != include.target && paths.count(include.target) > 0;
    return is_ours ? "a file of this tree is included in quotes" : "";
  }
  if (paths.count(include.target) == 0) {
    return "no such path in this tree";
  }
  if (is_below(file.path, "tests")) {
    return "";
  }
  const std::string folder = folder_of(file.path);
  if (folder.empty()) {
    return "the table has no rule for this folder";
  }
  return permits(folder, include.target) ? "" : folder + " may not include it";
}

std::vector<std::string> LayerTable::violations_in(const std::vector<SourceFile>& files) const {
  std::set<std::string> paths;
  for (const SourceFile& file : files) {
    paths.insert(file.path);
  }
  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    for (const Include& include : includes_of(file)) {
      const std::string reason = violation(file, include, paths);
      if (!reason.empty()) {
        violations.push_back(file.path + ":" + std::to_string(include.line) + ": " +
                             include.target + ": " + reason);
      }
    }
  }
  return violations;
}

}  // namespace echomap::structure
