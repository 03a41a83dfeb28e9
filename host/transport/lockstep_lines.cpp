// SPDX-License-Identifier: MIT
#include "host/transport/lockstep_lines.hpp"

#include <charconv>
#include <system_error>

#include <nlohmann/json.hpp>

namespace echomap::transport {
namespace {

/// Takes one number and the blank before it from the front of `text`.
template <class Number>
bool take_number(std::string_view& text, Number& number) {
  if (!text.starts_with(' ')) {
    return false;
  }
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc();
}

}  // namespace

std::optional<DeviceInfo> parse_lockstep_hello(std::string_view line) {
  const auto hello = nlohmann::json::parse(line, nullptr, false);
  const bool is_hello = hello.is_object() && hello.value("lockstep", nlohmann::json()) == 1;
  if (!is_hello || !hello.value("firmware", nlohmann::json()).is_string() ||
      !hello.value("emulator", nlohmann::json()).is_string()) {
    return std::nullopt;
  }
  return DeviceInfo{hello["firmware"], hello["emulator"]};
}

std::optional<Reached> parse_reached(std::string_view line) {
  constexpr std::string_view kVerb = "reached";
  Reached reached;
  if (!line.starts_with(kVerb)) {
    return std::nullopt;
  }
  line.remove_prefix(kVerb.size());
  const bool is_whole = take_number(line, reached.until_us) &&
                        take_number(line, reached.device_bytes) && line.empty();
  return is_whole ? std::optional(reached) : std::nullopt;
}

}  // namespace echomap::transport
