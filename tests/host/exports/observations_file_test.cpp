// SPDX-License-Identifier: MIT
#include "host/exports/observations_file.hpp"

#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "host/exports/observations_csv.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

class ObservationsFileTest : public ::testing::Test {
 protected:
  void drive(pipeline::ObservationLog& log) {
    travel_m += 0.25;
    stamp += std::chrono::milliseconds(20);
    log.on_odometry({stamp, {travel_m, travel_m}});
  }
  void stop() {
    record.begin_scan();
    drive(record);
    record.end_scan();
  }
  std::string text() const { return files::read_text_file(path); }
  /// As it is written whole.
  std::string whole_text() const {
    ObservationRecorder recorder;
    record.replay(recorder);
    recorder.save(scratch / "whole");
    return files::read_text_file(scratch / "whole");
  }
  /// Another one where the file was written anew.
  ino_t file_number() const {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_ino;
  }

  const tests::ScratchFolder scratch;
  const std::filesystem::path path = scratch / "observations.csv";
  pipeline::ObservationLog record;
  double travel_m = 0.0;
  time::RobotTime stamp;
  ObservationsFile file{path};
};

TEST_F(ObservationsFileTest, GrowsByWhatTheRecordHasGot) {
  file.save(record, true);
  EXPECT_EQ(text(), "kind,stamp_us,values\n");
  const ino_t number = file_number();
  for (int i = 0; i < 3; ++i) {
    stop();
    file.save(record, true);
    EXPECT_EQ(text(), whole_text()) << i;
    file.save(record, true);
    EXPECT_EQ(text(), whole_text()) << i << ": nothing new";
  }
  EXPECT_EQ(file_number(), number) << "it was not written anew";
}

TEST_F(ObservationsFileTest, IsWrittenAnewOfAnotherRecord) {
  stop();
  stop();
  file.save(record, true);
  record = {};
  drive(record);
  file.save(record, false);
  EXPECT_EQ(text(), whole_text());
  stop();
  file.save(record, true);
  EXPECT_EQ(text(), whole_text());
}

TEST_F(ObservationsFileTest, IsWrittenAnewWhereItIsNotAsItWasLeft) {
  files::write_text_file(path, "of somebody else");
  stop();
  file.save(record, true);
  EXPECT_EQ(text(), whole_text());
  files::write_text_file(path, text() + "odometry,1");
  stop();
  file.save(record, true);
  EXPECT_EQ(text(), whole_text()) << "a disk was full when it was added to";
  std::filesystem::remove(path);
  stop();
  file.save(record, true);
  EXPECT_EQ(text(), whole_text());
}

TEST_F(ObservationsFileTest, CanBeReadWhereverItsWriterWasKilled) {
  stop();
  file.save(record, true);
  const std::string before = text();
  drive(record);
  stop();
  file.save(record, true);
  const std::string after = text();
  for (std::size_t bytes = before.size(); bytes <= after.size(); ++bytes) {
    const std::string killed = after.substr(0, bytes);
    files::write_text_file(scratch / "killed", killed);
    ObservationRecorder read;
    const bool is_cut_off = replay_observations_csv(scratch / "killed", read);
    EXPECT_EQ(is_cut_off, !killed.ends_with('\n')) << killed;
    read.save(scratch / "read");
    EXPECT_EQ(files::read_text_file(scratch / "read"), killed.substr(0, killed.rfind('\n') + 1));
  }
}

}  // namespace
}  // namespace echomap::exports
