// SPDX-License-Identifier: MIT
#include "tests/benchmarks/source_figures.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"
#include "host/session/temporary_folder.hpp"

namespace echomap::bench {
namespace {

constexpr std::array kNames{
    "source_time_ratio", "sharing_saving_percent", "none_right_percent", "claims_right_percent"};
constexpr std::chrono::hours kPatience(12);

bool is_wanted(const std::string& name) {
  const std::string without_world = name.substr(0, name.find('.'));
  return std::ranges::find(kNames, without_world) != kNames.end();
}

}  // namespace

std::vector<Figure> source_figures(std::uint32_t seeds, const std::filesystem::path& program) {
  const session::TemporaryFolder folder;
  const auto report = folder / "figures.json";
  const auto log = folder / "log";
  session::ChildProcess benchmark(
      {program.empty() ? session::program_folder() / "bench_source_search" : program,
       "--seeds=" + std::to_string(seeds),
       "--json=" + report.string()},
      log);
  if (benchmark.wait_for(kPatience) != 0) {
    throw std::runtime_error("the search of a source did not end well:\n" +
                             files::read_text_file(log));
  }
  std::vector<Figure> figures;
  const auto all = nlohmann::json::parse(files::read_text_file(report));
  for (const auto& figure : all.at("figures")) {
    const auto name = figure.at("name").get<std::string>();
    if (is_wanted(name) && figure.at("value").is_number()) {
      figures.push_back({name,
                         figure.at("value").get<double>(),
                         figure.at("unit").get<std::string>(),
                         figure.at("runs").get<std::size_t>(),
                         {}});
    }
  }
  return figures;
}

}  // namespace echomap::bench
