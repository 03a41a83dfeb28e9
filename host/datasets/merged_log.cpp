// SPDX-License-Identifier: MIT
#include "host/datasets/merged_log.hpp"

#include <limits>
#include <utility>

namespace echomap::datasets {

MergedLog::MergedLog(std::vector<std::unique_ptr<LogReader>> logs) {
  for (auto& log : logs) {
    sources_.push_back({std::move(log), std::nullopt, false});
  }
}

std::optional<LogRecord> MergedLog::next() {
  for (Source& source : sources_) {
    fill(source);
  }
  Source* first = earliest();
  if (first == nullptr && cut_off_) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): checked above
    throw *std::exchange(cut_off_, std::nullopt);
  }
  return first == nullptr ? std::nullopt : std::exchange(first->head, std::nullopt);
}

void MergedLog::fill(Source& source) {
  if (source.head || source.has_ended) {
    return;
  }
  try {
    source.head = source.log->next();
  } catch (const CutOffLine& half) {
    cut_off_ = half;
  }
  source.has_ended = !source.head;
}

MergedLog::Source* MergedLog::earliest() {
  Source* first = nullptr;
  double first_stamp_s = 0.0;
  for (Source& source : sources_) {
    if (!source.head) {
      continue;
    }
    const double unstamped = -std::numeric_limits<double>::infinity();
    const double head_stamp_s = stamp_s(*source.head).value_or(unstamped);
    if (first == nullptr || head_stamp_s < first_stamp_s) {
      first = &source;
      first_stamp_s = head_stamp_s;
    }
  }
  return first;
}

double MergedLog::progress() const {
  double sum = 0.0;
  for (const Source& source : sources_) {
    sum += source.log->progress();
  }
  return sources_.empty() ? 1.0 : sum / static_cast<double>(sources_.size());
}

}  // namespace echomap::datasets
