// SPDX-License-Identifier: MIT
#include "host/paper_report/report_html.hpp"

#include <fmt/format.h>

#include "host/paper_report/experiment_html.hpp"
#include "host/paper_report/html_text.hpp"
#include "host/paper_report/report_style.hpp"

namespace echomap::paper_report {
namespace {

std::string head_html(const PaperReport& report) {
  return fmt::format(
      "<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"echomap {}\">\n"
      "<title>Paper {}: {}</title>\n<style>\n{}</style>\n</head>\n",
      html_escaped(report.version),
      html_escaped(report.number),
      html_escaped(report.title),
      kReportStyle);
}

std::string header_html(const PaperReport& report) {
  return fmt::format(
      "<header>\n<p class=\"kind\">Paper {}: its experiments, repeated with echomap</p>\n"
      "<h1>{}</h1>\n{}{}</header>\n",
      html_escaped(report.number),
      html_escaped(report.title),
      html_element("p class=\"authors\"", report.authors),
      html_paragraphs(report.summary));
}

std::string contents_html(const std::vector<Experiment>& experiments) {
  if (experiments.size() < 2) {
    return "";
  }
  std::string html = "<nav aria-label=\"Experiments\">\n<ol>\n";
  int number = 0;
  for (const Experiment& experiment : experiments) {
    html += fmt::format(
        "<li><a href=\"#experiment-{}\">{}</a></li>\n", ++number, html_escaped(experiment.title));
  }
  return html + "</ol>\n</nav>\n";
}

std::string footer_html(const PaperReport& report) {
  return fmt::format(
      "<footer>\n<h2>Repeat this report</h2>\n"
      "<p>echomap {}, seed {}. The same version, command and seed give the same numbers.</p>\n"
      "<pre><code>{}</code></pre>\n"
      "<p>Intervals hold 95 % confidence: Student's t for means, Wilson's score interval for "
      "shares. <code>report.json</code> beside this page has all numbers unrounded.</p>\n"
      "</footer>\n",
      html_escaped(report.version),
      report.seed,
      html_escaped(report.command));
}

}  // namespace

std::string html_of(const PaperReport& report, const SourceLines& source_lines) {
  PageNumbers numbers;
  std::string sections;
  for (const Experiment& experiment : report.experiments) {
    sections += experiment_html(experiment, source_lines, numbers);
  }
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + head_html(report) + "<body>\n" +
         header_html(report) + contents_html(report.experiments) + "<main>\n" + sections +
         "</main>\n" + footer_html(report) + "</body>\n</html>\n";
}

}  // namespace echomap::paper_report
