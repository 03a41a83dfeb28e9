// SPDX-License-Identifier: MIT
#include "tests/papers/demo_run.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"

namespace echomap::papers {

nlohmann::json run_demo(std::vector<std::string> arguments, const std::filesystem::path& out) {
  arguments.insert(arguments.begin(), {"demo", "--headless", "--no-kidnap"});
  arguments.push_back("--out=" + out.string());
  const test::Ended ended = test::Program("echomap", arguments, out.string() + ".log").wait();
  // A paper's strategy ends where it always did; whether the map has all of the room is ours to
  // say.
  EXPECT_TRUE(ended.status == 0 || ended.status == test::kUnfinished) << ended.said;
  return nlohmann::json::parse(files::read_text_file(out / "summary.json"));
}

}  // namespace echomap::papers
