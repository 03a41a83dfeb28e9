// SPDX-License-Identifier: MIT
#include "host/live_page/page_router.hpp"

#include <algorithm>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/host/live_page/served_page.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::live_page {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

const std::string description = ECHOMAP_SOURCE_DIR "/host/live_page/openapi.json";

class PageRouterTest : public testing::Test {
 protected:
  PageRouterTest() {
    std::ofstream(folder_ / "index.html") << "the page";
    std::filesystem::create_directory(folder_ / "run");
    std::ofstream(folder_ / "run" / "map.png") << "a picture";
    std::ofstream(folder_ / "run" / "größe \"1\".csv") << "1";
  }

  PageRouter router(const std::string& token = {}) {
    return PageRouter({RequestGuard(*IpLiteral::parse("127.0.0.1"), 80, token),
                       PageAssets(folder_.path()),
                       files::read_text_file(description),
                       {{"first_map", folder_ / "run", history_, true},
                        {"older", {}, std::make_shared<History>(), false}},
                       {"foxglove.sdk.v1", "echomap.v1"},
                       [this](std::string_view text) {
                         posted_.emplace_back(text);
                         return posted_answer_;
                       }});
  }
  static WebRequest asked(const std::string& method, const std::string& target) {
    return {method, target, {{"Host", "localhost"}}, {}};
  }
  WebResponse response(const std::string& target, const std::string& method = "GET") {
    auto answer = router().answer(asked(method, target));
    return std::move(std::get<WebResponse>(answer));
  }
  unsigned status(const std::string& target, const std::string& method = "GET") {
    return response(target, method).status;
  }
  PageRouter::Answer socket_answer(const std::string& protocols) {
    WebRequest request = asked("GET", "/ws");
    request.is_upgrade = true;
    request.headers.emplace_back("Sec-WebSocket-Protocol", protocols);
    return router().answer(request);
  }
  static std::string header_of(const WebResponse& response, const std::string& name) {
    for (const auto& [key, value] : response.headers) {
      if (key == name) {
        return value;
      }
    }
    return {};
  }

  const tests::ScratchFolder folder_;
  std::shared_ptr<History> history_ = std::make_shared<History>();
  std::vector<std::string> posted_;
  CommandHandler::Answer posted_answer_{"{}", {}, {}};
};

TEST_F(PageRouterTest, ListsTheRuns) {
  EXPECT_EQ(json::parse(*response("/api/v1/runs").body),
            json::parse(R"([{"id": "0", "name": "first_map", "live": true, "finished": false},
                            {"id": "1", "name": "older", "live": false, "finished": true}])"));
}

TEST_F(PageRouterTest, KnowsByItsStateThatARunHasFinished) {
  history_->add(made_message(
      MessageKind::kState, 0, std::string(16, '\0') + R"({"result": {"finished": true}})"));
  EXPECT_EQ(json::parse(*response("/api/v1/runs").body)[0]["finished"], true);
  history_->add(made_message(MessageKind::kState, 0, std::string(16, '\0') + R"({"result": {}})"));
  EXPECT_EQ(json::parse(*response("/api/v1/runs").body)[0]["finished"], false);
}

TEST_F(PageRouterTest, ServesTheHistoryOfARun) {
  history_->add(made_message(MessageKind::kEvent, 0, "ab"));
  const WebResponse found = response("/api/v1/runs/0/history");
  ASSERT_NE(found.source, nullptr);
  EXPECT_EQ(found.source->next_part(), std::string("\2\0\0\0ab", 6));
}

TEST_F(PageRouterTest, ListsAndServesTheFilesOfARun) {
  const json files = json::parse(*response("/api/v1/runs/0/files").body);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[1], json::parse(R"({"name": "map.png", "bytes": 9, "media_type": "image/png"})"));
  const WebResponse picture = response("/api/v1/runs/0/files/map.png");
  EXPECT_EQ(picture.source->next_part(), "a picture");
  EXPECT_EQ(header_of(picture, "Content-Type"), "image/png");
  EXPECT_EQ(header_of(picture, "Content-Disposition"),
            "attachment; filename=\"map.png\"; filename*=UTF-8''map.png");
  EXPECT_EQ(*response("/api/v1/runs/1/files").body, "[]");
}

TEST_F(PageRouterTest, QuotesTheNamesOfFiles) {
  const WebResponse found = response("/api/v1/runs/0/files/gr%C3%B6%C3%9Fe%20%221%22.csv");
  ASSERT_EQ(found.status, 200U);
  EXPECT_EQ(header_of(found, "Content-Disposition"),
            "attachment; filename=\"gr____e__1_.csv\"; "
            "filename*=UTF-8''gr%C3%B6%C3%9Fe%20%221%22.csv");
}

TEST_F(PageRouterTest, HasNothingBesideItsPaths) {
  std::ofstream(folder_ / "secret") << "a secret";
  for (const char* target : {"/index.html",
                             "/secret",
                             "/../secret",
                             "",
                             "*",
                             "//",
                             "/ws/",
                             "/api/v1/runs/",
                             "/api/v1/runs/2/files",
                             "/api/v1/runs/00/files",
                             "/api/v1/runs/-1/files",
                             "/api/v1/runs//files",
                             "/api/v1/runs/0/files/",
                             "/api/v1/runs/0/files/../../secret",
                             "/api/v1/runs/0/files/..%2fsecret",
                             "/api/v1/runs/0/files/%2e%2e",
                             "/api/v1/runs/0/files/%",
                             "/api/v1/runs/0/files/map.png%00",
                             "/api/v1/runs/0/files/map.png/x",
                             "http://127.0.0.1/"}) {
    EXPECT_EQ(status(target), 404U) << target;
  }
}

TEST_F(PageRouterTest, TakesCommandsByPostAlone) {
  EXPECT_EQ(status("/api/v1/commands"), 405U);
  EXPECT_EQ(status("/", "POST"), 405U);
  EXPECT_EQ(header_of(response("/api/v1/runs", "DELETE"), "Allow"), "GET, HEAD");
  WebRequest request = asked("POST", "/api/v1/commands");
  request.body = R"({"do": "stop"})";
  EXPECT_EQ(std::get<WebResponse>(router().answer(request)).status, 200U);
  EXPECT_THAT(posted_, testing::ElementsAre(request.body));
  posted_answer_.refused = RefusalCode::kMalformed;
  EXPECT_EQ(std::get<WebResponse>(router().answer(request)).status, 400U);
  posted_answer_.refused = RefusalCode::kNotDriver;
  EXPECT_EQ(std::get<WebResponse>(router().answer(request)).status, 409U);
}

TEST_F(PageRouterTest, SpeaksTheFirstSubProtocolThatItKnows) {
  const auto protocol_of = [&](const std::string& offered) {
    const auto answer = socket_answer(offered);
    const auto* upgrade = std::get_if<SocketUpgrade>(&answer);
    return upgrade == nullptr ? "" : upgrade->protocol;
  };
  EXPECT_EQ(protocol_of("echomap.v1"), "echomap.v1");
  EXPECT_EQ(protocol_of("soap, foxglove.sdk.v1,echomap.v1"), "foxglove.sdk.v1");
  EXPECT_EQ(std::get<WebResponse>(socket_answer("soap")).status, 400U);
  EXPECT_EQ(std::get<WebResponse>(socket_answer("")).status, 400U);
  EXPECT_EQ(status("/ws"), 426U);
}

TEST_F(PageRouterTest, AnswersAHeadWithoutABody) {
  EXPECT_FALSE(response("/", "HEAD").has_body);
  EXPECT_TRUE(response("/").has_body);
}

TEST_F(PageRouterTest, SaysWhereTheTokenIs) {
  const PageRouter guarded = router("s3cret");
  const auto refused = guarded.answer(asked("GET", "/"));
  EXPECT_EQ(std::get<WebResponse>(refused).status, 401U);
  EXPECT_THAT(*std::get<WebResponse>(refused).body, HasSubstr("printed on the terminal"));
  const auto page = guarded.answer(asked("GET", "/?token=s3cret"));
  EXPECT_EQ(std::get<WebResponse>(page).status, 200U);
  EXPECT_THAT(header_of(std::get<WebResponse>(page), "Set-Cookie"), HasSubstr("HttpOnly"));
}

TEST_F(PageRouterTest, RefusesForeignRequestsBeforeItLooksAtThem) {
  WebRequest request = asked("POST", "/api/v1/commands");
  request.body = R"({"do": "explore"})";
  request.headers.emplace_back("Origin", "http://evil.example");
  EXPECT_EQ(std::get<WebResponse>(router().answer(request)).status, 403U);
  request.headers = {{"Host", "evil.example"}};
  EXPECT_EQ(std::get<WebResponse>(router().answer(request)).status, 403U);
  EXPECT_TRUE(posted_.empty());
}

TEST_F(PageRouterTest, IsDescribedPathByPath) {
  const json document = json::parse(*response("/api/v1/openapi.json").body);
  EXPECT_EQ(document["openapi"], "3.1.0");
  std::vector<std::string> described;
  for (const auto& [path, methods] : document["paths"].items()) {
    for (const auto& [method, operation] : methods.items()) {
      std::string name = method;
      std::transform(name.begin(), name.end(), name.begin(), ::toupper);
      described.push_back(name + " " + path);
      EXPECT_TRUE(operation.contains("responses")) << path;
    }
  }
  EXPECT_THAT(described, UnorderedElementsAreArray(PageRouter::rest_paths()));
}

}  // namespace
}  // namespace echomap::live_page
