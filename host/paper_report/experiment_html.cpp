// SPDX-License-Identifier: MIT
#include "host/paper_report/experiment_html.hpp"

#include <string_view>

#include <fmt/format.h>

#include "host/paper_report/html_text.hpp"
#include "host/paper_report/png_data.hpp"

namespace echomap::paper_report {
namespace {

/// Pictures that are wider than this share of their height have a row for themselves.
constexpr double kWideRatio = 1.6;

/// A title as the beginning of a caption: with a full stop unless it ends a sentence itself.
std::string sentence_of(const std::string& title) {
  const bool has_end =
      !title.empty() && std::string_view(".?!").find(title.back()) != std::string_view::npos;
  return has_end ? title : title + ".";
}

std::string figure_html(const PaperPicture& picture, int number) {
  const auto size = png_size(picture.png);
  const bool is_wide = size && size->width_px > kWideRatio * size->height_px;
  const std::string size_attributes =
      size ? fmt::format(" width=\"{}\" height=\"{}\"", size->width_px, size->height_px) : "";
  const std::string where =
      picture.where.empty() ? "" : fmt::format(" Compare {}.", html_escaped(picture.where));
  return fmt::format(
      "<figure{}><img src=\"{}\" alt=\"{}\"{}>\n"
      "<figcaption><strong>Picture {}. {}</strong>{} {}</figcaption></figure>\n",
      is_wide ? " class=\"wide\"" : "",
      png_data_uri(picture.png),
      html_escaped(picture.title),
      size_attributes,
      number,
      html_escaped(sentence_of(picture.title)),
      where,
      html_escaped(picture.caption));
}

std::string pictures_html(const std::vector<PaperPicture>& pictures, PageNumbers& numbers) {
  if (pictures.empty()) {
    return "";
  }
  std::string html = "<div class=\"pictures\">\n";
  for (const PaperPicture& picture : pictures) {
    html += figure_html(picture, ++numbers.picture);
  }
  return html + "</div>\n";
}

std::string method_html(const std::string& heading, const std::string& text) {
  return text.empty() ? ""
                      : "<div>" + html_element("h3", heading) + html_paragraphs(text) + "</div>\n";
}

std::string methods_html(const Experiment& experiment) {
  const std::string methods = method_html("As in the paper", experiment.as_told) +
                              method_html("Our method", experiment.our_way);
  return methods.empty() ? "" : "<div class=\"methods\">\n" + methods + "</div>\n";
}

std::string measured_cell(const std::optional<Measured>& measured, const Finding& finding) {
  if (!measured) {
    return "<td class=\"none\">not measured</td>";
  }
  const bool has_interval = measured->runs > 1;
  return fmt::format("<td><strong>{}</strong><small{}>{}</small></td>",
                     html_escaped(value_text(*measured, finding.unit, finding.decimals)),
                     has_interval ? " class=\"interval\"" : "",
                     html_escaped(interval_text(*measured, finding.decimals)));
}

std::string row_html(const Finding& finding) {
  const std::string where =
      finding.where.empty()
          ? ""
          : fmt::format(" <small class=\"place\">({})</small>", html_escaped(finding.where));
  return fmt::format("<tr><th scope=\"row\">{}</th><td>{}{}</td>{}{}</tr>\n",
                     html_escaped(finding.quantity),
                     html_escaped(finding.paper),
                     where,
                     measured_cell(finding.as_told, finding),
                     measured_cell(finding.ours, finding));
}

std::string findings_html(const std::vector<Finding>& findings, PageNumbers& numbers) {
  if (findings.empty()) {
    return "";
  }
  std::string rows;
  for (const Finding& finding : findings) {
    rows += row_html(finding);
  }
  return fmt::format(
      "<h3>Results</h3>\n<div class=\"table\"><table>\n"
      "<caption><strong>Table {}.</strong> The paper's values beside ours: mean or share over the "
      "runs, and its 95 % confidence interval in brackets.</caption>\n"
      "<thead><tr><th scope=\"col\">Quantity</th><th scope=\"col\">The paper</th>"
      "<th scope=\"col\">As in the paper</th><th scope=\"col\">Our method</th></tr>"
      "</thead>\n<tbody>\n{}</tbody></table></div>\n",
      ++numbers.table,
      rows);
}

std::string answer_html(const std::string& answer) {
  return answer.empty()
             ? ""
             : "<div class=\"answer\"><h3>Answer</h3>\n" + html_paragraphs(answer) + "</div>\n";
}

/// The file of an equation with its line if that is found, as a link if sources have an address.
std::string source_html(const Equation& equation, const SourceLines& source_lines) {
  const auto line = source_lines.line(equation.file, equation.symbol);
  const std::string place =
      html_escaped(line ? fmt::format("{}:{}", equation.file, *line) : equation.file);
  const auto link = source_lines.link(equation.file);
  return line && link
             ? fmt::format("<a href=\"{}\"><code>{}</code></a>", html_escaped(*link), place)
             : fmt::format("<code>{}</code>", place);
}

std::string equations_html(const std::vector<Equation>& equations,
                           const SourceLines& source_lines) {
  if (equations.empty()) {
    return "";
  }
  std::string html =
      "<h3>Equations and where the code computes them</h3>\n<ul class=\"equations\">\n";
  for (const Equation& equation : equations) {
    html += fmt::format("<li><p><strong>{}</strong> {}</p>\n<pre>{}</pre></li>\n",
                        html_escaped(equation.name),
                        source_html(equation, source_lines),
                        html_escaped(equation.text));
  }
  return html + "</ul>\n";
}

std::string open_html(const std::vector<std::string>& open) {
  if (open.empty()) {
    return "";
  }
  std::string html = "<h3>What the paper leaves open</h3>\n<ul>\n";
  for (const std::string& question : open) {
    html += html_element("li", question);
  }
  return html + "</ul>\n";
}

}  // namespace

std::string experiment_html(const Experiment& experiment,
                            const SourceLines& source_lines,
                            PageNumbers& numbers) {
  const int number = ++numbers.experiment;
  std::string html = fmt::format(
      "<section id=\"experiment-{0}\" aria-labelledby=\"title-{0}\">\n"
      "<h2 id=\"title-{0}\">{0}. {1}</h2>\n",
      number,
      html_escaped(experiment.title));
  html += html_element("p class=\"question\"", experiment.question);
  html += pictures_html(experiment.pictures, numbers);
  html += methods_html(experiment);
  html += findings_html(experiment.findings, numbers);
  html += answer_html(experiment.answer);
  html += equations_html(experiment.equations, source_lines);
  html += open_html(experiment.open);
  return html + "</section>\n";
}

}  // namespace echomap::paper_report
