// SPDX-License-Identifier: MIT
#include "tests/structure/layer_table.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

namespace echomap::structure {
namespace {

/// A name of a "may include" cell as a folder: siblings are named without their parent.
std::string qualified(const std::string& name, const std::string& folder) {
  static const std::string kEverythingOf = "everything of ";
  if (name.rfind(kEverythingOf, 0) == 0) {
    return name.substr(kEverythingOf.size());
  }
  const bool is_path = name.find('/') != std::string::npos;
  const bool is_top = std::count(kSourceFolders.begin(), kSourceFolders.end(), name) > 0;
  return is_path || is_top ? name : folder.substr(0, folder.find('/')) + "/" + name;
}

std::set<std::string> folders_in(const std::string& cell, const std::string& folder) {
  static const std::regex kName(R"(\s*([a-z_/ ]*[a-z_/])\s*)");
  std::set<std::string> folders;
  std::istringstream names(cell);
  for (std::string name; std::getline(names, name, ',');) {
    std::smatch match;
    if (std::regex_match(name, match, kName) && match[1] != "nothing") {
      folders.insert(qualified(match[1], folder));
    }
  }
  return folders;
}

}  // namespace

LayerRules read_layer_rules(const std::vector<std::string>& markdown) {
  static const std::regex kRow(R"(\| `([a-z_/]+)` \|.*\| ([^|(]*)(?:\(([^)]*)\))? *\|)");
  static const std::regex kAlso(R"(([a-z_]+): also ([a-z_, ]+))");
  LayerRules rules;
  for (const std::string& line : markdown) {
    std::smatch row;
    if (!std::regex_match(line, row, kRow)) {
      continue;
    }
    const std::string folder = row[1];
    rules[folder] = folders_in(row[2], folder);
    const std::string note = row[3];
    std::smatch also;
    if (std::regex_match(note, also, kAlso)) {
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

std::set<std::string> LayerTable::reachable_from(const std::string& folder) const {
  std::set<std::string> reached;
  std::vector<std::string> open{folder};
  while (!open.empty()) {
    const std::string from = open.back();
    open.pop_back();
    for (const auto& [ruled, allowed] : rules_) {
      if (ruled == from || (from != folder && is_below(ruled, from))) {
        for (const std::string& next : allowed) {
          if (reached.insert(next).second) {
            open.push_back(next);
          }
        }
      }
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
