// SPDX-License-Identifier: MIT
#include "host/paper_report/html_text.hpp"

#include <gtest/gtest.h>

namespace echomap::paper_report {
namespace {

TEST(HtmlEscaped, LeavesNoMarkup) {
  EXPECT_EQ(html_escaped("<b a=\"1\" c='2'>&amp;</b>"),
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;&lt;/b&gt;");
}

TEST(HtmlEscaped, LeavesUnicodeAsItIs) { EXPECT_EQ(html_escaped("p(z|x) ∝ σ⁻¹"), "p(z|x) ∝ σ⁻¹"); }

TEST(HtmlElement, HoldsEscapedText) {
  EXPECT_EQ(html_element("p class=\"question\"", "a < b"), "<p class=\"question\">a &lt; b</p>\n");
  EXPECT_EQ(html_element("h2", ""), "");
}

TEST(HtmlParagraphs, AreSeparatedByBlankLines) {
  EXPECT_EQ(html_paragraphs("one\nline\n \n\ntwo <i>\n"),
            "<p>one\nline</p>\n<p>two &lt;i&gt;</p>\n");
  EXPECT_EQ(html_paragraphs("\n\n"), "");
}

}  // namespace
}  // namespace echomap::paper_report
