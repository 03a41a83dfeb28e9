// SPDX-License-Identifier: MIT
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/mcap/mcap_writer.hpp"
#include "host/mcap/record_writer.hpp"
#include "tests/structure/shell.hpp"
#include "tests/support/scratch_folder.hpp"

// Readers of MCAP and of ROS 2 messages that others wrote (validate.mjs) read what we write.
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

class McapPeers : public testing::TestWithParam<Compression> {
 protected:
  void SetUp() override {
    if (!fs::exists(ECHOMAP_MCAP_PEERS "/installed")) {
      GTEST_SKIP() << "no node 20, no npm, or its packages could not be installed";
    }
  }
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
  structure::ShellResult validate() const {
    return structure::run_shell(
        "node " + shell_quoted(ECHOMAP_MCAP_PEERS "/validate.mjs") + " " + shell_quoted(path()),
        path().parent_path());
  }
  fs::path path() const { return folder_ / "run.mcap"; }

 private:
  tests::ScratchFolder folder_;
};

TEST_P(McapPeers, ReadWhatWeWrite) {
  write_file();
  const structure::ShellResult result = validate();
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
  const structure::ShellResult result = validate();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("run.mcap: "));
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
