// SPDX-License-Identifier: MIT
#include "host/files/toml_reader.hpp"

#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <toml++/toml.h>

#include "host/files/atomic_file.hpp"
#include "host/files/nearest_word.hpp"

namespace echomap::files {

struct TomlReader::Node {
  std::shared_ptr<const toml::table> document;
  const toml::table* table = nullptr;
  std::string file;
  std::set<std::string, std::less<>> asked;
  std::vector<std::shared_ptr<Node>> children;

  const toml::node* find(std::string_view key) {
    asked.emplace(key);
    return table->get(key);
  }
  std::shared_ptr<Node> child(const toml::table& of) {
    for (const auto& known : children) {
      if (known->table == &of) {
        return known;
      }
    }
    return children.emplace_back(std::make_shared<Node>(Node{document, &of, file, {}, {}}));
  }
  /// "; line 7 has 'trak_m'" where a key that nobody has asked for yet looks like `key`.
  std::string lookalike_of(std::string_view key) const {
    std::string hint;
    std::size_t min_slips = 3;
    for (const auto& [present, value] : *table) {
      const std::size_t slips = edit_distance(present.str(), key);
      if (slips < min_slips && !asked.contains(present.str())) {
        min_slips = slips;
        hint = "; line " + std::to_string(present.source().begin.line) + " has '" +
               std::string(present.str()) + "'";
      }
    }
    return hint;
  }
  [[noreturn]] void fail(const toml::source_region& place, const std::string& message) const {
    throw ConfigError(file + ":" + std::to_string(place.begin.line) + ":" +
                      std::to_string(place.begin.column) + ": " + message);
  }
};

namespace {

template <class T>
std::optional<T> value_of(const toml::node* node) {
  return node == nullptr ? std::nullopt : node->value_exact<T>();
}

std::optional<double> finite_number(const toml::node* node) {
  const auto number = node == nullptr ? std::nullopt : node->value<double>();
  const bool usable =
      number && (node->is_floating_point() || node->is_integer()) && std::isfinite(*number);
  return usable ? number : std::nullopt;
}

std::optional<std::array<double, 2>> pair_of(const toml::node& node) {
  const toml::array* pair = node.as_array();
  if (pair == nullptr || pair->size() != 2) {
    return std::nullopt;
  }
  const auto x = finite_number(pair->get(0));
  const auto y = finite_number(pair->get(1));
  return x && y ? std::optional(std::array{*x, *y}) : std::nullopt;
}

std::string quoted(std::string_view key) { return "'" + std::string(key) + "'"; }

}  // namespace

TomlReader TomlReader::load(const std::filesystem::path& path) {
  try {
    return parse(read_text_file(path), path.string());
  } catch (const FileError& error) {
    throw ConfigError(error.what());
  }
}

TomlReader TomlReader::parse(std::string_view text, const std::string& name) {
  try {
    auto document = std::make_shared<const toml::table>(toml::parse(text, name));
    const toml::table* root = document.get();
    return TomlReader(std::make_shared<Node>(Node{std::move(document), root, name, {}, {}}));
  } catch (const toml::parse_error& error) {
    Node{nullptr, nullptr, name, {}, {}}.fail(error.source(), std::string(error.description()));
  }
}

bool TomlReader::has(std::string_view key) const { return node_->find(key) != nullptr; }

double TomlReader::number(std::string_view key) const {
  const toml::node* node = node_->find(key);
  const auto value = finite_number(node);
  if (!value) {
    fail(key, quoted(key) + (node == nullptr ? " is missing" : " must be a finite number"));
  }
  return *value;
}

double TomlReader::number_or(std::string_view key, double fallback) const {
  return has(key) ? number(key) : fallback;
}

std::int64_t TomlReader::integer(std::string_view key) const {
  const toml::node* node = node_->find(key);
  const auto value = value_of<std::int64_t>(node);
  if (!value) {
    fail(key, quoted(key) + (node == nullptr ? " is missing" : " must be a whole number"));
  }
  return *value;
}

bool TomlReader::boolean_or(std::string_view key, bool fallback) const {
  const toml::node* node = node_->find(key);
  if (node == nullptr) {
    return fallback;
  }
  const auto value = value_of<bool>(node);
  if (!value) {
    fail(key, quoted(key) + " must be true or false");
  }
  return *value;
}

std::string TomlReader::text(std::string_view key) const {
  const toml::node* node = node_->find(key);
  const auto value = value_of<std::string>(node);
  if (!value) {
    fail(key, quoted(key) + (node == nullptr ? " is missing" : " must be a text in quotes"));
  }
  return *value;
}

std::string TomlReader::text_or(std::string_view key, std::string_view fallback) const {
  return has(key) ? text(key) : std::string(fallback);
}

std::vector<std::array<double, 2>> TomlReader::points(std::string_view key) const {
  const toml::node* node = node_->find(key);
  if (node == nullptr || !node->is_array()) {
    fail(key, quoted(key) + (node == nullptr ? " is missing" : " must be a list of [x, y] pairs"));
  }
  std::vector<std::array<double, 2>> result;
  for (const toml::node& element : *node->as_array()) {
    const auto pair = pair_of(element);
    if (!pair) {
      node_->fail(element.source(), quoted(key) + " must hold [x, y] pairs of finite numbers");
    }
    result.push_back(*pair);
  }
  return result;
}

TomlReader TomlReader::table(std::string_view key) const {
  const toml::node* node = node_->find(key);
  if (node == nullptr || !node->is_table()) {
    fail(
        key,
        "table [" + std::string(key) + "] " + (node == nullptr ? "is missing" : "must be a table"));
  }
  return TomlReader(node_->child(*node->as_table()));
}

std::vector<TomlReader> TomlReader::tables(std::string_view key) const {
  const toml::node* node = node_->find(key);
  std::vector<TomlReader> result;
  if (node == nullptr) {
    return result;
  }
  if (!node->is_array_of_tables()) {
    fail(key, "[[" + std::string(key) + "]] must be an array of tables");
  }
  for (const toml::node& element : *node->as_array()) {
    result.push_back(TomlReader(node_->child(*element.as_table())));
  }
  return result;
}

void TomlReader::reject_unknown_keys() const {
  for (const auto& [key, value] : *node_->table) {
    if (!node_->asked.contains(key.str())) {
      const std::vector<std::string> valid(node_->asked.begin(), node_->asked.end());
      node_->fail(key.source(), "unknown key " + quoted(key.str()) + suggestion(key.str(), valid));
    }
  }
  for (const auto& child : node_->children) {
    TomlReader(child).reject_unknown_keys();
  }
}

void TomlReader::fail(std::string_view key, const std::string& message) const {
  const toml::node* node = node_->table->get(key);
  if (node == nullptr) {
    node_->fail(node_->table->source(), message + node_->lookalike_of(key));
  }
  node_->fail(node->source(), message);
}

}  // namespace echomap::files
