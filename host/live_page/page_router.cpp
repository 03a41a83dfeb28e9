// SPDX-License-Identifier: MIT
#include "host/live_page/page_router.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include <nlohmann/json.hpp>

#include "host/live_page/run_files.hpp"

namespace echomap::live_page {

using nlohmann::ordered_json;

/// A path of the REST interface; a part in braces stands for any one.
struct PageRouter::Route {
  std::string_view method;
  std::string_view path;
  WebResponse (PageRouter::*respond)(const WebRequest&, const Values&) const;
};

namespace {

constexpr std::size_t kHeaderBytes = 16;  ///< Of a message, before its body.

std::string dumped(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

WebResponse not_found() { return text_response(404, "there is nothing here"); }

WebResponse not_allowed(const std::string& allowed) {
  WebResponse response = text_response(405, "this path takes " + allowed);
  response.headers.emplace_back("Allow", allowed);
  return response;
}

WebResponse refused(RequestGuard::Verdict verdict) {
  switch (verdict) {
    case RequestGuard::Verdict::kForeignHost:
      return text_response(
          403, "echomap answers to the address it listens on: open the URL that it has printed");
    case RequestGuard::Verdict::kForeignOrigin:
      return text_response(403, "echomap takes nothing from pages of others");
    case RequestGuard::Verdict::kNoToken:
    case RequestGuard::Verdict::kPass:
      break;
  }
  return text_response(401,
                       "echomap wants its token: open the URL that it has printed on the terminal "
                       "where it was started; the URL ends in ?token=...");
}

/// The values of a path's parts in braces; nothing where the path is another one.
std::optional<std::vector<std::string>> match(std::string_view pattern, std::string_view path) {
  std::vector<std::string> values;
  while (!pattern.empty() && !path.empty()) {
    const std::size_t pattern_end = std::min(pattern.find('/', 1), pattern.size());
    const std::size_t path_end = std::min(path.find('/', 1), path.size());
    const std::string_view expected = pattern.substr(0, pattern_end);
    const std::string_view part = path.substr(0, path_end);
    if (expected.starts_with("/{")) {
      const auto value = percent_decoded(part.substr(1));
      if (!part.starts_with('/') || !value) {
        return std::nullopt;
      }
      values.push_back(*value);
    } else if (expected != part) {
      return std::nullopt;
    }
    pattern.remove_prefix(pattern_end);
    path.remove_prefix(path_end);
  }
  return pattern.empty() && path.empty() ? std::optional(values) : std::nullopt;
}

/// Whether the run has ended with all that was asked for, by its newest state; a run that is not
/// live and says nothing of it has.
bool is_finished(const ServedRun& run) {
  for (const SharedMessage& message : run.history->newest()) {
    if (message->kind != MessageKind::kState || message->bytes.size() < kHeaderBytes) {
      continue;
    }
    const auto body = std::string_view(message->bytes).substr(kHeaderBytes);
    const auto state = nlohmann::json::parse(body, nullptr, false);
    if (state.is_object() && state.contains("result") && state["result"].is_object()) {
      return state["result"].value("finished", nlohmann::json()) == true;
    }
  }
  return !run.live;
}

/// For a header: what is not plain ASCII is written twice, by RFC 6266.
std::string disposition_of(const std::string& name) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string plain;
  std::string encoded;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_word = (letter >= '0' && letter <= '9') || (letter >= 'A' && letter <= 'Z') ||
                         (letter >= 'a' && letter <= 'z') || letter == '.' || letter == '-' ||
                         letter == '_';
    plain += is_word ? letter : '_';
    encoded += is_word ? std::string(1, letter)
                       : std::string{'%', kDigits[byte >> 4U], kDigits[byte & 0xFU]};
  }
  return "attachment; filename=\"" + plain + "\"; filename*=UTF-8''" + encoded;
}

unsigned status_of(const std::optional<RefusalCode>& refused) {
  if (!refused) {
    return 200;
  }
  const bool is_wrong = *refused == RefusalCode::kUnknown || *refused == RefusalCode::kMalformed;
  return is_wrong ? 400 : 409;
}

}  // namespace

const std::vector<PageRouter::Route>& PageRouter::routes() {
  static const std::vector<Route> all{
      {"GET", "/api/v1/runs", &PageRouter::runs},
      {"GET", "/api/v1/runs/{id}/history", &PageRouter::history},
      {"GET", "/api/v1/runs/{id}/files", &PageRouter::files},
      {"GET", "/api/v1/runs/{id}/files/{name}", &PageRouter::file},
      {"POST", "/api/v1/commands", &PageRouter::command},
      {"GET", "/api/v1/openapi.json", &PageRouter::openapi},
  };
  return all;
}

std::vector<std::string> PageRouter::rest_paths() {
  std::vector<std::string> paths;
  for (const Route& route : routes()) {
    paths.push_back(std::string(route.method) + " " + std::string(route.path));
  }
  return paths;
}

PageRouter::Answer PageRouter::answer(const WebRequest& request) const {
  const RequestGuard::Verdict verdict = content_.guard.judge(request);
  Answer answer = verdict == RequestGuard::Verdict::kPass ? route(request) : refused(verdict);
  if (auto* response = std::get_if<WebResponse>(&answer)) {
    response->has_body = request.method != "HEAD" && response->status != 304;
    const std::string cookie = content_.guard.cookie_for(request);
    if (verdict == RequestGuard::Verdict::kPass && !cookie.empty()) {
      response->headers.emplace_back("Set-Cookie", cookie);
    }
  }
  return answer;
}

PageRouter::Answer PageRouter::route(const WebRequest& request) const {
  const std::string_view path = request.path();
  if (path == "/ws") {
    return upgrade(request);
  }
  if (!content_.assets.has(path)) {
    return rest_response(request);
  }
  return request.only_reads() ? content_.assets.response(path, request) : not_allowed("GET, HEAD");
}

PageRouter::Answer PageRouter::upgrade(const WebRequest& request) const {
  if (!request.is_upgrade) {
    WebResponse response = text_response(426, "this path is for WebSockets");
    response.headers.emplace_back("Upgrade", "websocket");
    return response;
  }
  for (const auto header : request.values_of("Sec-WebSocket-Protocol")) {
    for (const auto offered : elements_of(header, ',')) {
      const auto& ours = content_.protocols;
      if (std::find(ours.begin(), ours.end(), offered) != ours.end()) {
        return SocketUpgrade{std::string(offered)};
      }
    }
  }
  return text_response(400, "no sub-protocol that echomap speaks: see docs/live_protocol.md");
}

WebResponse PageRouter::rest_response(const WebRequest& request) const {
  for (const Route& route : routes()) {
    const auto values = match(route.path, request.path());
    if (!values) {
      continue;
    }
    const bool is_taken =
        route.method == "GET" ? request.only_reads() : request.method == route.method;
    if (!is_taken) {
      return not_allowed(route.method == "GET" ? "GET, HEAD" : std::string(route.method));
    }
    return (this->*route.respond)(request, *values);
  }
  return not_found();
}

WebResponse PageRouter::runs(const WebRequest&, const Values&) const {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < content_.runs.size(); ++i) {
    const ServedRun& run = content_.runs[i];
    list.push_back({{"id", std::to_string(i)},
                    {"name", run.name},
                    {"live", run.live},
                    {"finished", is_finished(run)}});
  }
  return json_response(200, dumped(list));
}

WebResponse PageRouter::history(const WebRequest&, const Values& values) const {
  const ServedRun* run = run_of(values[0]);
  if (run == nullptr) {
    return not_found();
  }
  WebResponse response;
  response.headers = {{"Content-Type", "application/octet-stream"}, {"Cache-Control", "no-store"}};
  response.source = history_body(*run->history);
  return response;
}

WebResponse PageRouter::files(const WebRequest&, const Values& values) const {
  const ServedRun* run = run_of(values[0]);
  if (run == nullptr) {
    return not_found();
  }
  ordered_json list = ordered_json::array();
  for (const RunFile& file : run_files(run->folder)) {
    list.push_back(
        {{"name", file.name}, {"bytes", file.bytes}, {"media_type", media_type_of(file.name)}});
  }
  return json_response(200, dumped(list));
}

WebResponse PageRouter::file(const WebRequest&, const Values& values) const {
  const ServedRun* run = run_of(values[0]);
  WebResponse response;
  response.source = run == nullptr ? nullptr : open_run_file(run->folder, values[1]);
  if (!response.source) {
    return not_found();
  }
  response.headers = {{"Content-Type", std::string(media_type_of(values[1]))},
                      {"Content-Disposition", disposition_of(values[1])},
                      {"Cache-Control", "no-store"}};
  return response;
}

WebResponse PageRouter::command(const WebRequest& request, const Values&) const {
  const CommandHandler::Answer answer = content_.take_command(request.body);
  return json_response(status_of(answer.refused), answer.text);
}

WebResponse PageRouter::openapi(const WebRequest&, const Values&) const {
  return json_response(200, content_.openapi);
}

const ServedRun* PageRouter::run_of(const std::string& id) const {
  for (std::size_t i = 0; i < content_.runs.size(); ++i) {
    if (std::to_string(i) == id) {
      return &content_.runs[i];
    }
  }
  return nullptr;
}

}  // namespace echomap::live_page
