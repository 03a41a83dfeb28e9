// SPDX-License-Identifier: MIT
#include "tests/structure/type_definitions.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <regex>

#include "tests/structure/source_code.hpp"

namespace echomap::structure {
namespace {

/// What a pair of braces holds, by what stands before it.
struct Scope {
  /// Empty for a function's body, a type's and an anonymous namespace's: nothing in them is global.
  std::optional<std::string> name_space;
};

/// `head` without the parameters of a template and without attributes.
std::string plain_head(const std::string& head) {
  static const std::regex attribute(R"(\[\[.*?\]\]|alignas\s*\([^)]*\))");
  const std::size_t start = head.find("template");
  if (start == std::string::npos) {
    return std::regex_replace(head, attribute, " ");
  }
  int depth = 0;
  for (std::size_t i = head.find('<', start); i < head.size(); ++i) {
    depth += head[i] == '<' ? 1 : head[i] == '>' ? -1 : 0;
    if (depth == 0) {
      return plain_head(head.substr(i + 1));
    }
  }
  return "";
}

Scope scope_of(const std::string& head) {
  static const std::regex name_space(R"(\s*(?:inline\s+)?namespace\s+([\w:]+)\s*)");
  static const std::regex linkage(R"(\s*extern\s*)");
  std::smatch match;
  if (std::regex_match(head, match, name_space)) {
    return {match[1].str() + "::"};
  }
  return std::regex_match(head, linkage) ? Scope{""} : Scope{};
}

/// Name of the type whose body begins after `head`.
std::optional<std::string> type_named_by(const std::string& head) {
  static const std::regex type(
      R"(\s*(?:typedef\s+)?(?:struct|class|union|enum|enum\s+class|enum\s+struct)\s+(\w+)(?:\s+final)?\s*(?::[^:][^]*)?)");
  std::smatch match;
  return std::regex_match(head, match, type) ? std::optional(match[1].str()) : std::nullopt;
}

/// Goes through the code of one file, brace by brace.
class TypeScanner {
 public:
  explicit TypeScanner(std::string path) : path_(std::move(path)) {}

  void read(char character) {
    line_ += character == '\n' ? 1 : 0;
    if (character == '{') {
      open();
    } else if (character == '}' && !scopes_.empty()) {
      scopes_.pop_back();
    }
    const bool ends_head = character == '{' || character == '}' || character == ';';
    head_ = ends_head ? "" : head_ + character;
  }

  std::vector<TypeDefinition> types() && { return std::move(types_); }

 private:
  void open() {
    const auto here = name_space();
    if (!here) {
      scopes_.push_back({});
      return;
    }
    const std::string head = plain_head(head_);
    if (const auto name = type_named_by(head)) {
      types_.push_back({*here + *name, path_, line_});
    }
    scopes_.push_back(scope_of(head));
  }

  /// Where the next name is global, the namespace it is in.
  std::optional<std::string> name_space() const {
    std::string whole;
    for (const Scope& scope : scopes_) {
      if (!scope.name_space) {
        return std::nullopt;
      }
      whole += *scope.name_space;
    }
    return whole;
  }

  std::string path_;
  int line_ = 1;
  std::string head_;
  std::vector<Scope> scopes_;
  std::vector<TypeDefinition> types_;
};

}  // namespace

std::vector<TypeDefinition> type_definitions_in(const SourceFile& file) {
  TypeScanner scanner(file.path);
  for (const char character : code_of(file)) {
    scanner.read(character);
  }
  return std::move(scanner).types();
}

std::vector<std::string> types_defined_twice(const std::vector<SourceFile>& files) {
  std::map<std::string, std::vector<std::string>> places;
  for (const SourceFile& file : files) {
    for (const TypeDefinition& type : type_definitions_in(file)) {
      places[type.name].push_back(type.path + ":" + std::to_string(type.line));
    }
  }
  std::vector<std::string> problems;
  for (const auto& [name, where] : places) {
    if (where.size() > 1) {
      std::string problem = name + ": " + where.front();
      for (std::size_t i = 1; i < where.size(); ++i) {
        problem += ", " + where[i];
      }
      problems.push_back(problem);
    }
  }
  return problems;
}

}  // namespace echomap::structure
