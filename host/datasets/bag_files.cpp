// SPDX-License-Identifier: MIT
#include "host/datasets/bag_files.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <variant>

#include "host/datasets/line_reader.hpp"
#include "host/files/atomic_file.hpp"
#include "host/mcap/record_file.hpp"

namespace echomap::datasets {
namespace {

/// The files that the folder's metadata.yaml lists: lines "- NAME" behind `relative_file_paths:`.
/// Empty where it lists none, or one that is not there.
std::vector<std::filesystem::path> listed_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::ifstream metadata(folder / "metadata.yaml");
  bool is_listing = false;
  for (std::string line; std::getline(metadata, line);) {
    const std::size_t begin = line.find_first_not_of(" \t");
    const std::string text = begin == std::string::npos ? "" : line.substr(begin);
    if (text.starts_with("relative_file_paths:")) {
      is_listing = true;
    } else if (is_listing && text.starts_with("- ")) {
      paths.push_back(folder / text.substr(2));
    } else {
      is_listing = false;
    }
  }
  const auto is_there = [](const auto& path) { return std::filesystem::is_regular_file(path); };
  return std::all_of(paths.begin(), paths.end(), is_there) ? paths
                                                           : std::vector<std::filesystem::path>();
}

/// The MCAP files of a folder that are listed or, where none are, all; bag_2 comes before bag_10.
std::vector<std::filesystem::path> mcap_files_in(const std::filesystem::path& folder) {
  if (auto listed = listed_files(folder); !listed.empty()) {
    return listed;
  }
  std::vector<std::filesystem::path> paths;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    if (entry.path().extension() == ".mcap") {
      paths.push_back(entry.path());
    }
  }
  const auto order = [](const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    return std::tuple(name.size(), name);
  };
  std::sort(paths.begin(), paths.end(), [&](const auto& left, const auto& right) {
    return order(left) < order(right);
  });
  return paths;
}

}  // namespace

bool is_bag_folder(const std::filesystem::path& folder) {
  std::error_code unreadable;
  return std::filesystem::exists(folder / "metadata.yaml", unreadable) &&
         !mcap_files_in(folder).empty();
}

BagFiles::BagFiles(const std::filesystem::path& path) {
  std::error_code unreadable;
  if (!std::filesystem::is_directory(path, unreadable)) {
    paths_ = {path};
  } else if (paths_ = mcap_files_in(path); paths_.empty()) {
    throw files::FileError(path.string() + ": the folder has no file NAME.mcap");
  }
  reader_ = std::make_unique<mcap::McapReader>(paths_.front());
}

std::optional<mcap::Message> BagFiles::next() {
  while (reader_) {
    if (auto message = next_in_file()) {
      return message;
    }
    reader_.reset();
    if (++index_ < paths_.size()) {
      reader_ = std::make_unique<mcap::McapReader>(paths_[index_]);
    }
  }
  if (cut_off_) {
    std::rethrow_exception(cut_off_);
  }
  return std::nullopt;
}

std::optional<mcap::Message> BagFiles::next_in_file() {
  try {
    while (auto record = reader_->next()) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      if (auto* message = std::get_if<mcap::Message>(&*record)) {
        return std::move(*message);
      }
    }
  } catch (const mcap::CutOffFile& error) {
    // The files after it belong to the same drive.
    cut_off_ = std::make_exception_ptr(CutOffLine(error.what()));
  }
  return std::nullopt;
}

double BagFiles::progress() const {
  const double of_file = reader_ ? reader_->progress() : 0.0;
  return (static_cast<double>(index_) + of_file) / static_cast<double>(paths_.size());
}

}  // namespace echomap::datasets
