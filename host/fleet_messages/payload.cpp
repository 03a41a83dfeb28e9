// SPDX-License-Identifier: MIT
#include "host/fleet_messages/payload.hpp"

#include <type_traits>
#include <utility>

#include "host/fleet_messages/body_packing.hpp"
#include "host/fleet_messages/field_reader.hpp"
#include "host/fleet_messages/field_writer.hpp"

namespace echomap::fleet_messages {
namespace {

constexpr std::size_t kCheckBytes = 4;
/// Version, kind, packing, the author's name of one character, and the check.
constexpr std::size_t kMinPayloadBytes = 3 + 2 + kCheckBytes;

/// How a body is packed.
enum class BodyPacking : std::uint8_t { kNone = 0, kZstd = 1 };

/// A payload's first fields.
struct PayloadHeader {
  std::uint8_t version = kSchemaVersion;
  std::uint8_t kind = 0;
  std::uint8_t packing = 0;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("version", self.version);
    visit("kind", self.kind);
    visit("packing", self.packing, std::uint64_t{1});
  }
};

template <class S, class V>
void visit_sender(S& sender, bool is_of_object, V& visit) {
  visit("robot", sender.robot);
  if (!is_of_object) {
    visit("boot_id", sender.boot_id);
    visit("counter", sender.counter);
  }
}

/// Whether its fields go together, where its type has a rule for that.
template <class M>
bool is_consistent_message(const M& message) {
  if constexpr (requires { message.is_consistent(); }) {
    return message.is_consistent();
  }
  return true;
}

/// The first bytes of the hash.
std::string check_of(std::string_view bytes) {
  const ContentHash hash = content_hash(bytes);
  return {hash.bytes.begin(), hash.bytes.begin() + kCheckBytes};
}

/// Why the bytes are not a payload of this version, whatever their content.
std::optional<RefusedReason> refused_as_bytes(std::string_view payload) {
  if (payload.size() > kMaxPayloadBytes) {
    return RefusedReason::kTooLarge;
  }
  if (payload.size() < kMinPayloadBytes) {
    return RefusedReason::kTooShort;
  }
  if (static_cast<std::uint8_t>(payload.front()) != kSchemaVersion) {
    return RefusedReason::kUnknownVersion;
  }
  const std::size_t checked_bytes = payload.size() - kCheckBytes;
  const bool is_whole = check_of(payload.substr(0, checked_bytes)) == payload.substr(checked_bytes);
  return is_whole ? std::nullopt : std::optional(RefusedReason::kDamaged);
}

/// The body's bytes, unpacked; empty where a receiver would refuse it.
std::optional<std::string> fields_of(const MessageBody& body) {
  std::string bytes;
  FieldWriter writer(bytes);
  const bool is_consistent = std::visit(
      [&]<class M>(const M& message) {
        M::fields(message, writer);
        return is_consistent_message(message);
      },
      body);
  const bool is_accepted = writer.fits() && is_consistent && bytes.size() <= kMaxBodyBytes;
  return is_accepted ? std::optional(bytes) : std::nullopt;
}

/// A message of the kind's type without content; empty for a kind that there is not.
template <std::size_t kIndex = 0>
std::optional<MessageBody> body_of_kind(std::uint8_t kind) {
  if constexpr (kIndex < std::variant_size_v<MessageBody>) {
    if (kind == kIndex + 1) {
      return MessageBody(std::in_place_index<kIndex>);
    }
    return body_of_kind<kIndex + 1>(kind);
  } else {
    return std::nullopt;
  }
}

std::optional<RefusedReason> read_body(std::string_view bytes, MessageBody& body) {
  FieldReader reader(bytes);
  return std::visit(
      [&]<class M>(M& message) {
        M::fields(message, reader);
        auto refused = reader.finish();
        if (!refused && !is_consistent_message(message)) {
          refused = RefusedReason::kOutOfRange;
        }
        return refused;
      },
      body);
}

std::optional<RefusedReason> read_packed_body(std::string_view packed, MessageBody& body) {
  const auto fields = unpack(packed, kMaxBodyBytes);
  return fields ? read_body(*fields, body) : RefusedReason::kCannotDecompress;
}

/// The page or map number that a message's topic ends with.
TopicId id_of(const MessageBody& body) {
  if (const auto* manifest = std::get_if<ManifestMessage>(&body)) {
    return manifest->page;
  }
  if (const auto* graph = std::get_if<GraphMessage>(&body)) {
    return graph->map_number;
  }
  return {};
}

/// Why the payload does not belong on the topic; empty where it does.
std::optional<RefusedReason> misfit(const FleetTopic& topic,
                                    const FleetMessage& message,
                                    std::string_view payload) {
  const bool is_relayed = topic.kind == TopicKind::kRelay;
  if (!is_relayed && topic.kind != kind_of(message.body)) {
    return RefusedReason::kWrongTopic;
  }
  if (!is_relayed && topic.robot != message.sender.robot) {
    return RefusedReason::kForeignAuthor;
  }
  if (const auto* hash = std::get_if<ContentHash>(&topic.id)) {
    return *hash == content_hash(payload) ? std::nullopt : std::optional(RefusedReason::kWrongHash);
  }
  return topic.id == id_of(message.body) ? std::nullopt : std::optional(RefusedReason::kWrongTopic);
}

}  // namespace

TopicKind kind_of(const MessageBody& body) {
  return std::visit([]<class M>(const M& /*message*/) { return M::kKind; }, body);
}

std::optional<std::uint16_t> map_number_of(const MessageBody& body) {
  return std::visit(
      []<class M>(const M& message) -> std::optional<std::uint16_t> {
        if constexpr (requires { message.map_number; }) {
          return message.map_number;
        }
        return std::nullopt;
      },
      body);
}

std::optional<std::string> encode(const FleetMessage& message) {
  const auto fields = fields_of(message.body);
  if (!fields) {
    return std::nullopt;
  }
  const std::string packed = pack(*fields);
  const bool is_packed = packed.size() < fields->size();
  PayloadHeader header;
  header.kind = static_cast<std::uint8_t>(message.body.index() + 1);
  header.packing = static_cast<std::uint8_t>(is_packed ? BodyPacking::kZstd : BodyPacking::kNone);
  std::string payload;
  FieldWriter writer(payload);
  PayloadHeader::fields(std::as_const(header), writer);
  visit_sender(message.sender, is_object(kind_of(message.body)), writer);
  payload += is_packed ? packed : *fields;
  payload += check_of(payload);
  return writer.fits() && payload.size() <= kMaxPayloadBytes ? std::optional(payload)
                                                             : std::nullopt;
}

std::variant<FleetMessage, RefusedReason> decode(std::string_view payload) {
  if (const auto refused = refused_as_bytes(payload)) {
    return *refused;
  }
  FieldReader reader(payload.substr(0, payload.size() - kCheckBytes));
  PayloadHeader header;
  PayloadHeader::fields(header, reader);
  auto body = body_of_kind(header.kind);
  if (!body) {
    return RefusedReason::kUnknownKind;
  }
  FleetMessage message{{}, std::move(*body)};
  visit_sender(message.sender, is_object(kind_of(message.body)), reader);
  const std::string_view rest = reader.take_rest();
  if (const auto refused = reader.finish()) {
    return *refused;
  }
  const auto refused = header.packing == static_cast<std::uint8_t>(BodyPacking::kZstd)
                           ? read_packed_body(rest, message.body)
                           : read_body(rest, message.body);
  if (refused) {
    return *refused;
  }
  return message;
}

std::variant<TopicMessage, RefusedReason> decode(std::string_view topic, std::string_view payload) {
  auto parsed = parse_topic(topic);
  if (!parsed) {
    return RefusedReason::kWrongTopic;
  }
  auto decoded = decode(payload);
  if (const auto* refused = std::get_if<RefusedReason>(&decoded)) {
    return *refused;
  }
  auto& message = std::get<FleetMessage>(decoded);
  if (const auto refused = misfit(*parsed, message, payload)) {
    return *refused;
  }
  return TopicMessage{std::move(*parsed), std::move(message)};
}

FleetTopic topic_of(const std::string& fleet,
                    const FleetMessage& message,
                    std::string_view payload) {
  const TopicKind kind = kind_of(message.body);
  return {fleet,
          message.sender.robot,
          kind,
          is_object(kind) ? TopicId(content_hash(payload)) : id_of(message.body)};
}

}  // namespace echomap::fleet_messages
