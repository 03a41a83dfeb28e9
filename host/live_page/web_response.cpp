// SPDX-License-Identifier: MIT
#include "host/live_page/web_response.hpp"

namespace echomap::live_page {
namespace {

constexpr std::string_view kSafetyHeaders =
    "Content-Security-Policy: default-src 'self'; base-uri 'none'; form-action 'self'; "
    "frame-ancestors 'none'\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "X-Frame-Options: DENY\r\n";

std::string_view reason_of(unsigned status) {
  switch (status) {
    case 200:
      return "OK";
    case 304:
      return "Not Modified";
    case 400:
      return "Bad Request";
    case 401:
      return "Unauthorized";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 409:
      return "Conflict";
    case 413:
      return "Content Too Large";
    case 426:
      return "Upgrade Required";
    case 431:
      return "Request Header Fields Too Large";
    default:
      return "Error";
  }
}

WebResponse typed_response(unsigned status, std::string body, std::string type) {
  WebResponse response;
  response.status = status;
  response.headers = {{"Content-Type", std::move(type)}, {"Cache-Control", "no-store"}};
  response.body = std::make_shared<const std::string>(std::move(body));
  return response;
}

}  // namespace

std::uint64_t WebResponse::body_size() const {
  if (source) {
    return source->size();
  }
  return body ? body->size() : 0;
}

WebResponse text_response(unsigned status, std::string text) {
  return typed_response(status, std::move(text) + "\n", "text/plain; charset=utf-8");
}

WebResponse json_response(unsigned status, std::string json) {
  return typed_response(status, std::move(json), "application/json");
}

std::string head_of(const WebResponse& response, bool keep_alive) {
  std::string head = "HTTP/1.1 " + std::to_string(response.status) + " ";
  head += reason_of(response.status);
  head += "\r\n";
  for (const auto& [name, value] : response.headers) {
    head.append(name).append(": ").append(value).append("\r\n");
  }
  head += kSafetyHeaders;
  if (response.status != 304) {
    head += "Content-Length: " + std::to_string(response.body_size()) + "\r\n";
  }
  head += keep_alive ? "Connection: keep-alive\r\n\r\n" : "Connection: close\r\n\r\n";
  return head;
}

}  // namespace echomap::live_page
