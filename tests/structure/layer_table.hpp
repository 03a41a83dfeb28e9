// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {

/// Folder to the folders that it names as "may include". A name covers every folder below it.
using LayerRules = std::map<std::string, std::set<std::string>>;

/// Reads the table of docs/architecture.md, | `folder` | rule | may include |. A note (x: also y)
/// becomes a rule of its own for the folder x below; other notes in brackets say nothing here.
LayerRules read_layer_rules(const std::vector<std::string>& markdown);

/// Who may include whom, transitively downwards.
class LayerTable {
 public:
  explicit LayerTable(LayerRules rules) : rules_(std::move(rules)) {}

  /// The folder whose rule holds for the file or folder `path`; empty where none does.
  std::string folder_of(const std::string& path) const;

  /// True when a file of `folder` may include the file `path`.
  bool permits(const std::string& folder, const std::string& path) const;

  /// Everything in `files` that breaks the rules, as "file:line: what". A file of tests/ may
  /// include whatever exists.
  std::vector<std::string> violations_in(const std::vector<SourceFile>& files) const;

 private:
  std::set<std::string> named_by(const std::string& folder) const;
  std::set<std::string> reachable_from(const std::string& folder) const;
  std::string violation(const SourceFile& file,
                        const Include& include,
                        const std::set<std::string>& paths) const;

  LayerRules rules_;
};

}  // namespace echomap::structure
