// SPDX-License-Identifier: MIT
#include "host/live_page/run_files.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/host/live_page/served_page.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::live_page {
namespace {

namespace fs = std::filesystem;

std::string whole(BodySource& source) {
  std::string text;
  for (std::string part = source.next_part(); !part.empty(); part = source.next_part()) {
    text += part;
  }
  return text;
}

class RunFilesTest : public testing::Test {
 protected:
  RunFilesTest() {
    fs::create_directories(run_ / "folder");
    std::ofstream(run_ / "map.png") << "a picture";
    std::ofstream(run_ / "empty.csv") << "";
    std::ofstream(run_ / ".hidden") << "hidden";
    std::ofstream(run_ / "session.mcap.part") << "half";
    std::ofstream(scratch_ / "secret") << "a secret";
    fs::create_symlink(scratch_ / "secret", run_ / "link");
    fs::create_directory_symlink(scratch_.path(), run_ / "up");
    ::mkfifo((run_ / "pipe").c_str(), 0600);
  }

  const tests::ScratchFolder scratch_;
  const fs::path run_ = scratch_ / "run";
};

TEST_F(RunFilesTest, AreTheRegularOnesOfTheFolder) {
  const auto files = run_files(run_);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "empty.csv");
  EXPECT_EQ(files[1].name, "map.png");
  EXPECT_EQ(files[1].bytes, 9U);
  EXPECT_TRUE(run_files(scratch_ / "none").empty());
  EXPECT_TRUE(run_files({}).empty());
}

TEST_F(RunFilesTest, AreRead) {
  const auto source = open_run_file(run_, "map.png");
  ASSERT_NE(source, nullptr);
  EXPECT_EQ(source->size(), 9U);
  EXPECT_EQ(whole(*source), "a picture");
  EXPECT_EQ(whole(*open_run_file(run_, "empty.csv")), "");
}

TEST_F(RunFilesTest, OpenNothingElse) {
  const std::string with_zero("map.png\0x", 9);
  for (const std::string& name : {std::string(),
                                  std::string("."),
                                  std::string(".."),
                                  std::string(".hidden"),
                                  std::string("../secret"),
                                  std::string("..\\secret"),
                                  std::string("folder"),
                                  std::string("folder/../map.png"),
                                  std::string("/etc/passwd"),
                                  std::string("link"),
                                  std::string("up"),
                                  std::string("up/secret"),
                                  std::string("pipe"),
                                  std::string("session.mcap.part"),
                                  std::string("none"),
                                  with_zero,
                                  std::string(5000, 'x')}) {
    EXPECT_EQ(open_run_file(run_, name), nullptr) << name;
  }
  EXPECT_EQ(open_run_file({}, "secret"), nullptr);
}

TEST_F(RunFilesTest, EndWhereTheyEndedWhenTheyWereOpened) {
  const auto source = open_run_file(run_, "map.png");
  std::ofstream(run_ / "map.png", std::ios::app) << " that grows";
  EXPECT_EQ(whole(*source), "a picture");
}

TEST_F(RunFilesTest, ComeInPartsOfBoundedSize) {
  std::ofstream(run_ / "big") << std::string(200000, 'b');
  const auto source = open_run_file(run_, "big");
  EXPECT_EQ(source->next_part().size(), 65536U);
  EXPECT_EQ(whole(*source).size(), 200000U - 65536U);
}

TEST(MediaType, FollowsFromTheName) {
  EXPECT_EQ(media_type_of("map.png"), "image/png");
  EXPECT_EQ(media_type_of("summary.json"), "application/json");
  EXPECT_EQ(media_type_of("whatever"), "application/octet-stream");
}

TEST(HistoryBody, IsEachMessageBehindItsLength) {
  History history;
  std::string expected;
  for (int i = 0; i < 100; ++i) {
    const std::string text(static_cast<std::size_t>(i) * 50, 'e');
    history.add(made_message(MessageKind::kEvent, 0, text));
    const auto length = static_cast<std::uint32_t>(text.size());
    for (unsigned byte = 0; byte < sizeof length; ++byte) {
      expected.push_back(static_cast<char>(length >> (8 * byte) & 0xFFU));
    }
    expected += text;
  }
  const auto body = history_body(history);
  EXPECT_EQ(body->size(), expected.size());
  EXPECT_EQ(whole(*body), expected);
}

}  // namespace
}  // namespace echomap::live_page
