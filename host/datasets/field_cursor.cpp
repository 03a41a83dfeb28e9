// SPDX-License-Identifier: MIT
#include "host/datasets/field_cursor.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace echomap::datasets {
namespace {

constexpr std::string_view kBlanks = " \t";

/// No stamp, length or count of a log is larger; a product of two is still finite.
constexpr double kLargestNumber = 1e15;

/// What may be shown of a field that can hold anything.
std::string printable(std::string_view field) {
  constexpr std::size_t kShown = 40;
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const char letter : field.substr(0, kShown)) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte >= 0x20 && byte < 0x7f) {
      text += letter;
    } else {
      text += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return field.size() > kShown ? text + "..." : text;
}

template <class Number>
bool parse(std::string_view field, Number& value) {
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc() && end == field.data() + field.size();
}

/// from_chars knows no plus sign.
std::string_view without_plus(std::string_view field) {
  const bool has_plus = field.size() > 1 && field[0] == '+' && field[1] != '-';
  return has_plus ? field.substr(1) : field;
}

}  // namespace

FieldCursor::FieldCursor(const LineReader& lines, std::string_view line, Separator separator)
    : lines_(lines), rest_(line), separator_(separator) {
  drop_leading_blanks();
}

std::string_view FieldCursor::word(const char* name) {
  if (at_end()) {
    lines_.fail(std::string(name) + " is missing: the line ends before it");
  }
  return separator_ == Separator::kBlanks ? word_of_blanks() : word_of_commas(name);
}

std::string_view FieldCursor::word_of_blanks() {
  const std::string_view field = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_.remove_prefix(field.size());
  drop_leading_blanks();
  return field;
}

std::string_view FieldCursor::word_of_commas(const char* name) {
  const std::size_t comma = rest_.find(',');
  field_is_due_ = comma != std::string_view::npos;
  std::string_view field = rest_.substr(0, comma);
  rest_.remove_prefix(field_is_due_ ? comma + 1 : rest_.size());
  drop_leading_blanks();
  field = field.substr(0, field.find_last_not_of(kBlanks) + 1);
  if (field.empty()) {
    lines_.fail(std::string(name) + " is missing: there is nothing between two commas");
  }
  return field;
}

double FieldCursor::number(const char* name) { return number_in(word(name), name); }

std::optional<double> FieldCursor::number_or_none(const char* name) {
  const std::string_view field = word(name);
  return field == "none" ? std::nullopt : std::optional(number_in(field, name));
}

double FieldCursor::number_in(std::string_view field, const char* name) const {
  double value = 0.0;
  if (!parse(without_plus(field), value) || !std::isfinite(value)) {
    fail(name, field, "not a finite number");
  }
  if (std::abs(value) > kLargestNumber) {
    fail(name, field, "larger than anything that a log measures");
  }
  return value;
}

std::int64_t FieldCursor::integer(const char* name) {
  const std::string_view field = word(name);
  std::int64_t value = 0;
  if (!parse(without_plus(field), value)) {
    fail(name, field, "not a whole number");
  }
  return value;
}

std::size_t FieldCursor::count(const char* name) {
  const std::string_view field = word(name);
  std::size_t value = 0;
  // A field takes a letter and, unless it is the last, a separator.
  if (!parse(field, value) || value > (rest_.size() + 1) / 2) {
    fail(name, field, "not the number of values on the line");
  }
  return value;
}

bool FieldCursor::skip_word(std::string_view word) {
  FieldCursor ahead(*this);
  if (at_end() || ahead.word("a word") != word) {
    return false;
  }
  rest_ = ahead.rest_;
  field_is_due_ = ahead.field_is_due_;
  return true;
}

void FieldCursor::skip(std::size_t fields) {
  for (std::size_t i = 0; i < fields; ++i) {
    word("a field");
  }
}

void FieldCursor::expect_end() const {
  if (!at_end()) {
    lines_.fail("'" + printable(rest_) + "' follows, the line should end before it");
  }
}

void FieldCursor::fail(const char* name, std::string_view field, const std::string& why) const {
  lines_.fail(std::string(name) + " is '" + printable(field) + "', " + why);
}

void FieldCursor::drop_leading_blanks() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
}

}  // namespace echomap::datasets
