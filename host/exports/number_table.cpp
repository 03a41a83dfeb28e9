// SPDX-License-Identifier: MIT
#include "host/exports/number_table.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    fields.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return fields;
}

}  // namespace

std::optional<double> parse_number(std::string_view field) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  const bool is_number =
      error == std::errc() && end == field.data() + field.size() && std::isfinite(value);
  return is_number ? std::optional(value) : std::nullopt;
}

void append_number(std::string& text, double value) {
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), result.ptr);
}

void append_row(std::string& text, std::span<const double> values, char separator) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    append_number(text, values[i]);
    text.push_back(i + 1 < values.size() ? separator : '\n');
  }
}

NumberRow parse_number_row(std::string_view text,
                           const NumberTableFormat& format,
                           const std::filesystem::path& path,
                           std::size_t line) {
  const auto fields = split(text, format.separator);
  if (fields.size() != format.columns) {
    fail_at_line(path,
                 line,
                 "expected " + std::to_string(format.columns) + " columns, found " +
                     std::to_string(fields.size()));
  }
  std::vector<double> row;
  for (const std::string_view field : fields) {
    const auto number = parse_number(field);
    if (!number) {
      fail_at_line(path, line, "'" + std::string(field) + "' is not a finite number");
    }
    row.push_back(*number);
  }
  return {row, line};
}

std::vector<NumberRow> read_number_table(const std::filesystem::path& path,
                                         const NumberTableFormat& format) {
  std::istringstream lines(files::read_text_file(path));
  std::vector<NumberRow> rows;
  bool header_is_due = !format.header.empty();
  std::size_t line_number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++line_number;
    if (line.starts_with('#')) {
      continue;
    }
    if (header_is_due) {
      if (line != format.header) {
        fail_at_line(path, line_number, "expected the header '" + std::string(format.header) + "'");
      }
      header_is_due = false;
      continue;
    }
    rows.push_back(parse_number_row(line, format, path, line_number));
  }
  if (header_is_due) {
    fail_at_line(path, 1, "expected the header '" + std::string(format.header) + "'");
  }
  return rows;
}

void fail_at_line(const std::filesystem::path& path, std::size_t line, const std::string& message) {
  throw files::FileError(path.string() + ":" + std::to_string(line) + ": " + message);
}

}  // namespace echomap::exports
