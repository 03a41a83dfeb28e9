// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "host/robot_link/retransmission_timer.hpp"
#include "host/time/host_time.hpp"
#include "protocol/bulk_messages.hpp"

namespace echomap::robot_link {

/// How a bulk content is read.
struct BulkParams {
  std::size_t window = 4;        ///< Pieces asked for at a time.
  int tries = 8;                 ///< Of each piece, as of commands.
  std::size_t max_bytes = 8192;  ///< What a firmware has to say of itself takes less.
};

/// How reading a content ended.
enum class BulkStatus : std::uint8_t {
  kWhole,
  kNotThere,      ///< The robot does not have it.
  kNoAnswer,      ///< Some piece never came, or the link was lost.
  kInconsistent,  ///< It changed its length while it was read, or is too long.
};

/// A content that was read; `bytes` are all of it, or none.
struct BulkResult {
  protocol::BulkContent content{};
  BulkStatus status = BulkStatus::kNoAnswer;
  std::vector<std::uint8_t> bytes;
};

/// Reads one content at a time, piece by piece: a few are asked for at once, and those that do not
/// come are asked for again.
class BulkReader {
 public:
  static constexpr std::size_t kPieceBytes = 32;

  /// Throws std::invalid_argument for a window, tries or length of nothing.
  explicit BulkReader(const RetransmissionParams& retransmission, const BulkParams& params = {});

  /// Starts again, whatever was being read.
  void start(protocol::BulkContent content);
  /// Ends in kNoAnswer what is being read.
  void abandon();

  /// Ends the reading where a piece has been asked for often enough in vain.
  void give_up_if_exhausted(time::HostTime now);
  /// Whether a piece must be asked for now, for the first time or again.
  bool is_due(time::HostTime now) const;
  /// That piece; only while `is_due`.
  protocol::BulkRead take(time::HostTime now);
  /// A piece has come; one that nobody waits for is ignored.
  void take_answer(const protocol::BulkData& data, time::HostTime now);

  /// How the reading ended, once.
  std::optional<BulkResult> take_result();

 private:
  struct Request {
    int tries = 0;
    time::HostTime sent_at;
    time::HostTime resend_at;
  };
  using Requests = std::map<std::size_t, Request>;  ///< By offset.

  std::optional<std::size_t> next_new_piece() const;
  Requests::const_iterator overdue(time::HostTime now) const;
  void keep(const protocol::BulkData& data);
  void end(BulkStatus status);

  RetransmissionParams retransmission_;
  RetransmissionTimer timer_;
  BulkParams params_;
  bool is_reading_ = false;
  protocol::BulkContent content_{};
  std::optional<std::size_t> total_bytes_;
  std::size_t next_offset_ = 0;  ///< Not asked for yet.
  Requests open_;
  std::vector<std::uint8_t> bytes_;
  std::optional<BulkResult> result_;
};

}  // namespace echomap::robot_link
