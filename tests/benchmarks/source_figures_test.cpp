// SPDX-License-Identifier: MIT
#include "tests/benchmarks/source_figures.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

/// A stand-in for the benchmark of the search.
std::filesystem::path write_program(const std::filesystem::path& path, int exit) {
  std::ofstream(path) << R"(#!/bin/sh
[ "$1" = --seeds=7 ] || exit 3
cat > "${2#--json=}" <<END
{"figures": [
 {"name": "source_alone_s", "value": 80, "unit": "s", "runs": 7, "peers": {}},
 {"name": "source_time_ratio", "value": 0.5, "unit": "", "runs": 14, "peers": {}},
 {"name": "source_time_ratio.hall", "value": 0.4, "unit": "", "runs": 7, "peers": {}},
 {"name": "none_right_percent.hall", "value": null, "unit": "%", "runs": 7, "peers": {}}]}
END
exit )" << exit << '\n';
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

TEST(SourceFigures, AreThoseOfTheBenchmarkOfTheSearch) {
  const tests::ScratchFolder folder;
  const auto figures = source_figures(7, write_program(folder / "search", 0));
  ASSERT_EQ(figures.size(), 2U) << "what it could not measure is none";
  EXPECT_EQ(figures[0].name, "source_time_ratio");
  EXPECT_EQ(figures[0].value, 0.5);
  EXPECT_EQ(figures[0].runs, 14U);
  EXPECT_EQ(figures[1].name, "source_time_ratio.hall");
}

TEST(SourceFigures, AreNoneOfABenchmarkThatFails) {
  const tests::ScratchFolder folder;
  EXPECT_THROW(source_figures(7, write_program(folder / "search", 1)), std::runtime_error);
}

}  // namespace
}  // namespace echomap::bench
