// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/descriptor.hpp"
#include "hil_mock/runner/outgoing_bytes.hpp"

namespace echomap::runner {

/// A raw pseudo-terminal behind a symbolic link whose name does not change.
class PtyEndpoint : public ByteEndpoint {
 public:
  /// Opens a pty and lets `link` point to it. Throws std::system_error, and std::runtime_error
  /// where `link` is something else than a symbolic link.
  PtyEndpoint(std::filesystem::path link, WhenUnread when_unread);
  /// Removes the link, unless it points elsewhere by now.
  ~PtyEndpoint() override;
  PtyEndpoint(const PtyEndpoint&) = delete;
  PtyEndpoint& operator=(const PtyEndpoint&) = delete;

  std::vector<std::uint8_t> receive() override;
  void send(std::span<const std::uint8_t> bytes) override;
  std::string address() const override { return link_.string(); }
  int descriptor() const override { return master_.number(); }
  bool is_sending() const override { return !outgoing_.empty(); }
  std::uint64_t dropped_bytes() const override { return outgoing_.dropped(); }

 private:
  void publish_link() const;

  std::filesystem::path link_;
  OutgoingBytes outgoing_;
  Descriptor master_;
  std::string slave_path_;
  /// Held open: without it the master would fail whenever no host is there, and each host would
  /// find the terminal back in its cooked state.
  Descriptor slave_;
};

}  // namespace echomap::runner
