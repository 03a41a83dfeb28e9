// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::paper_report {

/// Text for the content of an HTML element or for an attribute in double quotes.
std::string html_escaped(const std::string& text);

/// An element with escaped text as its content, as in `<h2>a &lt; b</h2>`; empty for an empty text.
/// `tag` is its name with its attributes.
std::string html_element(const std::string& tag, const std::string& text);

/// One `<p>` for each paragraph of a text; blank lines separate them.
std::string html_paragraphs(const std::string& text);

}  // namespace echomap::paper_report
