// SPDX-License-Identifier: MIT
#include "tests/structure/function_lengths.hpp"

#include <cctype>
#include <cstddef>
#include <regex>

#include "tests/structure/source_code.hpp"

namespace echomap::structure {
namespace {

enum class Block { kOuter, kFunction, kValue };

/// True where a constructor's list of members ends with the name of one: the next brace holds its
/// value.
bool names_a_member(const std::string& head) {
  static const std::regex list(R"([^]*\)[^:]*[^:]:[^:][^]*[\w>]\s*)");
  return std::regex_match(head, list);
}

/// What the brace opens that comes after `head`, outside of functions.
Block block_of(const std::string& head) {
  static const std::regex outer(
      R"(\s*(?:template\s*<[^]*>\s*)?(?:inline\s+)?(?:extern|namespace|struct|class|union)\b[^(]*)");
  static const std::regex value(R"([^(]*=[^]*)");
  const bool is_operator = head.find("operator") != std::string::npos;
  if (std::regex_match(head, outer)) {
    return Block::kOuter;
  }
  const bool has_parameters = head.find('(') != std::string::npos;
  const bool is_value = !is_operator && std::regex_match(head, value);
  return has_parameters && !is_value && !names_a_member(head) ? Block::kFunction : Block::kValue;
}

/// Goes through the code of one file, brace by brace.
class FunctionScanner {
 public:
  explicit FunctionScanner(std::string path) : path_(std::move(path)) {}

  void read(char character) {
    line_ += character == '\n' ? 1 : 0;
    if (depth_ > 0) {
      read_within(character);
    } else if (character == '{') {
      open();
    } else if (character == '}' || character == ';') {
      head_.clear();
    } else {
      extend_head(character);
    }
  }

  std::vector<FunctionLength> functions() && { return std::move(functions_); }

 private:
  void extend_head(char character) {
    const bool is_blank = std::isspace(static_cast<unsigned char>(character)) != 0;
    if (head_.empty() && is_blank) {
      return;
    }
    if (head_.empty()) {
      start_ = line_;
    }
    head_ += character;
    if (head_ == "public:" || head_ == "protected:" || head_ == "private:") {
      head_.clear();
    }
  }

  void open() {
    block_ = block_of(head_);
    depth_ = block_ == Block::kOuter ? 0 : 1;
    if (block_ != Block::kValue) {
      head_.clear();
    }
  }

  /// In a function or a value, whose braces are only counted.
  void read_within(char character) {
    depth_ += character == '{' ? 1 : character == '}' ? -1 : 0;
    if (depth_ == 0 && block_ == Block::kFunction) {
      functions_.push_back({path_, start_, line_ - start_ + 1});
    } else if (depth_ == 0) {
      head_ += ')';  // As if the value were in parentheses.
    }
  }

  std::string path_;
  int line_ = 1;
  int start_ = 0;
  std::string head_;
  int depth_ = 0;
  Block block_ = Block::kOuter;
  std::vector<FunctionLength> functions_;
};

}  // namespace

std::vector<FunctionLength> functions_in(const SourceFile& file) {
  FunctionScanner scanner(file.path);
  for (const char character : code_of(file)) {
    scanner.read(character);
  }
  return std::move(scanner).functions();
}

}  // namespace echomap::structure
