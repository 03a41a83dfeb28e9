// SPDX-License-Identifier: MIT
#pragma once

#include "protocol/messages.hpp"

namespace echomap {
namespace protocol {

/// Visitor that passes each field on to a `sink(name, type_code)`.
template <class Sink>
struct DescribeVisitor {
  Sink& sink;
  template <class T>
  void operator()(const char* name, const T& /*value*/) {
    sink(name, TypeCode<T>::kValue);
  }
};

/// Calls `sink(name, type_code)` for each field of M, in wire order; the source of log columns,
/// printed tables and golden vectors. Type codes are those of TypeCode.
template <class M, class Sink>
void describe(Sink& sink) {
  const M message{};
  DescribeVisitor<Sink> visitor{sink};
  M::each(message, visitor);
}

}  // namespace protocol
}  // namespace echomap
