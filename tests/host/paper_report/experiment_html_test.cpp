// SPDX-License-Identifier: MIT
#include "host/paper_report/experiment_html.hpp"

#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/paper_report/base64_decoder.hpp"
#include "tests/host/paper_report/sample_report.hpp"

namespace echomap::paper_report {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string html_of_sample(const SourceLines& source_lines = SourceLines(ECHOMAP_SOURCE_DIR)) {
  PageNumbers numbers;
  return experiment_html(sample_localization(), source_lines, numbers);
}

std::string without_tags(const std::string& html) {
  return std::regex_replace(html, std::regex("<[^>]*>"), "");
}

TEST(ExperimentHtml, HasEveryText) {
  const std::string html = html_of_sample();
  for (const std::string text : {"1. Where is the robot?",
                                 "Do 8 readings &amp; a map suffice?",
                                 "<p>250 particles, 8 readings at 45°.</p>\n<p>The robot turns",
                                 "KLD sampling with up to 5000 particles.",
                                 "Not with the paper&#39;s noise &lt;6 cm&gt;.",
                                 "Red: the &quot;true&quot; pose.",
                                 "<pre>p(z | x) = N(z; ẑ, σ²)\n  for z &lt; 2.5 m</pre>",
                                 "<li>The noise of the sonar.</li>",
                                 "<li>How a step ends.</li>"}) {
    EXPECT_THAT(html, HasSubstr(text));
  }
}

TEST(ExperimentHtml, HasATableWithCaptionAndHeadings) {
  const std::string html = html_of_sample();
  EXPECT_THAT(html, HasSubstr("<caption><strong>Table 1.</strong>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"col\">Our method</th>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">Position error</th>"));
}

TEST(ExperimentHtml, HasValueIntervalAndRunsInEachCell) {
  const std::string text = without_tags(html_of_sample());
  EXPECT_THAT(text,
              HasSubstr("Position errorabout 6 cm (figure 8)31.5 cm (25.0 to 38.1), 20 runs"
                        "3.0 cm (2.5 to 3.5), 20 runs"));
  EXPECT_THAT(text,
              HasSubstr("no figure given (section 4.5)not measured100 % (84 to 100), 20 runs"));
}

TEST(ExperimentHtml, EmbedsAPictureWithItsTextAndSize) {
  const std::string html = html_of_sample();
  const std::regex image(
      "<img src=\"data:image/png;base64,([^\"]+)\" "
      "alt=\"Particles after 5 steps\" width=\"4\" height=\"4\">");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(html, match, image));
  EXPECT_EQ(tests::base64_decoded(match[1].str()), sample_localization().pictures[0].png);
  EXPECT_THAT(html, HasSubstr("Picture 1. Particles after 5 steps.</strong> Compare figure 8."));
}

TEST(ExperimentHtml, EndsATitleOfAPictureOnce) {
  PageNumbers numbers;
  Experiment experiment = sample_scan();
  experiment.pictures[0].title = "Where is the robot?";
  EXPECT_THAT(experiment_html(experiment, SourceLines(ECHOMAP_SOURCE_DIR), numbers),
              HasSubstr("Picture 1. Where is the robot?</strong>"));
}

TEST(ExperimentHtml, GivesAWidePictureARowOfItsOwn) {
  PageNumbers numbers;
  const SourceLines source_lines(ECHOMAP_SOURCE_DIR);
  EXPECT_THAT(experiment_html(sample_scan(), source_lines, numbers),
              HasSubstr("<figure class=\"wide\">"));
  EXPECT_THAT(html_of_sample(), Not(HasSubstr("class=\"wide\"")));
}

TEST(ExperimentHtml, NamesFileAndLineOfAnEquation) {
  const auto line = SourceLines(ECHOMAP_SOURCE_DIR)
                        .line("host/paper_report/source_lines.hpp", "class SourceLines");
  ASSERT_TRUE(line.has_value());
  const std::string place = "host/paper_report/source_lines.hpp:" + std::to_string(*line);
  EXPECT_THAT(html_of_sample(),
              HasSubstr("<strong>equation 1</strong> <code>" + place + "</code>"));
  EXPECT_THAT(html_of_sample(SourceLines(ECHOMAP_SOURCE_DIR, "file:///src/")),
              HasSubstr("<a href=\"file:///src/host/paper_report/source_lines.hpp\"><code>" +
                        place + "</code></a>"));
}

TEST(ExperimentHtml, NamesTheFileAloneWhereTheLineIsNotFound) {
  EXPECT_THAT(html_of_sample(SourceLines(ECHOMAP_SOURCE_DIR, "file:///src/")),
              HasSubstr("resampling wheel</strong> <code>host/paper_report/absent.cpp</code>"));
}

TEST(ExperimentHtml, LeavesOutWhatIsEmpty) {
  PageNumbers numbers;
  const std::string html =
      experiment_html({.title = "Nothing"}, SourceLines(ECHOMAP_SOURCE_DIR), numbers);
  for (const std::string tag : {"<h3", "<table", "<figure", "<ul", "<p", "<div"}) {
    EXPECT_THAT(html, Not(HasSubstr(tag)));
  }
}

TEST(ExperimentHtml, ContinuesTheNumbersOfThePage) {
  PageNumbers numbers{.experiment = 4, .picture = 11, .table = 2};
  const std::string html =
      experiment_html(sample_localization(), SourceLines(ECHOMAP_SOURCE_DIR), numbers);
  EXPECT_THAT(html, HasSubstr("id=\"experiment-5\""));
  EXPECT_THAT(html, HasSubstr("Picture 12."));
  EXPECT_THAT(html, HasSubstr("Table 3."));
  EXPECT_EQ(numbers.experiment, 5);
  EXPECT_EQ(numbers.picture, 12);
  EXPECT_EQ(numbers.table, 3);
}

}  // namespace
}  // namespace echomap::paper_report
