// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/datasets/log_reader.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::tests {

/// Reads texts as logs of one format.
class LogTest : public ::testing::Test {
 protected:
  using Open = std::unique_ptr<datasets::LogReader> (*)(const std::filesystem::path& path);

  LogTest(std::string file, Open open) : path_(folder_ / file), open_(open) {}

  /// A file beside the log.
  void put(const std::string& file, const std::string& text) {
    files::write_text_file(folder_ / file, text);
  }
  std::vector<datasets::LogRecord> read(const std::string& text) {
    files::write_text_file(path_, text);
    return records_of(*open_(path_));
  }
  std::string error_of(const std::string& text) {
    return thrown_text<files::FileError>([&] { read(text); });
  }

  ScratchFolder folder_;
  std::filesystem::path path_;

 private:
  Open open_;
};

/// `text`, `times` over.
inline std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) {
    all += text;
  }
  return all;
}

}  // namespace echomap::tests
