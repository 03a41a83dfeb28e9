// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::files {

/// A configuration file that cannot be used; what() begins with `file:line:column: `.
class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One table of a TOML file, read strictly: a missing key, a wrong type and, with
/// `reject_unknown_keys`, a key that nobody asked for are ConfigErrors that name file, line, column
/// and, for an unknown key, the nearest valid one. Copies share what has been asked for.
class TomlReader {
 public:
  static TomlReader load(const std::filesystem::path& path);
  /// `name` stands for the file in messages.
  static TomlReader parse(std::string_view text, const std::string& name);

  bool has(std::string_view key) const;

  /// A finite number (integers count); in the `_or` forms the fallback stands for an absent key.
  double number(std::string_view key) const;
  double number_or(std::string_view key, double fallback) const;
  std::int64_t integer(std::string_view key) const;
  bool boolean_or(std::string_view key, bool fallback) const;
  std::string text(std::string_view key) const;
  std::string text_or(std::string_view key, std::string_view fallback) const;
  /// A list of [x, y] pairs.
  std::vector<std::array<double, 2>> points(std::string_view key) const;

  TomlReader table(std::string_view key) const;
  /// An array of tables; none where the key is absent.
  std::vector<TomlReader> tables(std::string_view key) const;

  /// Call when every key has been asked for; looks at this table and at those read through it.
  void reject_unknown_keys() const;

  /// Throws a ConfigError at the place of `key`; where it is absent, at that of this table, with a
  /// hint at a key that looks like it.
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;

 private:
  struct Node;
  explicit TomlReader(std::shared_ptr<Node> node) : node_(std::move(node)) {}

  std::shared_ptr<Node> node_;
};

}  // namespace echomap::files
