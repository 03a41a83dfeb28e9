// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "host/live_page/web_request.hpp"
#include "host/live_page/web_response.hpp"

namespace echomap::live_page {

/// The files of the page, read once.
class PageAssets {
 public:
  /// Throws files::FileError where the folder has no index.html.
  explicit PageAssets(const std::filesystem::path& folder);

  bool has(std::string_view path) const { return assets_.contains(path); }
  /// Of a path that is there.
  WebResponse response(std::string_view path, const WebRequest& request) const;

 private:
  struct Asset {
    std::string media_type;
    std::string tag;  ///< Another one where the content is another one.
    std::shared_ptr<const std::string> plain;
    std::shared_ptr<const std::string> gzipped;
  };

  std::map<std::string, Asset, std::less<>> assets_;
};

/// A gzip file of the text, the same every time.
std::string gzipped(std::string_view text);

/// Whether the client takes gzip's format.
bool accepts_gzip(const WebRequest& request);

}  // namespace echomap::live_page
