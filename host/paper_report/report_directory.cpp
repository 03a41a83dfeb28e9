// SPDX-License-Identifier: MIT
#include "host/paper_report/report_directory.hpp"

#include <span>
#include <system_error>

#include "host/files/atomic_file.hpp"
#include "host/paper_report/report_html.hpp"
#include "host/paper_report/report_json.hpp"

namespace echomap::paper_report {
namespace {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw files::FileError(folder.string() + ": cannot make the directory: " + error.message());
  }
}

void write_pictures(const std::filesystem::path& folder, const PaperReport& report) {
  int number = 0;
  for (const Experiment& experiment : report.experiments) {
    for (const PaperPicture& picture : experiment.pictures) {
      files::AtomicFile file(folder / picture_file_name(++number, picture.title));
      file.write(std::span<const unsigned char>(picture.png));
      file.commit();
    }
  }
}

}  // namespace

void write_report(const std::filesystem::path& folder,
                  const PaperReport& report,
                  const SourceLines& source_lines) {
  make_folder(folder);
  write_pictures(folder, report);
  files::write_text_file(folder / "report.json", report_json(report, source_lines));
  files::write_text_file(folder / "report.html", html_of(report, source_lines));
}

}  // namespace echomap::paper_report
