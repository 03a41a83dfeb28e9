// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/message_schema.hpp"

namespace echomap {
namespace protocol {

/// How a schema is described in bytes (BulkContent::kSchema, docs/protocol.md): a head with the id
/// and name of each message, followed by its fields. A field is a definition, or a reference to an
/// earlier one of the same name and type. A name leaves out what it has in common with the
/// beginning of the one spelled before it, of a message or of a field; its last character has
/// kLastCharacter set.
struct SchemaFormat {
  enum : uint8_t {
    kReference = 0x80,  ///< This bit and the number of the definition, counted from 0.
    kTypeBits = 0x07,   ///< Of a head: 0 for a message, else 1 + the place in `type_code`.
    kSharedShift = 3,   ///< Of a head: how many characters the name shares.
    kMaxShared = 15,
    kLastCharacter = 0x80,
    kMaxName = 31,  ///< Characters.
  };
  static constexpr uint16_t kMaxBytes = 4096;
  static constexpr uint8_t kMaxDefinitions = 128;
  static constexpr uint8_t kTypes = 6;

  /// The type codes of TypeCode by number; 0 beyond the last.
  static constexpr char type_code(uint8_t number) {
    return number < kTypes ? "BbHhIi"[number] : '\0';
  }
};

/// Describes messages at compile time; a visitor of their fields.
class SchemaWriter {
 public:
  constexpr void add_message(uint8_t id, const char* name) {
    const uint8_t shared = shared_characters(message_name_, name);
    put(static_cast<uint8_t>(shared << SchemaFormat::kSharedShift));
    put(id);
    put_name(name + shared);
    message_name_ = name;
  }

  /// A field.
  template <class T>
  constexpr void operator()(const char* name, const T& /*value*/) {
    const uint8_t type = type_number(TypeCode<T>::kValue);
    for (uint8_t i = 0; i < definitions_; ++i) {
      if (types_[i] == type && is_same(names_[i], name)) {
        put(static_cast<uint8_t>(SchemaFormat::kReference | i));
        return;
      }
    }
    const uint8_t shared =
        shared_characters(definitions_ == 0 ? "" : names_[definitions_ - 1], name);
    put(static_cast<uint8_t>(shared << SchemaFormat::kSharedShift | (type + 1)));
    put_name(name + shared);
    names_[definitions_] = name;
    types_[definitions_] = type;
    ++definitions_;
  }

  constexpr uint16_t size() const { return size_; }
  constexpr uint8_t byte(uint16_t index) const { return bytes_[index]; }

 private:
  static constexpr uint8_t type_number(char type_code) {
    uint8_t number = 0;
    while (SchemaFormat::type_code(number) != type_code) {
      ++number;
    }
    return number;
  }
  static constexpr bool is_same(const char* one, const char* other) {
    while (*one == *other && *one != '\0') {
      ++one;
      ++other;
    }
    return *one == *other;
  }
  /// At least one character is left over.
  static constexpr uint8_t shared_characters(const char* before, const char* name) {
    uint8_t shared = 0;
    while (shared < SchemaFormat::kMaxShared && before[shared] == name[shared] &&
           before[shared] != '\0' && name[shared + 1] != '\0') {
      ++shared;
    }
    return shared;
  }
  constexpr void put_name(const char* text) {
    for (; text[1] != '\0'; ++text) {
      put(static_cast<uint8_t>(*text));
    }
    put(static_cast<uint8_t>(*text | SchemaFormat::kLastCharacter));
  }
  constexpr void put(uint8_t byte) { bytes_[size_++] = byte; }

  uint8_t bytes_[SchemaFormat::kMaxBytes] = {};
  const char* names_[SchemaFormat::kMaxDefinitions] = {};
  uint8_t types_[SchemaFormat::kMaxDefinitions] = {};
  const char* message_name_ = "";
  uint16_t size_ = 0;
  uint8_t definitions_ = 0;
};

/// The description of a list of messages.
template <uint16_t kBytes>
struct SchemaDescription {
  uint8_t bytes[kBytes];
};

/// Adds M to what `writer` describes.
template <class M>
constexpr bool describe_message(SchemaWriter& writer) {
  const M message{};
  writer.add_message(M::kId, M::name());
  M::each(message, writer);
  return true;
}

/// What describes a list, in a writer that has room to spare.
template <class... Messages>
constexpr SchemaWriter written_schema(MessageList<Messages...> /*list*/) {
  SchemaWriter writer;
  const bool described[] = {describe_message<Messages>(writer)...};
  static_cast<void>(described);
  return writer;
}

/// Describes a list; to be evaluated at compile time, for it takes the space of every name.
template <class List>
constexpr auto describe_schema() {
  constexpr SchemaWriter kWriter = written_schema(List{});
  SchemaDescription<kWriter.size()> description{};
  for (uint16_t i = 0; i < kWriter.size(); ++i) {
    description.bytes[i] = kWriter.byte(i);
  }
  return description;
}

}  // namespace protocol
}  // namespace echomap
