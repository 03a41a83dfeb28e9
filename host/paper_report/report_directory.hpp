// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/paper_report/paper_report.hpp"
#include "host/paper_report/source_lines.hpp"

namespace echomap::paper_report {

/// Writes report.html, report.json and each picture as a PNG file into `folder`, which is made
/// where it is missing. The page is written last and needs none of the other files. Each file is
/// whole or absent; files of other names stay. Throws files::FileError.
void write_report(const std::filesystem::path& folder,
                  const PaperReport& report,
                  const SourceLines& source_lines);

}  // namespace echomap::paper_report
