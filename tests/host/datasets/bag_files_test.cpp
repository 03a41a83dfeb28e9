// SPDX-License-Identifier: MIT
#include "host/datasets/bag_files.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/datasets/line_reader.hpp"
#include "host/files/atomic_file.hpp"
#include "host/ros_messages/std_msgs.hpp"
#include "tests/support/bag_writer.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class BagFilesTest : public testing::Test {
 protected:
  /// A file with one text in a chunk for each.
  void write(const std::string& file, const std::vector<std::string>& texts) {
    tests::BagWriter bag(folder_ / file);
    for (const std::string& text : texts) {
      bag.write("/chat", ros_messages::String{text}, 1.0);
      bag.flush();
    }
    bag.finish();
  }
  /// The same as a recorder leaves it that is killed while it writes the last one.
  void write_cut_off(const std::string& file, const std::vector<std::string>& texts) {
    tests::BagWriter bag(folder_ / "whole");
    for (const std::string& text : texts) {
      std::filesystem::copy_file(
          folder_ / "whole", folder_ / file, std::filesystem::copy_options::overwrite_existing);
      bag.write("/chat", ros_messages::String{text}, 1.0);
      bag.flush();
    }
    const auto before = std::filesystem::file_size(folder_ / file);
    std::filesystem::copy_file(
        folder_ / "whole", folder_ / file, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(folder_ / file, before + 30);
  }
  /// Appends what it reads, so that it is there after an error.
  static void read(BagFiles& files, std::vector<std::string>& texts) {
    while (const auto message = files.next()) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      texts.push_back(ros_messages::deserialize<ros_messages::String>(message->data).data);
    }
  }

  tests::ScratchFolder folder_;
  std::vector<std::string> texts_;
};

TEST_F(BagFilesTest, AreOneFile) {
  write("a.mcap", {"one", "two"});
  BagFiles files(folder_ / "a.mcap");
  read(files, texts_);
  EXPECT_THAT(texts_, ElementsAre("one", "two"));
  EXPECT_EQ(files.progress(), 1.0);
}

TEST_F(BagFilesTest, AreThoseOfAFolderInTheOrderOfTheirNumbers) {
  write("drive_10.mcap", {"three"});
  write("drive_2.mcap", {"two"});
  write("drive_0.mcap", {"one"});
  files::write_text_file(folder_ / "notes.txt", "not of the bag");
  BagFiles files(folder_.path());
  EXPECT_LT(files.progress(), 0.4);
  read(files, texts_);
  EXPECT_THAT(texts_, ElementsAre("one", "two", "three"));
  EXPECT_EQ(files.progress(), 1.0);
}

TEST_F(BagFilesTest, AFolderIsABagByItsMetadata) {
  write("drive_0.mcap", {});
  EXPECT_FALSE(is_bag_folder(folder_.path()));
  files::write_text_file(folder_ / "metadata.yaml", "rosbag2_bagfile_information:\n");
  EXPECT_TRUE(is_bag_folder(folder_.path()));
  std::filesystem::remove(folder_ / "drive_0.mcap");
  EXPECT_FALSE(is_bag_folder(folder_.path()));
  EXPECT_FALSE(is_bag_folder(folder_ / "none"));
}

TEST_F(BagFilesTest, ReadsOnBehindAFileThatIsCutOffAndThenSaysSo) {
  write_cut_off("drive_0.mcap", {"one", "lost"});
  write("drive_1.mcap", {"two"});
  BagFiles files(folder_.path());
  EXPECT_THROW(read(files, texts_), CutOffLine);
  EXPECT_THAT(texts_, ElementsAre("one", "two"));
  EXPECT_THAT(tests::thrown_text<CutOffLine>([&] { files.next(); }), HasSubstr("drive_0.mcap"));
}

TEST_F(BagFilesTest, AFileThatIsNoBagIsAnError) {
  files::write_text_file(folder_ / "a.mcap", "text\n");
  EXPECT_THROW(BagFiles(folder_ / "a.mcap"), files::FileError);
  EXPECT_THROW(BagFiles(folder_ / "none.mcap"), files::FileError);
  std::filesystem::create_directory(folder_ / "empty");
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { BagFiles(folder_ / "empty"); }),
              HasSubstr("empty: the folder has no file NAME.mcap"));
}

}  // namespace
}  // namespace echomap::datasets
