// SPDX-License-Identifier: MIT
#include "tests/structure/repeated_tools.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <regex>
#include <set>

namespace echomap::structure {
namespace {

/// The line at `first` and those behind it up to the brace that opens a function's body; empty
/// where none does.
std::optional<std::string> head_from(const SourceFile& file, std::size_t first) {
  constexpr std::size_t kMaxLines = 8;
  std::string head;
  for (std::size_t i = first; i < file.lines.size() && i < first + kMaxLines; ++i) {
    head += file.lines[i] + ' ';
    for (const std::string end : {") {", ") noexcept {"}) {
      if (const std::size_t at = head.find(end); at != std::string::npos) {
        return head.substr(0, at + 1);
      }
    }
    if (head.find(';') != std::string::npos) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

/// The parameters, split at commas outside of angle brackets.
std::vector<std::string> split_parameters(const std::string& parameters) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : parameters) {
    depth += c == '<' ? 1 : 0;
    depth -= c == '>' ? 1 : 0;
    if (c == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// A parameter without its name and its default.
std::string type_of(const std::string& parameter) {
  static const std::regex default_value(R"(\s*=.*$)");
  static const std::regex name(R"(([>&*\s])\s*\w+\s*$)");
  static const std::regex blanks(R"(^\s+|\s+$)");
  const std::string declared = std::regex_replace(parameter, default_value, "");
  return std::regex_replace(std::regex_replace(declared, name, "$1"), blanks, "");
}

bool is_foreign(const std::string& type) {
  static const std::regex qualified(R"(\b(std|Eigen)(::\w+)+)");
  static const std::regex word(R"([A-Za-z_]\w*)");
  static const std::set<std::string> built_in{
      "const", "double", "float", "int", "bool", "char", "unsigned", "long", "short"};
  const std::string rest = std::regex_replace(type, qualified, "");
  for (std::sregex_iterator at(rest.begin(), rest.end(), word), end; at != end; ++at) {
    if (built_in.count(at->str()) == 0) {
      return false;
    }
  }
  return !type.empty();
}

std::optional<std::string> tool_signature(const std::string& head) {
  static const std::regex function(R"(^(?:[A-Za-z_][\w:<>,*& \[\]]*[ *&>])(\w+)\(([^()]*)\)$)");
  std::smatch match;
  if (!std::regex_match(head, match, function)) {
    return std::nullopt;
  }
  std::string types;
  for (const std::string& parameter : split_parameters(match[2])) {
    const std::string type = type_of(parameter);
    if (!is_foreign(type)) {
      return std::nullopt;
    }
    types += (types.empty() ? "" : ", ") + type;
  }
  return match[1].str() + "(" + types + ")";
}

}  // namespace

std::vector<Tool> tools_in(const SourceFile& file) {
  std::vector<Tool> tools;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string& line = file.lines[i];
    if (line.empty() || line.front() == ' ' || line.find('(') == std::string::npos) {
      continue;
    }
    const auto head = head_from(file, i);
    if (const auto signature = head ? tool_signature(*head) : std::nullopt) {
      tools.push_back({*signature, file.path});
    }
  }
  return tools;
}

std::vector<std::string> repeated_tools(const std::vector<SourceFile>& files) {
  std::map<std::string, std::set<std::string>> paths_by_signature;
  for (const SourceFile& file : files) {
    for (const Tool& tool : tools_in(file)) {
      paths_by_signature[tool.signature].insert(tool.path);
    }
  }
  std::vector<std::string> repeated;
  for (const auto& [signature, paths] : paths_by_signature) {
    if (paths.size() > 1) {
      std::string list;
      for (const std::string& path : paths) {
        list += (list.empty() ? ": " : ", ") + path;
      }
      repeated.push_back(signature + list);
    }
  }
  return repeated;
}

std::vector<std::string> second_solvers(const std::vector<SourceFile>& files,
                                        const std::string& solver_folder) {
  const std::vector<std::string> factorizations{"ldlt(",
                                                "LDLT<",
                                                "SimplicialLLT<",
                                                "SparseLU<",
                                                "SparseQR<",
                                                "ConjugateGradient<",
                                                "ouseholderQr(",
                                                "LevenbergMarquardt"};
  std::vector<std::string> solvers;
  for (const SourceFile& file : files) {
    for (std::size_t i = 0; i < file.lines.size() && !is_below(file.path, solver_folder); ++i) {
      const auto is_in_line = [&](const std::string& word) {
        return file.lines[i].find(word) != std::string::npos;
      };
      if (std::any_of(factorizations.begin(), factorizations.end(), is_in_line)) {
        solvers.push_back(file.path + ":" + std::to_string(i + 1));
      }
    }
  }
  return solvers;
}

}  // namespace echomap::structure
