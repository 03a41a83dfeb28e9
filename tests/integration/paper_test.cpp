// SPDX-License-Identifier: MIT
/// The reports of the papers, as a user makes them.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class Paper : public ::testing::Test {
 protected:
  Ended run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"paper", "--runs=2", "--headless"};
    arguments.push_back("--out=" + (scratch / "report").string());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Program("echomap", arguments, scratch / "log").wait();
  }

  tests::ScratchFolder scratch;
};

TEST_F(Paper, LeavesAPageWhoseEquationsLeadToTheirSourceAndKeepsIt) {
  const Ended ended = run({"000"});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("The kidnapped robot"));
  const std::string page = files::read_text_file(scratch / "report/report.html");
  EXPECT_THAT(page, HasSubstr("Jasmeet Singh"));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
  const auto report = json::parse(files::read_text_file(scratch / "report/report.json"));
  EXPECT_EQ(report["command"], "echomap paper 000 --seed 1 --runs 2");
  for (const auto& experiment : report["experiments"]) {
    EXPECT_FALSE(experiment["pictures"].empty());
    for (const auto& equation : experiment["equations"]) {
      EXPECT_TRUE(equation["line"].is_number()) << equation.dump();
    }
  }
  const Ended again = run({"000"});
  EXPECT_EQ(again.status, 2) << again.said;
  EXPECT_THAT(again.said, HasSubstr("add --force"));
}

}  // namespace
}  // namespace echomap::test
