// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/fleet_messages/payload.hpp"

// docs/fleet_protocol.md against the code.
namespace echomap::fleet_messages {
namespace {

/// Lines of the document that begin like that.
std::vector<std::string> document_lines(const std::string& begin) {
  std::ifstream file(ECHOMAP_SOURCE_DIR "/docs/fleet_protocol.md");
  if (!file) {
    throw std::runtime_error("cannot read docs/fleet_protocol.md");
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(begin, 0) == 0) {
      lines.push_back(line);
    }
  }
  return lines;
}

template <class T>
std::string integer_name() {
  return (std::is_signed_v<T> ? "i" : "u") + std::to_string(8 * sizeof(T));
}

/// Prints the fields of a message or a row, and adds up the bytes of the shortest message.
class FieldsPrinter {
 public:
  template <std::integral T>
  void operator()(std::string_view name, const T& /*value*/, std::uint64_t max = kAnyValue<T>) {
    const bool has_limit = max != kAnyValue<T> && max < 1000;
    print(name, integer_name<T>() + (has_limit ? " <= " + std::to_string(max) : ""));
    bytes_ += sizeof(T);
  }
  void operator()(std::string_view name, const std::string& /*text*/) {
    print(name, "name");
    bytes_ += 2;
  }
  void operator()(std::string_view name, const ContentHash& /*hash*/) {
    print(name, "hash");
    bytes_ += sizeof(ContentHash);
  }
  void operator()(std::string_view name, const std::vector<ContentHash>& /*hashes*/) {
    print(name, "hash[]");
    bytes_ += 2;
  }
  template <TableRow Row>
  void operator()(std::string_view name, const std::vector<Row>& /*rows*/) {
    print(name, "table (" + fields_of<Row>() + ")");
    bytes_ += 2;
  }
  template <MessagePart Part>
  void operator()(std::string_view /*name*/, const Part& part) {
    Part::fields(part, *this);
  }
  template <MessagePart Part>
  void operator()(std::string_view name, const std::vector<Part>& /*parts*/) {
    print(name, "list (" + fields_of<Part>() + ")");
    bytes_ += 2;
  }

  template <class M>
  static std::string fields_of() {
    FieldsPrinter printer;
    const M message{};
    M::fields(message, printer);
    return printer.text_;
  }
  const std::string& text() const { return text_; }
  std::size_t bytes() const { return bytes_; }

 private:
  void print(std::string_view name, const std::string& type) {
    text_ += (text_.empty() ? "" : ", ") + std::string(name) + " " + type;
  }

  std::string text_;
  std::size_t bytes_ = 0;
};

template <std::size_t kIndex = 0>
void print_messages(std::vector<std::string>& rows) {
  if constexpr (kIndex < std::variant_size_v<MessageBody>) {
    const std::variant_alternative_t<kIndex, MessageBody> message{};
    FieldsPrinter printer;
    decltype(message)::fields(message, printer);
    std::ostringstream row;
    row << "| " << kIndex + 1 << " | `" << name_of(message.kKind) << "` | " << printer.bytes()
        << " | " << printer.text() << " |";
    rows.push_back(row.str());
    print_messages<kIndex + 1>(rows);
  }
}

TEST(FleetProtocolDocument, ListsEveryMessageAsTheCodeHasIt) {
  std::vector<std::string> rows;
  print_messages(rows);
  std::vector<std::string> documented;
  for (std::size_t kind = 1; kind <= rows.size() + 1; ++kind) {
    for (const std::string& line : document_lines("| " + std::to_string(kind) + " | `")) {
      documented.push_back(line);
    }
  }
  EXPECT_EQ(documented, rows);
}

std::string example_topic(TopicKind kind) {
  for (const TopicId& id : {TopicId(), TopicId(std::uint16_t{0}), TopicId(ContentHash())}) {
    const std::string text = format_topic({"f", "r", kind, id});
    if (parse_topic(text)) {
      return text;
    }
  }
  return "";
}

TEST(FleetProtocolDocument, SaysWhatIsRetained) {
  for (const TopicKind kind : kTopicKinds) {
    const std::string example = example_topic(kind);
    const bool has_hash = example.size() > 40;
    const bool has_id = example.back() == '0';
    const std::string id = !has_id ? "" : has_hash ? "/HASH" : "/N";
    const std::string begin = "| `" + std::string(name_of(kind)) + id + "` | " +
                              (kind == TopicKind::kPose ? "0" : "1") + " | " +
                              (is_retained(kind) ? "yes" : "no") + " |";
    EXPECT_EQ(document_lines(begin).size(), 1U) << begin;
  }
}

TEST(FleetProtocolDocument, ListsWhyAMessageIsRefused) {
  for (std::size_t reason = 0; reason < kRefusedReasons; ++reason) {
    const auto name = std::string(name_of(static_cast<RefusedReason>(reason)));
    EXPECT_EQ(document_lines("| `" + name + "` |").size(), 1U) << name;
  }
}

TEST(FleetProtocolDocument, NamesTheLimits) {
  EXPECT_EQ(document_lines("Schema version " + std::to_string(kSchemaVersion) + ".").size(), 1U);
  EXPECT_EQ(document_lines("| payload | " + std::to_string(kMaxPayloadBytes) + " bytes |").size(),
            1U);
  EXPECT_EQ(
      document_lines("| unpacked body | " + std::to_string(kMaxBodyBytes) + " bytes |").size(), 1U);
  EXPECT_EQ(document_lines("| rows of a table, elements of a list | " +
                           std::to_string(kMaxElements) + " |")
                .size(),
            1U);
  EXPECT_EQ(document_lines("| objects of a manifest's page | " +
                           std::to_string(ManifestMessage::kObjectsPerPage) + " |")
                .size(),
            1U);
}

}  // namespace
}  // namespace echomap::fleet_messages
