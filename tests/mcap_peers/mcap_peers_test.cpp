// SPDX-License-Identifier: MIT
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/mcap/mcap_reader.hpp"
#include "host/mcap/mcap_writer.hpp"
#include "host/mcap/record_writer.hpp"
#include "tests/structure/shell.hpp"
#include "tests/support/scratch_folder.hpp"

// Readers of MCAP and of ROS 2 messages that others wrote (validate.mjs) read what we write, and we
// read what a writer by others writes (write.mjs).
namespace echomap::mcap {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using structure::shell_quoted;
using testing::HasSubstr;

/// CDR, little-endian, of a std_msgs/msg/String: four bytes of encoding, the length with the
/// closing zero, the text, the zero.
Bytes string_cdr(std::string_view text) {
  Bytes cdr{0, 1, 0, 0};
  append_number(cdr, static_cast<std::uint32_t>(text.size() + 1));
  cdr.insert(cdr.end(), text.begin(), text.end());
  cdr.push_back(0);
  return cdr;
}

/// A file, and scripts that need the npm packages.
class McapPeersTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(ECHOMAP_MCAP_PEERS "/installed")) {
      GTEST_SKIP() << "no node 20, no npm, or its packages could not be installed";
    }
  }
  /// Runs the script on the file.
  structure::ShellResult run_script(const std::string& name, const std::string& option = "") const {
    return structure::run_shell("node " + shell_quoted(ECHOMAP_MCAP_PEERS "/" + name) + " " +
                                    shell_quoted(path()) + " " + option,
                                path().parent_path());
  }
  fs::path path() const { return folder_ / "run.mcap"; }

 private:
  tests::ScratchFolder folder_;
};

class McapPeers : public McapPeersTest, public testing::WithParamInterface<Compression> {
 protected:
  /// Ten messages in several chunks, an attachment and metadata.
  void write_file() const {
    McapWriterParams params;
    params.chunk_bytes = 200;
    params.compression = GetParam();
    McapWriter writer({"ros2", "echomap"}, params);
    writer.open(path());
    writer.add_metadata({"session", {{"seed", "7"}}});
    const std::uint16_t schema =
        writer.add_schema({"std_msgs/msg/String", "ros2msg", "string data\n"});
    const std::uint16_t log = writer.add_channel({"/log", schema, "cdr", {}});
    const std::uint16_t note = writer.add_channel({"/note", 0, "text", {}});
    writer.add_channel({"/never_used", schema, "cdr", {}});
    for (std::uint64_t i = 0; i < 10; ++i) {
      // Not in order of time: the two readers then have different orders.
      const std::uint64_t log_time_ns = 1'700'000'000'000'000'000 + 10 * (i ^ 1U);
      writer.write(log, log_time_ns, log_time_ns, string_cdr("line " + std::to_string(i)));
    }
    writer.write(note, 1'700'000'000'000'000'007, 0, Bytes{1, 2, 3});
    writer.attach({1, 2, "config.toml", "text/plain", {'a', ' ', '=', ' ', '1'}});
    writer.finish();
  }
};

TEST_P(McapPeers, ReadWhatWeWrite) {
  write_file();
  const structure::ShellResult result = run_script("validate.mjs");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const json report = json::parse(result.output);
  EXPECT_EQ(report.at("messages"), 11);
  const json& log = report.at("channels").at("/log");
  EXPECT_EQ(log.at("schema"), "std_msgs/msg/String");
  EXPECT_EQ(log.at("messages"), 10);
  EXPECT_EQ(log.at("first"), json({{"data", "line 1"}}));
  EXPECT_EQ(report.at("channels").at("/note").at("first"), nullptr);
  EXPECT_EQ(report.at("channels").at("/never_used").at("messages"), 0);
  EXPECT_EQ(report.at("attachments"), json({"config.toml"}));
  EXPECT_EQ(report.at("metadata"), json({"session"}));
  EXPECT_EQ(report.at("indexed_equals_streamed"), true);
}

TEST_P(McapPeers, NoticeAWrongBit) {
  write_file();
  std::fstream file(path(), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(fs::file_size(path()) / 4));
  file.put('\x55');
  file.close();
  const structure::ShellResult result = run_script("validate.mjs");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("run.mcap: "));
}

/// What a file holds, in one text.
std::string text_of_file(const fs::path& path) {
  McapReader reader(path);
  std::string text = reader.header().library + ":";
  while (const auto record = reader.next()) {
    if (const auto* message = std::get_if<Message>(&*record)) {
      text += " " + message->channel->info.topic + " " + message->channel->schema->name + " " +
              std::to_string(message->sequence) + " " + std::to_string(message->log_time_ns) + " " +
              std::string(message->data.begin(), message->data.end());
    } else if (const auto* attachment = std::get_if<Attachment>(&*record)) {
      text += " " + attachment->name + " " +
              std::string(attachment->data.begin(), attachment->data.end());
    } else {
      text += " " + std::get<Metadata>(*record).entries.at("seed");
    }
  }
  return text;
}

TEST_F(McapPeersTest, AreReadByUs) {
  std::string expected = "a peer: config.toml a = 1 7";
  for (int i = 0; i < 20; ++i) {
    const std::string number = std::to_string(i);
    expected +=
        " /log std_msgs/msg/String " + number + " " + std::to_string(1000 * i) + " line " + number;
  }
  for (const std::string form : {"chunked", "loose"}) {
    const structure::ShellResult result = run_script("write.mjs", form);
    ASSERT_EQ(result.exit_code, 0) << result.output;
    EXPECT_EQ(text_of_file(path()), expected) << form;
  }
}

INSTANTIATE_TEST_SUITE_P(Compressions,
                         McapPeers,
                         testing::Values(Compression::kNone, Compression::kZstd, Compression::kLz4),
                         [](const auto& param) {
                           const std::string name = name_of(param.param);
                           return name.empty() ? "none" : name;
                         });

}  // namespace
}  // namespace echomap::mcap
