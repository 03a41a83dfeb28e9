// SPDX-License-Identifier: MIT
#include "host/live_page/page_assets.hpp"

#include <fstream>
#include <string>
#include <zlib.h>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::live_page {
namespace {

std::string header_of(const WebResponse& response, const std::string& name) {
  for (const auto& [key, value] : response.headers) {
    if (key == name) {
      return value;
    }
  }
  return {};
}

WebRequest asks_with(const std::string& header, const std::string& value) {
  return {"GET", "/", {{header, value}}, {}};
}

std::string unpacked(const std::string& gzip) {
  z_stream stream{};
  ::inflateInit2(&stream, 15 + 16);
  std::string text(100000, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(gzip.data()));
  stream.avail_in = static_cast<uInt>(gzip.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  EXPECT_EQ(::inflate(&stream, Z_FINISH), Z_STREAM_END);
  text.resize(stream.total_out);
  ::inflateEnd(&stream);
  return text;
}

class PageAssetsTest : public testing::Test {
 protected:
  PageAssetsTest() {
    std::ofstream(folder_ / "index.html") << text_;
    std::ofstream(folder_ / "app.css") << "";
    std::ofstream(folder_ / "private.txt") << "nobody's business";
  }

  const tests::ScratchFolder folder_;
  const std::string text_ = "<p>" + std::string(5000, 'x');
};

TEST_F(PageAssetsTest, AreTheFilesOfThePageAndNoOthers) {
  const PageAssets assets(folder_.path());
  EXPECT_TRUE(assets.has("/"));
  EXPECT_TRUE(assets.has("/app.css"));
  EXPECT_FALSE(assets.has("/app.js")) << "is not there";
  EXPECT_FALSE(assets.has("/private.txt"));
  const WebResponse response = assets.response("/", {});
  EXPECT_EQ(*response.body, text_);
  EXPECT_EQ(header_of(response, "Content-Type"), "text/html; charset=utf-8");
  EXPECT_EQ(header_of(response, "Cache-Control"), "no-cache");
}

TEST_F(PageAssetsTest, ArePackedForThoseWhoTakeIt) {
  const PageAssets assets(folder_.path());
  const WebResponse response =
      assets.response("/", asks_with("accept-encoding", "deflate, GZIP;q=0.5, br"));
  EXPECT_EQ(header_of(response, "Content-Encoding"), "gzip");
  EXPECT_LT(response.body->size(), 200U);
  EXPECT_EQ(unpacked(*response.body), text_);
  EXPECT_EQ(unpacked(gzipped("")), "");
}

TEST_F(PageAssetsTest, AreNotPackedForOthers) {
  for (const char* coding : {"", "br", "gzip;q=0", "gzip; q=0.0", "xgzip"}) {
    EXPECT_FALSE(accepts_gzip(asks_with("Accept-Encoding", coding))) << coding;
  }
  EXPECT_FALSE(accepts_gzip({}));
}

TEST_F(PageAssetsTest, AreNotSentTwice) {
  const PageAssets assets(folder_.path());
  const std::string tag = header_of(assets.response("/", {}), "ETag");
  const WebResponse again = assets.response("/", asks_with("If-None-Match", "\"x\", W/" + tag));
  EXPECT_EQ(again.status, 304U);
  EXPECT_EQ(again.body, nullptr);
  EXPECT_EQ(assets.response("/app.css", asks_with("If-None-Match", tag)).status, 200U);
}

TEST_F(PageAssetsTest, AreNothingWithoutAPage) {
  const tests::ScratchFolder empty;
  EXPECT_THROW(PageAssets(empty.path()), files::FileError);
}

}  // namespace
}  // namespace echomap::live_page
