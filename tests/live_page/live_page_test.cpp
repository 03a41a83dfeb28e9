// SPDX-License-Identifier: MIT
/// What a real browser sees of the live page of whole programs. Scripts check it, several things in
/// one run of the programs; each of them is a test here.
#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/structure/shell.hpp"

namespace echomap::live_page {
namespace {

using nlohmann::json;
using structure::shell_quoted;

constexpr const char* kPackages = ECHOMAP_LIVE_PAGE_PACKAGES;

/// What a script says; the first call runs it.
const json& report_of(const std::string& script) {
  static std::map<std::string, json> reports;
  const auto [entry, is_new] = reports.try_emplace(script);
  if (is_new) {
    const auto result =
        structure::run_shell("ECHOMAP_PROGRAMS=" + shell_quoted(ECHOMAP_PROGRAMS) +
                                 " ECHOMAP_SOURCE=" + shell_quoted(ECHOMAP_SOURCE_DIR) +
                                 " ECHOMAP_CHROMIUM=" + shell_quoted(ECHOMAP_CHROMIUM) + " node " +
                                 shell_quoted(script) + " 2>" + script + ".log",
                             kPackages);
    entry->second = json::parse(result.output, nullptr, false);
    if (!entry->second.is_object()) {
      const auto log = structure::run_shell("tail -n 20 " + script + ".log", kPackages);
      entry->second = json{{"failure", result.output + log.output}};
    }
  }
  return entry->second;
}

class LivePage : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(std::string(kPackages) + "/installed")) {
      GTEST_SKIP() << "no node 20, no npm, or its packages could not be installed";
    }
    if (!std::filesystem::exists(ECHOMAP_CHROMIUM)) {
      GTEST_SKIP() << "no chromium";
    }
  }
  static void expect(const std::string& script, const std::string& check) {
    const json& report = report_of(script);
    ASSERT_TRUE(report.contains(check)) << script << " did not come to it: " << report;
    EXPECT_TRUE(report.at(check).at("holds")) << report.at(check).at("seen").get<std::string>();
  }
};

class LivePageStops : public LivePage {
 protected:
  static void expect(const std::string& check) { LivePage::expect("stop_checks.mjs", check); }
};

TEST_F(LivePageStops, AtTheButton) { expect("stop_button"); }
TEST_F(LivePageStops, WhenAKeyIsLetGo) { expect("letting_go"); }
TEST_F(LivePageStops, WhenTheServerIsFrozen) { expect("frozen_server"); }
TEST_F(LivePageStops, WhenTheTabIsClosed) { expect("closed_tab"); }
TEST_F(LivePageStops, WhenTheNetworkIsCut) { expect("cut_network"); }
TEST_F(LivePageStops, WhenTheTabIsHidden) { expect("hidden_tab"); }
TEST_F(LivePageStops, AndIgnoresCommandsThatComeLate) { expect("commands_come_late"); }
TEST_F(LivePageStops, AndIgnoresWhoSeesThePast) { expect("what_is_seen_comes_late"); }
TEST_F(LivePageStops, ForWhoDoesNotDrive) { expect("second_driver"); }

class LivePageLooks : public LivePage {
 protected:
  static void expect(const std::string& check) { LivePage::expect("page_checks.mjs", check); }
};

TEST_F(LivePageLooks, AtItsFirstMap) { expect("first_map"); }
TEST_F(LivePageLooks, AtEveryMotion) { expect("drawing"); }
TEST_F(LivePageLooks, AtItsSize) { expect("size"); }
TEST_F(LivePageLooks, AtFloorAndWalls) { expect("pixels"); }
TEST_F(LivePageLooks, WhereItIsSentTo) { expect("go_there"); }
TEST_F(LivePageLooks, IntoThePast) { expect("timeline"); }
TEST_F(LivePageLooks, AtACutNetwork) { expect("reconnects"); }
TEST_F(LivePageLooks, AtWhatAxeFinds) { expect("axe"); }
TEST_F(LivePageLooks, AtTheEndOfARun) { expect("ends"); }
TEST_F(LivePageLooks, AtARecording) { expect("recording"); }
TEST_F(LivePageLooks, WithoutAnError) { expect("console"); }
TEST_F(LivePageLooks, AtNoOtherHost) { expect("requests"); }

class LivePageGuards : public LivePage {
 protected:
  static void expect(const std::string& check) { LivePage::expect("access_checks.mjs", check); }
};

TEST_F(LivePageGuards, ItsSocketFromOtherPages) { expect("foreign_socket"); }
TEST_F(LivePageGuards, ItsCommandsFromOtherPages) { expect("foreign_post"); }
TEST_F(LivePageGuards, ItselfByAToken) { expect("token"); }

}  // namespace
}  // namespace echomap::live_page
