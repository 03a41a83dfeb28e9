// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host/datasets/line_reader.hpp"

namespace echomap::datasets {

/// What stands between the fields of a line.
enum class Separator { kBlanks, kComma };

/// Takes the line that a LineReader gave last apart from its front, strictly: a field that is
/// missing or wrong throws files::FileError with file, line and the field's name.
class FieldCursor {
 public:
  FieldCursor(const LineReader& lines,
              std::string_view line,
              Separator separator = Separator::kBlanks);

  bool at_end() const { return rest_.empty() && !field_is_due_; }
  /// The next field; blanks around it are no part of it.
  std::string_view word(const char* name);
  /// A finite number of at most 1e15, either way.
  double number(const char* name);
  /// The same; empty for the word `none`.
  std::optional<double> number_or_none(const char* name);
  std::int64_t integer(const char* name);
  /// How many fields follow: as many as the line has room for, or it is an error.
  std::size_t count(const char* name);
  void skip(std::size_t fields);
  /// Takes the next field if it is this word; whether it was.
  bool skip_word(std::string_view word);
  /// Throws where anything is left.
  void expect_end() const;

  /// The error of a field: its name, what it holds and why it is wrong.
  [[noreturn]] void fail(const char* name, std::string_view field, const std::string& why) const;

 private:
  double number_in(std::string_view field, const char* name) const;
  std::string_view word_of_blanks();
  std::string_view word_of_commas(const char* name);
  void drop_leading_blanks();

  const LineReader& lines_;
  std::string_view rest_;
  Separator separator_;
  /// With commas: one has been passed, so another field follows even where nothing is left.
  bool field_is_due_ = false;
};

}  // namespace echomap::datasets
