// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::exports {

/// How a text file of numbers is laid out: one row a line.
struct NumberTableFormat {
  /// The first line; empty where the file begins with numbers.
  std::string_view header;
  char separator = ',';
  std::size_t columns = 0;
};

/// A line of numbers.
struct NumberRow {
  std::vector<double> values;
  std::size_t line = 0;  ///< In the file, from 1, whatever is skipped before it.
};

/// The finite number that all of `field` is.
std::optional<double> parse_number(std::string_view field);

/// Appends the shortest decimal that reads back as the same double.
void append_number(std::string& text, double value);

/// Appends one line of such numbers.
void append_row(std::string& text, std::span<const double> values, char separator);

/// Reads such a file; lines that begin with # are skipped. Throws files::FileError, whose text
/// begins `file:line: ` where the header, the number of columns or a number is wrong.
std::vector<NumberRow> read_number_table(const std::filesystem::path& path,
                                         const NumberTableFormat& format);

/// Reads one line of such a file; throws the same.
NumberRow parse_number_row(std::string_view text,
                           const NumberTableFormat& format,
                           const std::filesystem::path& path,
                           std::size_t line);

/// Throws files::FileError with the text `file:line: message`.
[[noreturn]] void fail_at_line(const std::filesystem::path& path,
                               std::size_t line,
                               const std::string& message);

}  // namespace echomap::exports
