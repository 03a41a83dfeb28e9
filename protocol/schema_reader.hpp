// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/schema_description.hpp"

namespace echomap {
namespace protocol {

/// What SchemaReader::next found.
enum class SchemaItem : uint8_t {
  kMessage,    ///< `id()` and `name()` of the next message.
  kField,      ///< `name()` and `type_code()` of the next field of that message.
  kEnd,        ///< The description is over.
  kMalformed,  ///< It is none: cut short, a name with other characters than letters, digits and
               ///< underscores, a reference to nothing, .. There will be nothing else.
};

/// Reads a description of a schema, of this program or of another, item by item. The bytes are only
/// borrowed, may come from anywhere, and are read nowhere beyond `size`.
class SchemaReader {
 public:
  SchemaReader(const uint8_t* bytes, uint16_t size) : bytes_(bytes), size_(size) {}
  SchemaReader(const SchemaReader&) = delete;
  SchemaReader& operator=(const SchemaReader&) = delete;

  SchemaItem next();
  uint8_t id() const { return id_; }
  /// Ends with a zero; valid until the next call.
  const char* name() const { return name_; }
  char type_code() const { return type_code_; }

 private:
  /// A name with its end.
  using Name = char[SchemaFormat::kMaxName + 1];

  SchemaItem take_message(uint8_t head);
  SchemaItem take_definition(uint8_t head);
  SchemaItem take_reference(uint8_t number);
  void skip_references();
  SchemaItem malformed();
  /// The next byte; 0 beyond the end, which no name takes.
  uint8_t take_byte() { return at_ < size_ ? bytes_[at_++] : uint8_t{0}; }
  bool take_name(uint8_t head, Name& name);

  const uint8_t* bytes_;
  uint16_t size_;
  uint16_t at_ = 0;
  uint8_t definitions_ = 0;
  uint8_t id_ = 0;
  bool has_message_ = false;
  char type_code_ = '\0';
  const char* name_ = "";
  Name message_name_ = {};
  Name field_name_ = {};
  Name referred_name_ = {};
};

}  // namespace protocol
}  // namespace echomap
