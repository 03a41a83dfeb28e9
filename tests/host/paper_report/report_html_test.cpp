// SPDX-License-Identifier: MIT
#include "host/paper_report/report_html.hpp"

#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/paper_report/sample_report.hpp"

namespace echomap::paper_report {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

std::string page(const std::string& link_base = "") {
  return html_of(sample_report(), SourceLines(ECHOMAP_SOURCE_DIR, link_base));
}

/// Elements that stay open at the end of the page, or the first end tag that closes another one.
std::vector<std::string> unbalanced_elements(const std::string& html) {
  static const std::regex tag("<(/?)([a-z][a-z0-9]*)[^>]*>");
  static const std::set<std::string> void_elements{"meta", "img", "br"};
  std::vector<std::string> open;
  for (std::sregex_iterator at(html.begin(), html.end(), tag), end; at != end; ++at) {
    const std::string name = (*at)[2];
    if (void_elements.count(name) > 0) {
      continue;
    }
    if ((*at)[1].length() == 0) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return {"/" + name};
    } else {
      open.pop_back();
    }
  }
  return open;
}

TEST(HtmlOf, HasPaperExperimentsAndHowToRepeatThem) {
  const std::string html = page();
  EXPECT_THAT(html, StartsWith("<!DOCTYPE html>\n<html lang=\"en\">"));
  for (const std::string text : {"<title>Paper 000: Map Construction &amp; Localization</title>",
                                 "<h1>Map Construction &amp; Localization</h1>",
                                 "J. Singh, P. Bedi",
                                 "A robot of Lego maps a room.",
                                 "1. Where is the robot?",
                                 "2. A scan",
                                 "Picture 2. A scan of the room.",
                                 "echomap 0.1.0, seed 7.",
                                 "echomap paper 000 --seed 7 --out &lt;folder&gt;"}) {
    EXPECT_THAT(html, HasSubstr(text));
  }
}

TEST(HtmlOf, ClosesEveryElement) {
  EXPECT_THAT(unbalanced_elements(page()), IsEmpty());
  EXPECT_THAT(unbalanced_elements("<p><b></p></b>"), testing::ElementsAre("/p"));
}

TEST(HtmlOf, ReadsNothingElse) {
  const std::string html = page();
  EXPECT_THAT(html, Not(HasSubstr("http")));
  EXPECT_THAT(html, Not(HasSubstr("url(")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("<link")));
  const std::regex source("src=\"(?!data:)");
  EXPECT_FALSE(std::regex_search(html, source));
}

TEST(HtmlOf, LinksWithinThePageAndToSourcesOnly) {
  const std::regex elsewhere("href=\"(?!#experiment-|file:///src/host/)");
  EXPECT_FALSE(std::regex_search(page("file:///src"), elsewhere));
  EXPECT_THAT(page("file:///src"), HasSubstr("href=\"file:///src/host/paper_report/"));
  EXPECT_THAT(page(), Not(HasSubstr("href=\"file:")));
}

TEST(HtmlOf, ListsTheExperimentsOfMoreThanOne) {
  EXPECT_THAT(page(), HasSubstr("<a href=\"#experiment-2\">A scan</a>"));
  PaperReport report = sample_report();
  report.experiments.pop_back();
  EXPECT_THAT(html_of(report, SourceLines(ECHOMAP_SOURCE_DIR)), Not(HasSubstr("<nav")));
}

TEST(HtmlOf, IsForA4PaperAndForDarkScreens) {
  EXPECT_THAT(page(), HasSubstr("@page { size: A4; margin: 18mm; }"));
  EXPECT_THAT(page(), HasSubstr("prefers-color-scheme: dark"));
}

TEST(HtmlOf, EscapesEveryText) {
  const std::string script = "<script>&\"'";
  const Finding finding{script, script, script, measured_share(1, 2), std::nullopt, script, 0};
  const Experiment experiment{.title = script,
                              .question = script,
                              .as_told = script,
                              .our_way = script,
                              .answer = script,
                              .findings = {finding},
                              .pictures = {{script, script, script, {}}},
                              .equations = {{script, script, script, script}},
                              .open = {script}};
  const PaperReport report{.number = script,
                           .title = script,
                           .authors = script,
                           .summary = script,
                           .experiments = {experiment, experiment},
                           .version = script,
                           .command = script};
  EXPECT_THAT(html_of(report, SourceLines(ECHOMAP_SOURCE_DIR)), Not(HasSubstr("<script")));
  EXPECT_THAT(unbalanced_elements(html_of(report, SourceLines(ECHOMAP_SOURCE_DIR))), IsEmpty());
}

}  // namespace
}  // namespace echomap::paper_report
