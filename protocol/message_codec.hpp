// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>
#include <string.h>

#include "protocol/message_schema.hpp"

namespace echomap {
namespace protocol {

#if __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "fields are copied as they stand in memory: the wire is little-endian"
#endif

/// Visitor that writes fields little-endian at `out`.
class PutVisitor {
 public:
  explicit PutVisitor(uint8_t* out) : out_(out) {}
  template <class T>
  __attribute__((always_inline)) void operator()(const char* /*name*/, const T& value) {
    memcpy(out_, &value, sizeof(T));
    out_ += sizeof(T);
  }

 private:
  uint8_t* out_;
};

/// Visitor that reads fields little-endian from `in`.
class GetVisitor {
 public:
  explicit GetVisitor(const uint8_t* in) : in_(in) {}
  template <class T>
  __attribute__((always_inline)) void operator()(const char* /*name*/, T& value) {
    memcpy(&value, in_, sizeof(T));
    in_ += sizeof(T);
  }

 private:
  const uint8_t* in_;
};

/// Writes the payload of `message`; `out` holds MessageFacts<M>::kSize bytes.
template <class M>
void put_payload(const M& message, uint8_t* out) {
  PutVisitor visitor(out);
  M::each(message, visitor);
}

/// The payload of `message` as bytes.
template <class M>
class Payload {
 public:
  explicit Payload(const M& message) { put_payload(message, bytes_); }
  const uint8_t* bytes() const { return bytes_; }

 private:
  uint8_t bytes_[MessageFacts<M>::kSize];
};

/// Reads a message out of a payload of exactly MessageFacts<M>::kSize bytes.
template <class M>
M get_payload(const uint8_t* payload) {
  M message{};
  GetVisitor visitor(payload);
  M::each(message, visitor);
  return message;
}

/// Calls `handler(const M&)` for the message of list `List` that has this id; false where none has.
/// `payload` has the length that the list's schema says, as FrameDecoder grants.
template <class List>
struct Dispatcher;

template <class... Messages>
struct Dispatcher<MessageList<Messages...>> {
  template <class Handler>
  static bool dispatch(uint8_t id, const uint8_t* payload, Handler& handler) {
    bool found = false;
    const bool tried[] = {try_message<Messages>(id, payload, handler, found)...};
    static_cast<void>(tried);
    return found;
  }

 private:
  template <class M, class Handler>
  static bool try_message(uint8_t id, const uint8_t* payload, Handler& handler, bool& found) {
    if (id == M::kId) {
      handler(get_payload<M>(payload));
      found = true;
    }
    return found;
  }
};

}  // namespace protocol
}  // namespace echomap
