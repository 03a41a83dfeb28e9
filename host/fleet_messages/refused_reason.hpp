// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace echomap::fleet_messages {

/// Why a message is refused.
enum class RefusedReason : std::uint8_t {
  kWrongTopic,        ///< The topic is not one of a fleet, or its kind is not the payload's.
  kTooLarge,          ///< The payload, or what it unpacks to, is longer than any may be.
  kTooShort,          ///< The payload is shorter than its header and checksum.
  kUnknownVersion,    ///< Another version of the schema.
  kUnknownKind,       ///< A kind that this version does not have.
  kDamaged,           ///< The checksum is not that of the bytes.
  kCannotDecompress,  ///< The body is not one whole zstd frame that states its size.
  kCutShort,          ///< The body ends within a field.
  kTrailingBytes,     ///< The body continues behind its last field.
  kMalformed,         ///< A count or a number has an invalid encoding.
  kOutOfRange,        ///< A number or a name is outside of its range.
  kWrongHash,         ///< The object's bytes have another hash than its topic.
  kForeignAuthor,     ///< The payload's author is not the robot whose topic it came on.
  kOldBoot,           ///< The author has started again since.
  kReplayed,          ///< A later message of the author was received before.
  kOverQuota,         ///< The author has made more than a robot may, or the fleet has no room.
};

/// Number of reasons.
inline constexpr std::size_t kRefusedReasons = 16;

/// Name of a reason in reports: "wrong_topic", "too_large" ..
constexpr std::string_view name_of(RefusedReason reason) {
  constexpr std::string_view kNames[kRefusedReasons] = {"wrong_topic",
                                                        "too_large",
                                                        "too_short",
                                                        "unknown_version",
                                                        "unknown_kind",
                                                        "damaged",
                                                        "cannot_decompress",
                                                        "cut_short",
                                                        "trailing_bytes",
                                                        "malformed",
                                                        "out_of_range",
                                                        "wrong_hash",
                                                        "foreign_author",
                                                        "old_boot",
                                                        "replayed",
                                                        "over_quota"};
  return kNames[static_cast<std::size_t>(reason)];
}

}  // namespace echomap::fleet_messages
