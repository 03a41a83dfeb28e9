// SPDX-License-Identifier: MIT
#include "host/transport/lockstep_lines.hpp"

#include <charconv>
#include <numbers>
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

/// X_UM Y_UM HEADING_UDEG, a blank before each.
std::optional<TruePose> parse_true_pose(std::string_view text) {
  std::int64_t x_um = 0;
  std::int64_t y_um = 0;
  std::int64_t heading_udeg = 0;
  if (!take_number(text, x_um) || !take_number(text, y_um) || !take_number(text, heading_udeg) ||
      !text.empty()) {
    return std::nullopt;
  }
  const auto whole = [](std::int64_t millionths) { return 1e-6 * static_cast<double>(millionths); };
  return TruePose{whole(x_um), whole(y_um), whole(heading_udeg) * std::numbers::pi / 180.0};
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
  if (!take_number(line, reached.until_us) || !take_number(line, reached.device_bytes)) {
    return std::nullopt;
  }
  if (!line.empty()) {
    reached.true_pose = parse_true_pose(line);
  }
  return line.empty() || reached.true_pose ? std::optional(reached) : std::nullopt;
}

}  // namespace echomap::transport
