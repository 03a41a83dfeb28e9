// SPDX-License-Identifier: MIT
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "host/live_page/page_router.hpp"
#include "host/live_page/request_parsing.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/temporary_folder.hpp"

namespace {

namespace live_page = echomap::live_page;
using echomap::fuzz::require;

/// A page and a run with one file, and a secret beside them.
class Page {
 public:
  Page() {
    std::ofstream(folder_.path() / "index.html") << "the page";
    std::ofstream(folder_.path() / "secret") << secret;
    std::filesystem::create_directory(folder_.path() / "run");
    std::ofstream(folder_.path() / "run" / "map.png") << "a picture";
    history_->add(std::make_shared<const live_page::Message>(
        live_page::Message{live_page::MessageKind::kEvent, 0, 0.0, "event"}));
  }

  live_page::PageRouter router(const std::string& token) {
    return live_page::PageRouter({{*live_page::IpLiteral::parse("127.0.0.1"), 80, token},
                                  live_page::PageAssets(folder_.path()),
                                  "{}",
                                  {{"run", folder_.path() / "run", history_, true}},
                                  {"echomap.v1"},
                                  [this](std::string_view) {
                                    ++posted;
                                    return live_page::CommandHandler::Answer{};
                                  }});
  }

  static constexpr std::string_view secret = "a secret";
  int posted = 0;

 private:
  echomap::fuzz::TemporaryFolder folder_;
  std::shared_ptr<live_page::History> history_ = std::make_shared<live_page::History>();
};

std::string body_of(live_page::WebResponse& response) {
  std::string body = response.body ? *response.body : "";
  if (response.source) {
    const std::uint64_t size = response.source->size();
    for (std::string part = response.source->next_part(); !part.empty();
         part = response.source->next_part()) {
      body += part;
    }
    require(body.size() == size, "a body is as long as its head says");
  }
  return body;
}

void check_response(live_page::WebResponse& response) {
  const std::string head = live_page::head_of(response, true);
  require(head.ends_with("\r\n\r\n"), "a head ends");
  require(head.find("\r\n\r\n") == head.size() - 4, "nothing of the request ends it before");
  require(head.find('\0') == std::string::npos, "a head is a text");
  require(head.find("nosniff") != std::string::npos, "a head keeps browsers from guessing");
  require(body_of(response).find(Page::secret) == std::string::npos, "a run's folder is not left");
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  const std::string host = " HTTP/1.1\r\nHost: localhost\r\n";
  const std::string socket =
      "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  const std::pair<std::uint8_t, std::string> requests[] = {
      {0, "GET /" + host + "Accept-Encoding: gzip\r\nIf-None-Match: \"1-8\"\r\n\r\n"},
      {0, "HEAD /api/v1/runs" + host + "\r\n"},
      {0, "GET /api/v1/runs/0/history" + host + "\r\n"},
      {0, "GET /api/v1/runs/0/files" + host + "\r\n"},
      {0, "GET /api/v1/runs/0/files/map.png" + host + "\r\n"},
      {0, "GET /api/v1/runs/0/files/..%2fsecret" + host + "\r\n"},
      {0, "GET /api/v1/openapi.json?x=%41" + host + "\r\n"},
      {0,
       "POST /api/v1/commands" + host +
           "Origin: http://localhost\r\nContent-Length: 14\r\n\r\n{\"do\": \"stop\"}"},
      {0,
       "POST /api/v1/commands" + host +
           "Transfer-Encoding: chunked\r\n\r\ne\r\n{\"do\": \"stop\"}\r\n0\r\n\r\n"},
      {0, "GET /ws" + host + socket + "Sec-WebSocket-Protocol: a, echomap.v1\r\n\r\n"},
      {1, "GET /?token=s3cret" + host + "\r\n"},
      {1, "GET /" + host + "Cookie: a=b; echomap_80=s3cret\r\n\r\n"},
      {1, "GET / HTTP/1.0\r\nHost: [::1]:80\r\n\r\n"},
  };
  std::vector<Input> inputs;
  for (const auto& [kind, request] : requests) {
    inputs.push_back(input_of(kind, request));
  }
  return inputs;
}

/// One input is a request, behind a byte that says whether a token is demanded.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Page page;
  static const live_page::PageRouter open = page.router("");
  static const live_page::PageRouter guarded = page.router("s3cret");
  if (size == 0) {
    return 0;
  }
  const bool is_guarded = data[0] % 2 == 1;
  const std::string text = echomap::fuzz::text_of({data + 1, size - 1});
  auto parsed = live_page::parse_request(text);
  if (!parsed) {
    return 0;
  }
  if (auto* refused = std::get_if<live_page::WebResponse>(&*parsed)) {
    require(refused->status >= 400 && refused->status < 500, "what is no request is refused");
    check_response(*refused);
    return 0;
  }
  const auto& request = std::get<live_page::WebRequest>(*parsed);
  page.posted = 0;
  auto answer = (is_guarded ? guarded : open).answer(request);
  const bool has_token =
      text.find("s3cret") != std::string::npos || text.find('%') != std::string::npos;
  if (auto* response = std::get_if<live_page::WebResponse>(&answer)) {
    require(!is_guarded || has_token || response->status >= 400, "the token is demanded");
    check_response(*response);
  } else {
    require(request.is_upgrade, "only a request for a WebSocket becomes one");
    require(!is_guarded || has_token, "the token is demanded of a WebSocket");
  }
  require(page.posted == 0 || request.method == "POST", "a command is posted");
  return 0;
}
