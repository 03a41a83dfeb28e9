// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace echomap::live_page {

/// What an HTTP request says, whole.
struct WebRequest {
  std::string method;  ///< "GET".
  std::string target;  ///< As it came: "/api/v1/runs?x=1".
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  bool is_upgrade = false;  ///< To a WebSocket.

  bool only_reads() const { return method == "GET" || method == "HEAD"; }
  /// All values of a header, whose name is compared without regard to case.
  std::vector<std::string_view> values_of(std::string_view name) const;
  /// Its value; nothing where it is not there, or there twice.
  std::optional<std::string_view> value_of(std::string_view name) const;
  /// The target up to its question mark.
  std::string_view path() const;
  /// Of the target's query, decoded; nothing where it has no such entry.
  std::optional<std::string> query_value(std::string_view key) const;
};

/// ASCII letters without their case.
bool is_same_text(std::string_view a, std::string_view b);

/// ASCII letters in lower case.
std::string lower_case(std::string_view text);

/// The elements of a header's list, without the blanks around them; empty ones are left out.
std::vector<std::string_view> elements_of(std::string_view list, char separator);

/// With %XX put in; nothing where a % is not followed by two digits.
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace echomap::live_page
