// SPDX-License-Identifier: MIT
// The house itself: its size, the shape of its code, what no program links, and how long a
// contributor waits.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/structure/function_lengths.hpp"
#include "tests/structure/linked_sources.hpp"
#include "tests/structure/source_tree.hpp"

namespace echomap::bench {
namespace {

using structure::SourceFile;

constexpr int kUsualFunctionLines = 35;
constexpr int kMaxFunctionLines = 70;
constexpr std::size_t kMaxFileLines = 500;

Figure count(const std::string& name, std::size_t value, const std::string& unit) {
  return {name, static_cast<double>(value), unit, 1, {}};
}

std::vector<SourceFile> product_of(const std::vector<SourceFile>& files) {
  std::vector<SourceFile> product;
  std::copy_if(files.begin(), files.end(), std::back_inserter(product), [](const auto& file) {
    return !structure::is_below(file.path, "tests");
  });
  return product;
}

std::vector<Figure> size_figures(const std::vector<SourceFile>& product) {
  std::size_t lines = 0;
  std::size_t long_files = 0;
  for (const SourceFile& file : product) {
    lines += structure::is_below(file.path, "host") ? file.lines.size() : 0;
    long_files += file.lines.size() > kMaxFileLines ? 1 : 0;
  }
  const auto program = session::program_folder() / "echomap";
  return {count("host_lines", lines, "lines"),
          count("echomap_bytes", std::filesystem::file_size(program), "B"),
          count("files_in_no_program", structure::files_in_no_program(product).size(), "files"),
          count("files_over_500_lines", long_files, "files")};
}

std::vector<Figure> function_figures(const std::vector<SourceFile>& product) {
  std::size_t functions = 0;
  std::size_t usual = 0;
  std::size_t too_long = 0;
  for (const SourceFile& file : product) {
    for (const structure::FunctionLength& function : structure::functions_in(file)) {
      ++functions;
      usual += function.lines <= kUsualFunctionLines ? 1 : 0;
      too_long += function.lines > kMaxFunctionLines ? 1 : 0;
    }
  }
  const double share = static_cast<double>(usual) / static_cast<double>(functions);
  return {{"functions_up_to_35_lines", 100.0 * share, "%", functions, {}},
          {"functions_over_70_lines", static_cast<double>(too_long), "", functions, {}}};
}

/// What `./run test` has measured; a tier that has not been run has no figure.
std::vector<Figure> tier_figures(const std::filesystem::path& folder) {
  std::vector<Figure> figures;
  for (const char* name : {"fresh_test_minutes", "quick_minutes"}) {
    if (std::filesystem::exists(folder / name)) {
      figures.push_back({name, std::stod(files::read_text_file(folder / name)), "min", 1, {}});
    } else {
      fmt::print(stderr, "no {}: not measured in this tree\n", name);
    }
  }
  return figures;
}

std::vector<Figure> figures_of() {
  const auto product = product_of(structure::read_source_tree(ECHOMAP_SOURCE_DIR));
  std::vector<Figure> figures = size_figures(product);
  const auto append = [&](const std::vector<Figure>& more) {
    figures.insert(figures.end(), more.begin(), more.end());
  };
  append(function_figures(product));
  append(tier_figures(std::filesystem::path(ECHOMAP_BINARY_DIR) / "tiers"));
  return figures;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  std::filesystem::path json;
  CLI::App app("Size and shape of the code, and waiting times of a contributor");
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::report(echomap::bench::figures_of(), json);
}
