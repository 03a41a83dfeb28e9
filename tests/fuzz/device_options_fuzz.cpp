// SPDX-License-Identifier: MIT
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>

#include "hil_mock/line_faults/faulty_line.hpp"
#include "hil_mock/runner/device_options.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

using echomap::fuzz::require;
namespace line_faults = echomap::line_faults;
namespace runner = echomap::runner;

void read_faults(const std::string& text) {
  try {
    const auto faults = line_faults::parse_line_faults(text);
    require(faults.loss >= 0.0 && faults.loss <= 1.0, "a share is in 0 .. 1");
  } catch (const std::invalid_argument&) {
  }
}

/// One word a line.
void read_command_line(const std::string& text) {
  std::vector<std::string> words{"echomap-mock"};
  std::istringstream lines(text);
  for (std::string word; std::getline(lines, word);) {
    words.push_back(word);
  }
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  const auto read = runner::read_device_options(static_cast<int>(arguments.size()),
                                                arguments.data(),
                                                {"echomap-mock", {"uno", "mega"}, nullptr});
  if (const int* code = std::get_if<int>(&read)) {
    require(*code == 0 || *code == 2, "a command line is right, wrong or a question");
  } else {
    const auto& options = std::get<runner::DeviceOptions>(read);
    require(options.speed > 0.0 && options.duration_s > 0.0, "time goes on");
  }
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  return {
      input_of(0, "flip=1e-4,drop=0,insert=0.5,burst=0,cut=0,loss=0.01,seed=3"),
      input_of(1, "--world=living_room\n--robot\nuno_2wd\n--seed=7\n--speed=max\n--tcp=0"),
      input_of(1, "--lockstep=/tmp/s\n--link=/tmp/r\n--start=1.0,2.0,90\n--truth=/tmp/t"),
      input_of(1, "--faults=flip=1e-4,seed=3\n--board=mega\n--duration=5\n--speed=20"),
  };
}

/// One input is the text of --faults, or a whole command line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Help and errors go to these; nobody reads them here.
  static const bool silent = [] {
    std::cout.rdbuf(nullptr);
    std::cerr.rdbuf(nullptr);
    return true;
  }();
  require(silent, "the terminal stays clean");
  if (size == 0) {
    return 0;
  }
  const std::string text = echomap::fuzz::text_of({data + 1, size - 1});
  data[0] % 2 == 0 ? read_faults(text) : read_command_line(text);
  return 0;
}
