// SPDX-License-Identifier: MIT
// How fast the live page of whole programs is in a real browser, and how fast it stops a robot.
// tests/live_page/figures.mjs measures.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/session/temporary_folder.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/structure/shell.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;
using structure::shell_quoted;

constexpr const char* kPackages = ECHOMAP_LIVE_PAGE_PACKAGES;

struct Options {
  int trials = 20;
  std::vector<std::string> parts;
  fs::path json;
};

std::vector<Figure> measure(const Options& options) {
  if (!fs::exists(fs::path(kPackages) / "installed") || !fs::exists(ECHOMAP_CHROMIUM)) {
    throw std::runtime_error("no chromium, no node 20, no npm, or npm's packages are not here");
  }
  const session::TemporaryFolder folder;
  const fs::path list = folder / "figures.json";
  const auto result = structure::run_shell(
      fmt::format("ECHOMAP_PROGRAMS={} ECHOMAP_CHROMIUM={} node figures.mjs {} {} {}",
                  shell_quoted(ECHOMAP_PROGRAMS),
                  shell_quoted(ECHOMAP_CHROMIUM),
                  shell_quoted(list.string()),
                  options.trials,
                  fmt::join(options.parts, " ")),
      kPackages);
  fmt::print(stderr, "{}", result.output);
  if (result.exit_code != 0) {
    throw std::runtime_error("the figures could not be measured");
  }
  std::vector<Figure> figures;
  for (const auto& figure : nlohmann::json::parse(files::read_text_file(list))) {
    figures.push_back({figure.at("name"),
                       figure.at("value").get<double>(),
                       figure.at("unit"),
                       figure.at("runs").get<std::size_t>(),
                       {}});
  }
  return figures;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::bench::Options options;
  CLI::App app("How fast the live page is in a browser, and how fast it stops a robot");
  app.add_option("--trials", options.trials, "Press STOP so often, and a quarter of it all else")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--part", options.parts, "Only these figures")
      ->check(CLI::IsMember({"page", "looks", "large", "stops", "clients"}));
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  try {
    echomap::bench::report(echomap::bench::measure(options), options.json);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
