// SPDX-License-Identifier: MIT
#include "host/paper_report/html_text.hpp"

#include <sstream>

#include <fmt/format.h>

#include "host/exports/svg_elements.hpp"

namespace echomap::paper_report {

std::string html_escaped(const std::string& text) {
  std::string escaped;
  for (const char letter : exports::svg_escaped(text)) {
    switch (letter) {
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

std::string html_element(const std::string& tag, const std::string& text) {
  if (text.empty()) {
    return "";
  }
  return fmt::format("<{}>{}</{}>\n", tag, html_escaped(text), tag.substr(0, tag.find(' ')));
}

std::string html_paragraphs(const std::string& text) {
  std::string html;
  std::string paragraph;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) {
      html += html_element("p", paragraph);
      paragraph.clear();
    } else {
      paragraph += (paragraph.empty() ? "" : "\n") + line;
    }
  }
  return html + html_element("p", paragraph);
}

}  // namespace echomap::paper_report
