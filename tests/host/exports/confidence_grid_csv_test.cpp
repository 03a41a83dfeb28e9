// SPDX-License-Identifier: MIT
#include "host/exports/confidence_grid_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

TEST(ConfidenceGridCsv, BeginsAtTheTop) {
  const tests::ScratchFolder folder;
  mapping::CellField confidence({{-1, 0}, {1, 1}}, 0.05);
  confidence[confidence.index({-1, 0})] = 1.0F;
  confidence[confidence.index({1, 1})] = 12.60653F;
  write_confidence_grid_csv(folder / "grid.csv", confidence);
  const std::string text = files::read_text_file(folder / "grid.csv");
  EXPECT_THAT(text, StartsWith("# resolution_m,origin_x_m,origin_y_m,rows,columns; "));
  EXPECT_THAT(text,
              EndsWith("\n# 0.05,-0.05,0,2,3\n"
                       "0,0,12.6065\n"
                       "1,0,0\n"));
}

}  // namespace
}  // namespace echomap::exports
