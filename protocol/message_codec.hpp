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

/// True where M stands in memory as it does on the wire, without a gap: on chips of 8 bits, whose
/// flash has no room for a copy that is not needed.
template <class M>
constexpr bool is_packed() {
  return sizeof(M) == MessageFacts<M>::kSize;
}

/// The payload of `message` as bytes, which may be those of the message itself: it must live on.
template <class M, bool kPacked = is_packed<M>()>
class Payload {
 public:
  explicit Payload(const M& message) { put_payload(message, bytes_); }
  const uint8_t* bytes() const { return bytes_; }

 private:
  uint8_t bytes_[MessageFacts<M>::kSize];
};

template <class M>
class Payload<M, true> {
 public:
  explicit Payload(const M& message) : message_(message) {}
  const uint8_t* bytes() const { return reinterpret_cast<const uint8_t*>(&message_); }

 private:
  const M& message_;
};

/// Reads a message out of a payload of exactly MessageFacts<M>::kSize bytes.
template <class M>
M get_payload(const uint8_t* payload) {
  M message{};
  GetVisitor visitor(payload);
  M::each(message, visitor);
  return message;
}

/// The message of a payload, which may be the payload itself: it must live on.
template <class M, bool kPacked = is_packed<M>()>
class Received {
 public:
  explicit Received(const uint8_t* payload) : message_(get_payload<M>(payload)) {}
  const M& message() const { return message_; }

 private:
  M message_;
};

/// Nobody writes to the payload but as bytes, which may alias whatever stands there.
template <class M>
class Received<M, true> {
 public:
  explicit Received(const uint8_t* payload) : payload_(payload) {}
  const M& message() const { return *reinterpret_cast<const M*>(payload_); }

 private:
  const uint8_t* payload_;
};

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
      const Received<M> received(payload);
      handler(received.message());
      found = true;
    }
    return found;
  }
};

}  // namespace protocol
}  // namespace echomap
