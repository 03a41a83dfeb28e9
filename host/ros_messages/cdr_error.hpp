// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace echomap::ros_messages {

/// Bytes are not a message of the type that they are read as; what() names the type, the field and
/// the reason.
class CdrError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace echomap::ros_messages
