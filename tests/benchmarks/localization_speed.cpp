// SPDX-License-Identifier: MIT
#include "tests/benchmarks/localization_speed.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/benchmarks/building_runs.hpp"
#include "tests/benchmarks/localization_kernels.hpp"
#include "tests/benchmarks/localization_peers.hpp"
#include "tests/benchmarks/localization_scaling.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

/// Of the same kernels, compiled for processors of that kind alone.
std::map<std::string, double> figures_on(const std::string& kind, std::size_t repetitions) {
  const tests::ScratchFolder folder;
  const auto json = folder.path() / "figures.json";
  const std::string command =
      fmt::format("'{}/bench_localization_{}' --repetitions {} --json '{}' > '{}/out'",
                  ECHOMAP_PROGRAMS,
                  kind,
                  repetitions,
                  json.string(),
                  folder.path().string());
  std::map<std::string, double> figures;
  if (std::system(command.c_str()) != 0) {
    fmt::print("{}: does not run here, skipped\n", kind);
    return figures;
  }
  const auto report = nlohmann::json::parse(std::ifstream(json));
  for (const auto& figure : report.at("figures")) {
    figures[figure.at("name")] = figure.at("value");
  }
  return figures;
}

}  // namespace

std::vector<Figure> localization_speed_figures(std::size_t repetitions) {
  const auto path = tests::real_data("global_localization/map.pgm");
  if (!std::filesystem::exists(path)) {
    fmt::print("speed: the building's map is not there, skipped\n");
    return {};
  }
  const mapping::RasterMap map = read_building(path);
  std::vector<Figure> figures = localization_kernel_figures(map, repetitions);
  const std::map<std::string, std::map<std::string, double>> peers{
      {"mrpt", mrpt_localization_figures(map, repetitions)},
      {"sse2", figures_on("sse2", repetitions)},
      {"sse4", figures_on("sse4", repetitions)}};
  for (Figure& figure : figures) {
    for (const auto& [peer, theirs] : peers) {
      const auto same = theirs.find(figure.name);
      if (same != theirs.end()) {
        figure.peers[peer] = same->second;
      }
    }
  }
  const auto scaling = localization_scaling_figures(map, repetitions);
  figures.insert(figures.end(), scaling.begin(), scaling.end());
  return figures;
}

}  // namespace echomap::bench
