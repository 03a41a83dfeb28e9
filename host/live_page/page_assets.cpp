// SPDX-License-Identifier: MIT
#include "host/live_page/page_assets.hpp"

#include <algorithm>
#include <stdexcept>
#include <zlib.h>

#include "host/files/atomic_file.hpp"

namespace echomap::live_page {
namespace {

namespace fs = std::filesystem;

struct AssetFile {
  const char* path;
  const char* file;
  const char* media_type;
};

constexpr AssetFile kAssetFiles[] = {
    {"/", "index.html", "text/html; charset=utf-8"},
    {"/app.js", "app.js", "text/javascript; charset=utf-8"},
    {"/app.css", "app.css", "text/css; charset=utf-8"},
    {"/favicon.svg", "favicon.svg", "image/svg+xml"},
};

std::string tag_of(const std::string& text) {
  const auto sum =
      ::crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
  return std::to_string(sum) + "-" + std::to_string(text.size());
}

/// Whether a list of tags, as If-None-Match has it, holds this one.
bool is_among(std::string_view tag, const WebRequest& request) {
  const auto tags = elements_of(request.value_of("If-None-Match").value_or(""), ',');
  return std::any_of(tags.begin(), tags.end(), [&](std::string_view each) {
    return each == tag || (each.starts_with("W/") && each.substr(2) == tag);
  });
}

}  // namespace

PageAssets::PageAssets(const fs::path& folder) {
  for (const AssetFile& file : kAssetFiles) {
    const fs::path path = folder / file.file;
    if (std::string_view(file.path) != "/" && !fs::exists(path)) {
      continue;
    }
    auto text = std::make_shared<const std::string>(files::read_text_file(path));
    auto packed = std::make_shared<const std::string>(gzipped(*text));
    assets_[file.path] = {file.media_type, tag_of(*text), std::move(text), std::move(packed)};
  }
}

WebResponse PageAssets::response(std::string_view path, const WebRequest& request) const {
  const Asset& asset = assets_.find(path)->second;
  const bool is_packed = accepts_gzip(request);
  const std::string tag = "\"" + asset.tag + (is_packed ? "-gz\"" : "\"");
  WebResponse response;
  response.headers = {{"Content-Type", asset.media_type},
                      {"Cache-Control", "no-cache"},
                      {"ETag", tag},
                      {"Vary", "Accept-Encoding"}};
  if (is_among(tag, request)) {
    response.status = 304;
    return response;
  }
  if (is_packed) {
    response.headers.emplace_back("Content-Encoding", "gzip");
  }
  response.body = is_packed ? asset.gzipped : asset.plain;
  return response;
}

std::string gzipped(std::string_view text) {
  constexpr int kGzipFormat = 15 + 16;
  constexpr int kMemoryLevel = 8;
  z_stream stream{};
  if (::deflateInit2(
          &stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipFormat, kMemoryLevel, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::runtime_error("zlib cannot begin");
  }
  std::string packed(::deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int result = ::deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  ::deflateEnd(&stream);
  if (result != Z_STREAM_END) {
    throw std::runtime_error("zlib cannot end");
  }
  return packed;
}

bool accepts_gzip(const WebRequest& request) {
  const auto accepted = elements_of(request.value_of("Accept-Encoding").value_or(""), ',');
  return std::any_of(accepted.begin(), accepted.end(), [](std::string_view coding) {
    const auto parts = elements_of(coding, ';');
    const bool is_refused =
        parts.size() > 1 && (parts[1] == "q=0" || parts[1].starts_with("q=0.0"));
    return !parts.empty() && is_same_text(parts[0], "gzip") && !is_refused;
  });
}

}  // namespace echomap::live_page
