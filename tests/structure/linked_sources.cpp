// SPDX-License-Identifier: MIT
#include "tests/structure/linked_sources.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace echomap::structure {
namespace {

/// Path of a file to the paths that it brings into a program.
using Reach = std::map<std::string, std::vector<std::string>>;

bool is_of_product(const SourceFile& file) { return !is_below(file.path, "tests"); }

bool has_main(const SourceFile& file) {
  return std::any_of(file.lines.begin(), file.lines.end(), [](const std::string& line) {
    return line.rfind("int main(", 0) == 0;
  });
}

Reach reach_of(const std::vector<SourceFile>& files) {
  Reach reach;
  for (const SourceFile& file : files) {
    for (const Include& include : includes_of(file)) {
      if (!include.quoted) {
        continue;
      }
      std::vector<std::string>& reached = reach[file.path];
      if (reached.empty() && !is_header(file)) {
        reach[include.target].push_back(file.path);
      }
      reached.push_back(include.target);
    }
  }
  return reach;
}

}  // namespace

std::vector<std::string> files_in_no_program(const std::vector<SourceFile>& files) {
  std::vector<SourceFile> product;
  std::copy_if(files.begin(), files.end(), std::back_inserter(product), is_of_product);
  const Reach reach = reach_of(product);
  std::vector<std::string> pending;
  for (const SourceFile& file : product) {
    if (has_main(file)) {
      pending.push_back(file.path);
    }
  }
  std::set<std::string> linked;
  while (!pending.empty()) {
    const std::string path = pending.back();
    pending.pop_back();
    const auto reached = reach.find(path);
    if (linked.insert(path).second && reached != reach.end()) {
      pending.insert(pending.end(), reached->second.begin(), reached->second.end());
    }
  }
  std::vector<std::string> others;
  for (const SourceFile& file : product) {
    if (linked.count(file.path) == 0) {
      others.push_back(file.path);
    }
  }
  return others;
}

}  // namespace echomap::structure
