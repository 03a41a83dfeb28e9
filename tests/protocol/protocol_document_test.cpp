// SPDX-License-Identifier: MIT
#include <fstream>
#include <iomanip>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/messages.hpp"
#include "protocol/schema_description.hpp"
#include "tests/support/message_description.hpp"

// docs/protocol.md against the code: the table of messages and the worked example.
namespace echomap::protocol {
namespace {

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(std::string(ECHOMAP_SOURCE_DIR "/") + path);
  if (!file) {
    throw std::runtime_error("cannot read " + path);
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string class_name(MessageClass message_class) {
  const std::map<MessageClass, std::string> names{{MessageClass::kHandshake, "handshake"},
                                                  {MessageClass::kTelemetry, "telemetry"},
                                                  {MessageClass::kSetpoint, "setpoint"},
                                                  {MessageClass::kCommand, "command"},
                                                  {MessageClass::kBulk, "bulk"}};
  return names.at(message_class);
}

struct FieldPrinter {
  std::ostringstream text;
  void operator()(const char* name, char type_code) {
    const std::map<char, std::string> types{
        {'B', "u8"}, {'b', "i8"}, {'H', "u16"}, {'h', "i16"}, {'I', "u32"}, {'i', "i32"}};
    text << (text.tellp() > 0 ? ", " : "") << name << ' ' << types.at(type_code);
  }
};

/// Prints the rows of the table in docs/protocol.md.
struct TablePrinter {
  std::vector<std::string> rows;
  template <class M>
  void operator()(const M* /*tag*/) {
    const bool to_robot = MessagesToRobot::find_schema(M::kId).known();
    FieldPrinter fields;
    describe<M>(fields);
    std::ostringstream row;
    row << "| 0x" << std::hex << std::setw(2) << std::setfill('0') << int{M::kId} << std::dec
        << " | `" << M::name() << "` | " << class_name(M::message_class()) << " | "
        << (to_robot ? "robot" : "host") << " | " << int{MessageFacts<M>::kSize} << " | "
        << fields.text.str() << " |";
    rows.push_back(row.str());
  }
};

TEST(ProtocolDocument, ListsEveryMessageAsTheCodeDescribesIt) {
  std::vector<std::string> documented;
  for (const std::string& line : lines_of("docs/protocol.md")) {
    if (line.rfind("| 0x", 0) == 0) {
      documented.push_back(line);
    }
  }
  TablePrinter printer;
  AllMessages::for_each(printer);
  EXPECT_EQ(documented, printer.rows);
}

/// The first cells of the worked example's table: | `29` | seq | ..
std::string bytes_of_the_example() {
  const std::regex row("\\| `([0-9A-F]{2}(?: [0-9A-F]{2})*)` \\|.*");
  std::string bytes;
  for (const std::string& line : lines_of("docs/protocol.md")) {
    std::smatch match;
    if (std::regex_match(line, match, row)) {
      bytes += (bytes.empty() ? "" : " ") + match[1].str();
    }
  }
  return bytes;
}

TEST(ProtocolDocument, TakesItsWorkedExampleFromTheVectorsByteByByte) {
  std::string example;
  for (const std::string& line : lines_of("docs/protocol.md")) {
    if (line.rfind("frame ", 0) == 0) {
      example = line;
    }
  }
  ASSERT_THAT(lines_of("protocol/vectors/frames.txt"), testing::Contains(example));
  EXPECT_EQ(bytes_of_the_example(), example.substr(example.find('>') + 2));
}

TEST(ProtocolDocument, ShowsHowTheDescriptionBeginsAndItsLength) {
  constexpr auto kSchema = describe_schema<AllMessages>();
  std::ostringstream begin;
  begin << "schema" << std::hex << std::uppercase << std::setfill('0');
  for (std::size_t i = 0; i < 27; ++i) {
    begin << ' ' << std::setw(2) << int{kSchema.bytes[i]};
  }
  std::string length = std::to_string(sizeof(kSchema.bytes)) + " bytes of the schema";
  length.insert(1, ",");
  const std::vector<std::string> lines = lines_of("docs/protocol.md");
  EXPECT_THAT(lines, testing::Contains(begin.str()));
  EXPECT_THAT(lines, testing::Contains(testing::HasSubstr(length)));
}

TEST(ProtocolDocument, NamesTheSchemaDigest) {
  std::ostringstream digest;
  digest << "0x" << std::hex << std::uppercase << std::setw(8) << std::setfill('0')
         << kSchemaDigest;
  EXPECT_THAT(lines_of("docs/protocol.md"), testing::Contains(testing::HasSubstr(digest.str())));
}

}  // namespace
}  // namespace echomap::protocol
