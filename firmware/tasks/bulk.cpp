// SPDX-License-Identifier: MIT
#include "firmware/tasks/bulk.hpp"

#include <string.h>

#include "firmware/hal/flash_table.hpp"
#include "protocol/messages.hpp"
#include "protocol/schema_description.hpp"

namespace echomap {
namespace tasks {
namespace {

using protocol::BulkContent;
using protocol::BulkData;

constexpr auto kSchema ECHOMAP_FLASH = protocol::describe_schema<protocol::AllMessages>();

/// A BulkData as it goes over the wire, made of bytes because its content is.
class Answer {
 public:
  explicit Answer(const protocol::BulkRead& read) : offset_(read.offset) {
    payload_[0] = read.content;
    memcpy(payload_ + 1, &read.offset, sizeof(read.offset));
  }

  /// `byte(index)` is a byte of the content, which has `total` of them.
  template <class ByteAt>
  void fill(uint16_t total, ByteAt byte) {
    memcpy(payload_ + 3, &total, sizeof(total));
    for (uint8_t i = 0; i < protocol::kBulkBytes && offset_ < total; ++i) {
      payload_[kHeader + i] = byte(offset_++);
    }
  }

  const uint8_t* payload() const { return payload_; }

 private:
  enum : uint8_t {
    kSize = protocol::MessageFacts<BulkData>::kSize,
    kHeader = kSize - protocol::kBulkBytes,
  };

  uint8_t payload_[kSize] = {};
  uint16_t offset_;
};

}  // namespace

void Bulk::ask(const protocol::BulkRead& read) {
  if (waiting_ != kWindow) {
    asked_[waiting_++] = read;
  }
}

void Bulk::tick() {
  if (waiting_ != 0 && sender_.has_room_for<BulkData>()) {
    answer_oldest();
  }
}

void Bulk::answer_oldest() {
  const protocol::BulkRead read = asked_[0];
  --waiting_;
  memmove(asked_, asked_ + 1, sizeof(asked_) - sizeof(asked_[0]));
  Answer answer(read);
  if (read.content == static_cast<uint8_t>(BulkContent::kSchema)) {
    answer.fill(sizeof(kSchema.bytes),
                [](uint16_t at) { return hal::read_flash(kSchema.bytes + at); });
  } else if (read.content == static_cast<uint8_t>(BulkContent::kConfiguration)) {
    const protocol::ConfigurationBytes bytes = protocol::configuration_bytes(configuration_);
    answer.fill(sizeof(bytes.bytes), [&bytes](uint16_t at) { return bytes.bytes[at]; });
  }
  sender_.fill_in(protocol::get_payload<BulkData>(answer.payload()));
}

}  // namespace tasks
}  // namespace echomap
