// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "host/session/operator_command.hpp"

namespace echomap::live_page {

/// Why a command is not taken (docs/live_protocol.md).
enum class RefusalCode : std::uint8_t {
  kUnknown,
  kMalformed,
  kNotPossible,
  kStale,
  kNotDriver,
  kBusy,
};

/// As it is written in an answer: "not-driver".
std::string_view name_of(RefusalCode code);

/// A command that is not taken.
struct Refusal {
  RefusalCode code = RefusalCode::kMalformed;
  std::string why;  ///< In words.
};

/// Steers, as long as what the driver has seen is new.
struct Drive {
  session::SteerRobot steer;
  double seen_ms = 0.0;  ///< Of the server's clock.
};
/// Lets go of the driver lock.
struct ReleaseLock {};
/// What others see of a client that drives.
struct NameClient {
  std::string name;
};
/// Asks for the server's clock.
struct AskClock {};

/// What a client asks for.
using ClientRequest =
    std::variant<Refusal, session::OperatorCommand, Drive, ReleaseLock, NameClient, AskClock>;

/// One command of a client.
struct ClientCommand {
  std::optional<std::uint64_t> seq;  ///< The client's number for it.
  std::string name;                  ///< As in the document: "go". Empty where there is none.
  ClientRequest request;
};

/// Reads a command; a stop is understood whatever else the text holds.
ClientCommand parse_command(std::string_view text);

/// Without control characters and broken UTF-8, at most so many characters.
std::string cleaned_name(std::string_view text, std::size_t max_characters);

}  // namespace echomap::live_page
