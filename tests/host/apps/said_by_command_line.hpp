// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/apps/command_line.hpp"
#include "host/console/exit_code.hpp"

namespace echomap::apps {

/// How a command line ended and what it said.
struct Said {
  console::ExitCode code;
  std::string out;
  std::string err;
};

/// Runs `echomap` with these words.
inline Said run(std::vector<std::string> words) {
  words.insert(words.begin(), "echomap");
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const console::ExitCode code = run_command_line(static_cast<int>(words.size()), arguments.data());
  return {code, ::testing::internal::GetCapturedStdout(), ::testing::internal::GetCapturedStderr()};
}

}  // namespace echomap::apps
