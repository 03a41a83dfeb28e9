// SPDX-License-Identifier: MIT
#include "host/live_page/web_request.hpp"

#include <algorithm>
#include <charconv>

namespace echomap::live_page {
namespace {

char lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::vector<std::string_view> WebRequest::values_of(std::string_view name) const {
  std::vector<std::string_view> values;
  for (const auto& [key, value] : headers) {
    if (is_same_text(key, name)) {
      values.emplace_back(value);
    }
  }
  return values;
}

std::optional<std::string_view> WebRequest::value_of(std::string_view name) const {
  const auto values = values_of(name);
  return values.size() == 1 ? std::optional(values.front()) : std::nullopt;
}

std::string_view WebRequest::path() const {
  return std::string_view(target).substr(0, target.find('?'));
}

std::optional<std::string> WebRequest::query_value(std::string_view key) const {
  const std::size_t question = target.find('?');
  if (question == std::string::npos) {
    return std::nullopt;
  }
  for (const auto entry : elements_of(std::string_view(target).substr(question + 1), '&')) {
    const std::size_t equals = entry.find('=');
    if (equals != std::string_view::npos && entry.substr(0, equals) == key) {
      return percent_decoded(entry.substr(equals + 1));
    }
  }
  return std::nullopt;
}

bool is_same_text(std::string_view a, std::string_view b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

std::vector<std::string_view> elements_of(std::string_view list, char separator) {
  std::vector<std::string_view> elements;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(separator), list.size());
    const std::string_view element = without_blanks(list.substr(0, end));
    if (!element.empty()) {
      elements.push_back(element);
    }
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return elements;
}

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  while (!text.empty()) {
    if (text.front() != '%') {
      decoded += text.front();
      text.remove_prefix(1);
      continue;
    }
    unsigned char byte = 0;
    const char* digits = text.data() + 1;
    if (text.size() < 3 || std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2) {
      return std::nullopt;
    }
    decoded += static_cast<char>(byte);
    text.remove_prefix(3);
  }
  return decoded;
}

}  // namespace echomap::live_page
