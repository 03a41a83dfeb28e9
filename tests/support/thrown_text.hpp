// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::tests {

/// what() of the `Error` that the action throws; empty where it throws none.
template <class Error, class Action>
std::string thrown_text(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace echomap::tests
