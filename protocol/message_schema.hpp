// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace protocol {

/// How a message travels; docs/protocol.md explains each class.
enum class MessageClass : uint8_t {
  kHandshake,  ///< Repeated by the host until it is answered.
  kTelemetry,  ///< Never acknowledged; counters are cumulative, so a loss costs a sample only.
  kSetpoint,   ///< The latest wins; carries its own time to live.
  kCommand,    ///< Acknowledged, resent, done exactly once; its first field is `command_id`.
  kBulk,       ///< Asked for in pieces; asking twice does no harm.
};

/// Code of a field's type, part of the seed and of descriptions.
template <class T>
struct TypeCode;
template <>
struct TypeCode<uint8_t> {
  static constexpr char kValue = 'B';
};
template <>
struct TypeCode<int8_t> {
  static constexpr char kValue = 'b';
};
template <>
struct TypeCode<uint16_t> {
  static constexpr char kValue = 'H';
};
template <>
struct TypeCode<int16_t> {
  static constexpr char kValue = 'h';
};
template <>
struct TypeCode<uint32_t> {
  static constexpr char kValue = 'I';
};
template <>
struct TypeCode<int32_t> {
  static constexpr char kValue = 'i';
};

/// FNV-1a over characters, the hash behind seeds and the schema digest.
class SchemaHash {
 public:
  constexpr void add(char character) {
    value_ = (value_ ^ static_cast<uint8_t>(character)) * 16777619UL;
  }
  constexpr void add_text(const char* text) {
    for (; *text != '\0'; ++text) {
      add(*text);
    }
    add('\0');
  }
  constexpr uint32_t value() const { return value_; }
  constexpr uint16_t folded() const { return static_cast<uint16_t>(value_ ^ (value_ >> 16)); }

 private:
  uint32_t value_ = 2166136261UL;
};

/// Visitor that sums the bytes of a message's fields.
struct SizeVisitor {
  uint8_t bytes = 0;
  template <class T>
  constexpr void operator()(const char* /*name*/, const T& /*value*/) {
    bytes = static_cast<uint8_t>(bytes + sizeof(T));
  }
};

/// Visitor that hashes a message's field names and types.
struct SeedVisitor {
  SchemaHash hash;
  template <class T>
  constexpr void operator()(const char* name, const T& /*value*/) {
    hash.add_text(name);
    hash.add(TypeCode<T>::kValue);
  }
};

/// Bytes of M's payload.
template <class M>
constexpr uint8_t payload_size_of() {
  const M message{};
  SizeVisitor visitor;
  M::each(message, visitor);
  return visitor.bytes;
}

/// Seed of M's CRC: its name, field names and types.
template <class M>
constexpr uint16_t seed_of() {
  const M message{};
  SeedVisitor visitor;
  visitor.hash.add_text(M::name());
  M::each(message, visitor);
  return visitor.hash.folded();
}

/// Compile-time facts of message M. As enumerators of a template they are constants everywhere; a
/// function call would leave the hash of every field name in the AVR's program.
template <class M>
struct MessageFacts {
  enum : uint16_t { kSeed = seed_of<M>() };
  enum : uint8_t { kSize = payload_size_of<M>() };
};

/// What a frame decoder must know of a message id.
struct Schema {
  /// `payload_size` of an id that the receiver does not know; no frame is as large.
  static constexpr uint8_t kUnknown = 255;

  uint16_t seed;
  uint8_t payload_size;
  bool known() const { return payload_size != kUnknown; }
};

/// A compile-time list of messages.
template <class... Messages>
struct MessageList {
  /// The schema of `id`, or one that is not `known()`.
  static Schema find_schema(uint8_t id) {
    static constexpr uint8_t kIds[] = {Messages::kId...};
    static constexpr Schema kSchemas[] = {
        {MessageFacts<Messages>::kSeed, MessageFacts<Messages>::kSize}...};
    constexpr uint8_t kCount = sizeof...(Messages);
    for (uint8_t i = 0; i < kCount; ++i) {
      if (kIds[i] == id) {
        return kSchemas[i];
      }
    }
    return Schema{0, Schema::kUnknown};
  }

  /// Hash of every id and seed, compared in the handshake.
  static constexpr uint32_t digest() {
    SchemaHash hash;
    const bool added[] = {add_to_digest<Messages>(hash)...};
    static_cast<void>(added);
    return hash.value();
  }

  /// Calls `handler` with a null pointer to each message type in order.
  template <class Handler>
  static void for_each(Handler& handler) {
    const bool called[] = {call<Messages>(handler)...};
    static_cast<void>(called);
  }

 private:
  template <class M>
  static constexpr bool add_to_digest(SchemaHash& hash) {
    hash.add(static_cast<char>(M::kId));
    hash.add(static_cast<char>(MessageFacts<M>::kSeed & 0xFF));
    hash.add(static_cast<char>(MessageFacts<M>::kSeed >> 8));
    return true;
  }

  template <class M, class Handler>
  static bool call(Handler& handler) {
    handler(static_cast<const M*>(nullptr));
    return true;
  }
};

}  // namespace protocol
}  // namespace echomap
