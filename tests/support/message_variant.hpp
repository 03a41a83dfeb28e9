// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "protocol/messages.hpp"

namespace echomap::tests {

/// A MessageList as a variant.
template <class List>
struct VariantOf;

template <class... Messages>
struct VariantOf<protocol::MessageList<Messages...>> {
  using Type = std::variant<Messages...>;
};

/// Any message of the robot.
using MessageToHost = VariantOf<protocol::MessagesToHost>::Type;

}  // namespace echomap::tests
