// SPDX-License-Identifier: MIT
#include "tests/benchmarks/paper_reports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::Pair;
using testing::SizeIs;

TEST(PaperReports, CountRowsWithACommandAsShown) {
  const structure::PapersPage page = structure::parse_papers_page({"## 000: a robot",
                                                                   "| a | 1 | not yet | b |",
                                                                   "| a | 1 | log: `x` | b |",
                                                                   "## 001: another",
                                                                   "| a | 1 | log: `x` | b |"});
  const auto figures = feature_figures(page);
  ASSERT_THAT(figures, SizeIs(2));
  EXPECT_EQ(figures[0].value, 3.0);
  EXPECT_EQ(figures[1].value, 2.0);
}

TEST(PaperReports, CountWhatEndedWellAndLeftAPage) {
  const std::vector<MadeReport> reports{{"000", 0, true, 12.0},
                                        {"001", 0, false, 3.0},
                                        {"002", 2, false, 0.1},
                                        {"003", 1, true, 5.0}};
  const auto figures = report_figures(reports);
  ASSERT_THAT(
      figures,
      ElementsAre(Field(&Figure::name, "reports_of_5"), Field(&Figure::name, "seconds.000")));
  EXPECT_EQ(figures[0].value, 1.0);
  EXPECT_EQ(figures[1].value, 12.0);
  EXPECT_THAT(report_notes(reports),
              ElementsAre(Pair("001", "no report: exit code 0, but no report.html"),
                          Pair("002", "no report: exit code 2"),
                          Pair("003", "no report: exit code 1")));
}

}  // namespace
}  // namespace echomap::bench
