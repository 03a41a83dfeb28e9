// SPDX-License-Identifier: MIT
#include "host/robot_link/credit_window.hpp"

#include <algorithm>
#include <stdexcept>

namespace echomap::robot_link {

CreditWindow::CreditWindow(const CreditParams& params) : params_(params) {
  if (params.release_after <= CreditParams::Duration::zero()) {
    throw std::invalid_argument("credit window: release_after is not above 0");
  }
}

bool CreditWindow::has_room(std::size_t bytes, std::size_t spare) const {
  return under_way_.empty() || !limit_bytes_ || unconfirmed_bytes_ + bytes + spare <= *limit_bytes_;
}

bool CreditWindow::wants_answer() const {
  return limit_bytes_ && unanswerable_bytes_ > 0 && unanswerable_bytes_ >= *limit_bytes_ / 4;
}

void CreditWindow::add(std::size_t bytes, const std::optional<AnswerKey>& key, time::HostTime now) {
  under_way_.push_back({bytes, key, now});
  unconfirmed_bytes_ += bytes;
  unanswerable_bytes_ = key ? 0 : unanswerable_bytes_ + bytes;
}

void CreditWindow::confirm(const AnswerKey& key) {
  const auto answered = std::ranges::find(under_way_, key, &Sent::key);
  if (answered == under_way_.end()) {
    return;
  }
  for (auto count = answered - under_way_.begin() + 1; count > 0; --count) {
    pop_front();
  }
}

void CreditWindow::release_overdue(time::HostTime now) {
  while (!under_way_.empty() && now - under_way_.front().at >= params_.release_after) {
    released_bytes_ += under_way_.front().bytes;
    pop_front();
  }
}

void CreditWindow::pop_front() {
  unconfirmed_bytes_ -= under_way_.front().bytes;
  under_way_.pop_front();
  unanswerable_bytes_ = std::min(unanswerable_bytes_, unconfirmed_bytes_);
}

}  // namespace echomap::robot_link
