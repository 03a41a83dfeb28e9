// SPDX-License-Identifier: MIT
#include "tests/structure/type_definitions.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <regex>

namespace echomap::structure {
namespace {

/// Where what begins at `from` ends: behind the next `end`.
std::size_t behind(const std::string& text, const std::string& end, std::size_t from) {
  const std::size_t at = text.find(end, from);
  return at == std::string::npos ? text.size() : at + end.size();
}

/// Behind a string or character literal, or a preprocessor line, in which \ takes the next
/// character's meaning.
std::size_t behind_unescaped(const std::string& text, char end, std::size_t from) {
  std::size_t at = from;
  while (at < text.size() && text[at] != end) {
    at += text[at] == '\\' ? 2 : 1;
  }
  return std::min(at + 1, text.size());
}

/// Where the comment, literal or preprocessor line that begins at `at` ends; `at` where none does.
std::size_t end_of_no_code(const std::string& text, std::size_t at) {
  const bool after_word = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
  if (text.compare(at, 2, "//") == 0) {
    return text.find('\n', at);
  }
  if (text.compare(at, 2, "/*") == 0) {
    return behind(text, "*/", at);
  }
  if (text.compare(at, 2, "R\"") == 0 && !after_word) {
    const std::size_t open = text.find('(', at);
    return behind(text, ")" + text.substr(at + 2, open - at - 2) + "\"", open);
  }
  if (text[at] == '#') {
    return behind_unescaped(text, '\n', at) - 1;
  }
  const bool is_literal = text[at] == '"' || (text[at] == '\'' && !after_word);
  return is_literal ? behind_unescaped(text, text[at], at + 1) : at;
}

/// The text of a file, every comment, literal and preprocessor line as blanks.
std::string code_of(const SourceFile& file) {
  std::string text;
  for (const std::string& line : file.lines) {
    text += line + '\n';
  }
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_no_code(text, at);
    for (std::size_t i = at; i < end; ++i) {
      text[i] = text[i] == '\n' ? '\n' : ' ';
    }
    at = std::max(at + 1, end);
  }
  return text;
}

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
class Scanner {
 public:
  explicit Scanner(std::string path) : path_(std::move(path)) {}

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
  Scanner scanner(file.path);
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
