// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace echomap::live_page {

/// A body that is too long to be held at once.
class BodySource {
 public:
  virtual ~BodySource() = default;
  virtual std::uint64_t size() const = 0;
  /// The next part; empty at the end, and where it cannot be read on.
  virtual std::string next_part() = 0;
};

/// What is answered to an HTTP request.
struct WebResponse {
  unsigned status = 200;
  std::vector<std::pair<std::string, std::string>> headers;
  std::shared_ptr<const std::string> body;  ///< Null where `source` has it.
  std::unique_ptr<BodySource> source;
  bool has_body = true;  ///< False: its length is told, and nothing follows.

  std::uint64_t body_size() const;
};

/// Words for people.
WebResponse text_response(unsigned status, std::string text);

/// An answer to a program.
WebResponse json_response(unsigned status, std::string json);

/// The response up to its body, with what every response says for the browser's safety.
std::string head_of(const WebResponse& response, bool keep_alive);

}  // namespace echomap::live_page
