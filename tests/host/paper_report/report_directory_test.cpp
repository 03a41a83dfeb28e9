// SPDX-License-Identifier: MIT
#include "host/paper_report/report_directory.hpp"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/paper_report/report_html.hpp"
#include "host/paper_report/report_json.hpp"
#include "tests/host/paper_report/sample_report.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::paper_report {
namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename());
  }
  return names;
}

TEST(WriteReport, WritesPageNumbersAndPictures) {
  const tests::ScratchFolder scratch;
  const std::filesystem::path folder = scratch / "papers" / "000";
  const SourceLines source_lines(ECHOMAP_SOURCE_DIR);
  write_report(folder, sample_report(), source_lines);
  EXPECT_THAT(names_in(folder),
              testing::ElementsAre("01_particles_after_5_steps.png",
                                   "02_a_scan_of_the_room.png",
                                   "report.html",
                                   "report.json"));
  EXPECT_EQ(files::read_text_file(folder / "report.html"), html_of(sample_report(), source_lines));
  EXPECT_EQ(files::read_text_file(folder / "report.json"),
            report_json(sample_report(), source_lines));
  const auto png = sample_report().experiments[0].pictures[0].png;
  EXPECT_EQ(files::read_text_file(folder / "01_particles_after_5_steps.png"),
            std::string(png.begin(), png.end()));
}

TEST(WriteReport, ReplacesAnOlderOne) {
  const tests::ScratchFolder scratch;
  const SourceLines source_lines(ECHOMAP_SOURCE_DIR);
  write_report(scratch.path(), sample_report(), source_lines);
  PaperReport report = sample_report();
  report.seed = 8;
  write_report(scratch.path(), report, source_lines);
  EXPECT_EQ(files::read_text_file(scratch / "report.html"), html_of(report, source_lines));
}

TEST(WriteReport, NamesAFolderThatCannotBeMade) {
  const tests::ScratchFolder scratch;
  files::write_text_file(scratch / "file", "");
  try {
    write_report(scratch / "file", sample_report(), SourceLines(ECHOMAP_SOURCE_DIR));
    FAIL() << "no error";
  } catch (const files::FileError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr((scratch / "file").string()));
  }
}

}  // namespace
}  // namespace echomap::paper_report
