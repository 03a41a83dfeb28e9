// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "protocol/messages.hpp"

namespace echomap::protocol {

/// A MessageList as the types of a TYPED_TEST_SUITE.
template <class List>
struct TestTypes;

template <class... Messages>
struct TestTypes<MessageList<Messages...>> {
  using Types = testing::Types<Messages...>;
};

/// Names typed tests after their message.
struct MessageNames {
  template <class M>
  static std::string GetName(int /*index*/) {  // NOLINT(readability-identifier-naming): GoogleTest
    return M::name();
  }
};

}  // namespace echomap::protocol
