// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/message_schema.hpp"

namespace echomap {
namespace protocol {

/// What BulkRead reads.
enum class BulkContent : uint8_t {
  kSchema = 0,         ///< Messages, fields and types that the firmware was built with.
  kConfiguration = 1,  ///< The configuration that now holds.
};

/// Host to robot: asks for 32 bytes of a longer content. Changes nothing, so it may be repeated.
/// Hello, HelloReply, BulkRead and BulkData never change, so that any host can ask any firmware.
struct BulkRead {
  enum : uint8_t { kId = 0x30 };
  static constexpr MessageClass message_class() { return MessageClass::kBulk; }
  static constexpr const char* name() { return "BulkRead"; }
  uint8_t content;  ///< A BulkContent.
  uint16_t offset;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("content", m.content);
    v("offset", m.offset);
  }
};

/// Bytes of the content in one BulkData: those of its words, one after the other.
constexpr uint8_t kBulkBytes = 32;

/// Robot to host: the bytes from `offset` on, zero beyond `total`.
struct BulkData {
  enum : uint8_t { kId = 0x31 };
  static constexpr MessageClass message_class() { return MessageClass::kBulk; }
  static constexpr const char* name() { return "BulkData"; }
  uint8_t content;
  uint16_t offset;
  uint16_t total;  ///< Bytes of the whole content; 0 for one that this firmware does not have.
  uint32_t word_0;
  uint32_t word_1;
  uint32_t word_2;
  uint32_t word_3;
  uint32_t word_4;
  uint32_t word_5;
  uint32_t word_6;
  uint32_t word_7;

  template <class M, class V>
  static constexpr void each(M& m, V& v) {
    v("content", m.content);
    v("offset", m.offset);
    v("total", m.total);
    v("word_0", m.word_0);
    v("word_1", m.word_1);
    v("word_2", m.word_2);
    v("word_3", m.word_3);
    v("word_4", m.word_4);
    v("word_5", m.word_5);
    v("word_6", m.word_6);
    v("word_7", m.word_7);
  }
};

}  // namespace protocol
}  // namespace echomap
