// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace echomap::paper_report {

/// The style sheet of a report. Colours are those of exports::MapView's pictures; on paper the page
/// is always light.
constexpr std::string_view kReportStyle = R"css(
:root {
  color-scheme: light dark;
  --ink: #1b1d21; --ground: #ffffff; --faint: #5b616c; --line: #c8ccd4; --panel: #f3f5f8;
  --accent: #0072b2;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --ink: #e4e6ea; --ground: #15171b; --faint: #a4abb7; --line: #3d434e; --panel: #1f2329;
    --accent: #56b4e9;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; max-width: 50rem; padding: 2rem 1.25rem 3rem;
  background: var(--ground); color: var(--ink);
  font: 1.0625rem/1.5 Charter, "Bitstream Charter", "Source Serif 4", Georgia, "DejaVu Serif", serif;
  overflow-wrap: break-word;
}
h1, h2, h3 { line-height: 1.25; break-after: avoid; text-wrap: balance; }
h1 { font-size: 1.8em; margin: 0.2em 0 0.3em; }
h2 { font-size: 1.35em; margin: 2.2em 0 0.5em; padding-top: 0.5em; border-top: 2px solid var(--accent); }
h3 { font-size: 1.05em; margin: 1.3em 0 0.3em; }
p { margin: 0.4em 0 0.7em; orphans: 3; widows: 3; }
li { margin: 0.2em 0; }
a { color: var(--accent); }
small { font-size: 0.85em; color: var(--faint); }
small.interval, small.place { display: block; }
small.interval { white-space: nowrap; }
code { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: 0.85em; }
.kind, .authors { color: var(--faint); margin: 0; }
.authors { margin-bottom: 1em; }
.question { font-size: 1.1em; font-style: italic; }
.methods { display: grid; grid-template-columns: repeat(auto-fit, minmax(17rem, 1fr)); column-gap: 2rem; }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 1.2rem; margin: 1rem 0; align-items: start; }
figure { margin: 0; break-inside: avoid; }
figure.wide, figure:only-child { grid-column: 1 / -1; }
figure img {
  display: block; max-width: 100%; max-height: 85vh; width: auto; height: auto;
  background: #ffffff; border: 1px solid var(--line);
}
figcaption { font-size: 0.9em; line-height: 1.4; margin-top: 0.4em; }
.table { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 0.94em; line-height: 1.35; }
caption { text-align: left; font-size: 0.95em; margin-bottom: 0.5em; break-after: avoid; }
thead { display: table-header-group; }
tr { break-inside: avoid; }
th, td { text-align: left; vertical-align: top; padding: 0.4em 0.8em 0.4em 0; border-bottom: 1px solid var(--line); }
th:last-child, td:last-child { padding-right: 0; }
thead th { vertical-align: bottom; border-bottom: 2px solid var(--ink); width: 24%; }
thead th:first-child { width: 30%; }
tbody th { font-weight: normal; }
td { font-variant-numeric: tabular-nums; }
td.none { color: var(--faint); }
.answer {
  margin: 1.3em 0; padding: 0.5em 1em; break-inside: avoid;
  background: var(--panel); border-left: 4px solid var(--accent);
}
.answer h3 { margin-top: 0.2em; }
.answer > :last-child { margin-bottom: 0.2em; }
.equations { list-style: none; padding: 0; }
.equations li { margin: 0 0 0.9em; break-inside: avoid; }
.equations p { margin: 0; }
.equations p code { overflow-wrap: anywhere; }
pre {
  margin: 0.3em 0; padding: 0.5em 0.8em; white-space: pre-wrap;
  background: var(--panel); border-left: 4px solid var(--line);
}
.equations pre { font-family: "STIX Two Math", "Cambria Math", "DejaVu Serif", serif; }
footer { margin-top: 3em; font-size: 0.95em; }
@media screen and (max-width: 36rem) {
  .pictures { grid-template-columns: 1fr; }
  small.interval { white-space: normal; }
}
@page { size: A4; margin: 18mm; }
@page { @bottom-center { content: counter(page); font: 9pt serif; } }
@media print {
  :root { color-scheme: light; }
  body { font-size: 11pt; line-height: 1.4; max-width: none; padding: 0; }
  a { text-decoration: none; color: inherit; }
  figure img { max-height: 110mm; }
  .table { overflow: visible; }
  .methods { grid-template-columns: 1fr 1fr; break-inside: avoid; }
  footer { break-inside: avoid; }
}
)css";

}  // namespace echomap::paper_report
