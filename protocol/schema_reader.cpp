// SPDX-License-Identifier: MIT
#include "protocol/schema_reader.hpp"

#include <string.h>

namespace echomap {
namespace protocol {
namespace {

bool in_name(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
         (character >= '0' && character <= '9') || character == '_';
}

}  // namespace

SchemaItem SchemaReader::next() {
  if (at_ == size_) {
    return SchemaItem::kEnd;
  }
  if (size_ > SchemaFormat::kMaxBytes) {
    return malformed();
  }
  const uint8_t head = take_byte();
  if ((head & SchemaFormat::kReference) != 0) {
    return take_reference(static_cast<uint8_t>(head & ~SchemaFormat::kReference));
  }
  return (head & SchemaFormat::kTypeBits) == 0 ? take_message(head) : take_definition(head);
}

SchemaItem SchemaReader::take_message(uint8_t head) {
  id_ = take_byte();
  if (!take_name(head, message_name_)) {
    return malformed();
  }
  name_ = message_name_;
  has_message_ = true;
  return SchemaItem::kMessage;
}

SchemaItem SchemaReader::take_definition(uint8_t head) {
  const uint8_t type = static_cast<uint8_t>((head & SchemaFormat::kTypeBits) - 1);
  type_code_ = SchemaFormat::type_code(type);
  const bool allowed =
      has_message_ && type_code_ != '\0' && definitions_ != SchemaFormat::kMaxDefinitions;
  if (!allowed || !take_name(head, field_name_)) {
    return malformed();
  }
  name_ = field_name_;
  ++definitions_;
  return SchemaItem::kField;
}

/// Reads again up to the definition: slower than to remember them all, but it takes no memory.
SchemaItem SchemaReader::take_reference(uint8_t number) {
  if (!has_message_ || number >= definitions_) {
    return malformed();
  }
  SchemaReader again(bytes_, at_);
  while (again.definitions_ <= number) {
    again.skip_references();
    again.next();
  }
  memcpy(referred_name_, again.field_name_, sizeof(referred_name_));
  name_ = referred_name_;
  type_code_ = again.type_code_;
  return SchemaItem::kField;
}

void SchemaReader::skip_references() {
  while ((bytes_[at_] & SchemaFormat::kReference) != 0) {
    ++at_;
  }
}

SchemaItem SchemaReader::malformed() {
  at_ = 0;
  size_ = UINT16_MAX;
  return SchemaItem::kMalformed;
}

bool SchemaReader::take_name(uint8_t head, Name& name) {
  uint8_t length = static_cast<uint8_t>(head >> SchemaFormat::kSharedShift);
  bool ends = false;
  if (length > strlen(name)) {
    return false;
  }
  while (!ends && length < SchemaFormat::kMaxName) {
    const uint8_t byte = take_byte();
    ends = (byte & SchemaFormat::kLastCharacter) != 0;
    name[length] = static_cast<char>(byte & ~SchemaFormat::kLastCharacter);
    if (!in_name(name[length])) {
      return false;
    }
    ++length;
  }
  name[length] = '\0';
  return ends;
}

}  // namespace protocol
}  // namespace echomap
