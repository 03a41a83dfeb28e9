// SPDX-License-Identifier: MIT
#include "host/robot_link/bulk_reader.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace echomap::robot_link {
namespace {

std::array<std::uint8_t, BulkReader::kPieceBytes> bytes_of(const protocol::BulkData& data) {
  const std::array words{data.word_0,
                         data.word_1,
                         data.word_2,
                         data.word_3,
                         data.word_4,
                         data.word_5,
                         data.word_6,
                         data.word_7};
  std::array<std::uint8_t, BulkReader::kPieceBytes> bytes{};
  static_assert(sizeof(words) == sizeof(bytes));
  std::memcpy(bytes.data(), words.data(), bytes.size());
  return bytes;
}

}  // namespace

BulkReader::BulkReader(const RetransmissionParams& retransmission, const BulkParams& params)
    : retransmission_(retransmission), timer_(retransmission), params_(params) {
  if (params.window == 0 || params.tries < 1 || params.max_bytes == 0) {
    throw std::invalid_argument("bulk reader: window, tries and length must be positive");
  }
}

void BulkReader::start(protocol::BulkContent content) {
  is_reading_ = true;
  content_ = content;
  timer_ = RetransmissionTimer(retransmission_);
  total_bytes_.reset();
  next_offset_ = 0;
  open_.clear();
  bytes_.clear();
  result_.reset();
}

void BulkReader::abandon() {
  if (is_reading_) {
    end(BulkStatus::kNoAnswer);
  }
}

void BulkReader::give_up_if_exhausted(time::HostTime now) {
  const bool is_exhausted = std::ranges::any_of(open_, [&](const auto& one) {
    return one.second.tries >= params_.tries && now >= one.second.resend_at;
  });
  if (is_exhausted) {
    end(BulkStatus::kNoAnswer);
  }
}

bool BulkReader::is_due(time::HostTime now) const {
  return is_reading_ && (next_new_piece() || overdue(now) != open_.end());
}

/// Before the length is known the whole window is asked for: pieces beyond the end are empty.
std::optional<std::size_t> BulkReader::next_new_piece() const {
  const bool is_last = total_bytes_ && next_offset_ >= *total_bytes_;
  return is_last || open_.size() >= params_.window ? std::nullopt : std::optional(next_offset_);
}

BulkReader::Requests::const_iterator BulkReader::overdue(time::HostTime now) const {
  return std::ranges::find_if(open_, [&](const auto& one) {
    return one.second.tries < params_.tries && now >= one.second.resend_at;
  });
}

protocol::BulkRead BulkReader::take(time::HostTime now) {
  std::size_t offset = next_offset_;
  if (const auto again = overdue(now); again != open_.end()) {
    offset = again->first;
    timer_.back_off();
  } else {
    next_offset_ += kPieceBytes;
  }
  Request& request = open_[offset];
  ++request.tries;
  request.sent_at = now;
  request.resend_at = now + timer_.timeout();
  return {static_cast<std::uint8_t>(content_), static_cast<std::uint16_t>(offset)};
}

void BulkReader::take_answer(const protocol::BulkData& data, time::HostTime now) {
  const bool is_ours = is_reading_ && data.content == static_cast<std::uint8_t>(content_);
  const auto request = is_ours ? open_.find(data.offset) : open_.end();
  if (request == open_.end()) {
    return;
  }
  if (request->second.tries == 1) {
    timer_.sample(now - request->second.sent_at);
  }
  open_.erase(request);
  if (data.total == 0) {
    end(BulkStatus::kNotThere);
  } else if (data.total > params_.max_bytes || data.total != total_bytes_.value_or(data.total)) {
    end(BulkStatus::kInconsistent);
  } else {
    keep(data);
  }
}

void BulkReader::keep(const protocol::BulkData& data) {
  total_bytes_ = data.total;
  bytes_.resize(data.total);
  if (data.offset < data.total) {
    const auto piece = bytes_of(data);
    const auto count = std::min(piece.size(), bytes_.size() - data.offset);
    std::copy_n(piece.begin(), count, bytes_.begin() + data.offset);
  }
  std::erase_if(open_, [&](const auto& one) { return one.first >= data.total; });
  if (next_offset_ >= data.total && open_.empty()) {
    end(BulkStatus::kWhole);
  }
}

void BulkReader::end(BulkStatus status) {
  result_ =
      BulkResult{content_,
                 status,
                 status == BulkStatus::kWhole ? std::move(bytes_) : std::vector<std::uint8_t>()};
  is_reading_ = false;
  open_.clear();
}

std::optional<BulkResult> BulkReader::take_result() { return std::exchange(result_, std::nullopt); }

}  // namespace echomap::robot_link
