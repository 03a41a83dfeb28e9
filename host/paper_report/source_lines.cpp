// SPDX-License-Identifier: MIT
#include "host/paper_report/source_lines.hpp"

#include <fstream>
#include <utility>

namespace echomap::paper_report {

SourceLines::SourceLines(std::filesystem::path root, std::string link_base)
    : root_(std::move(root)), link_base_(std::move(link_base)) {
  if (!link_base_.empty() && link_base_.back() != '/') {
    link_base_ += '/';
  }
}

std::optional<int> SourceLines::line(const std::string& file, const std::string& symbol) const {
  std::ifstream source(root_ / file);
  std::string text;
  for (int number = 1; !symbol.empty() && std::getline(source, text); ++number) {
    if (text.find(symbol) != std::string::npos) {
      return number;
    }
  }
  return std::nullopt;
}

std::optional<std::string> SourceLines::link(const std::string& file) const {
  if (link_base_.empty()) {
    return std::nullopt;
  }
  return link_base_ + file;
}

}  // namespace echomap::paper_report
