// SPDX-License-Identifier: BSD-3-Clause
// The looks of a report: on a desk, in a hand, on paper.
#pragma once

#include <string_view>

namespace rouleau::campaign {

inline constexpr std::string_view report_style = R"css(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 76rem; background: #ffffff; color: #1a1a1a;
  font: 16px/1.45 system-ui, "DejaVu Sans", sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0.2em 0; }
h2 { font-size: 1.25rem; margin: 2.2rem 0 0.6rem; border-bottom: 2px solid #1a1a1a; }
h3 { font-size: 1rem; margin: 1rem 0 0.3rem; }
a { color: #004b87; }
nav a { display: inline-block; margin-right: 0.9rem; padding: 0.2rem 0; }
figure { margin: 0.6rem 0; min-width: 0; }
figure > svg { display: block; width: 100%; max-width: 42rem; height: auto; }
figure text { font-family: inherit; }
figcaption { font-size: 0.9rem; color: #404040; }
.figures { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 26rem), 1fr)); }
.tiles { display: grid; gap: 0.5rem; grid-template-columns: repeat(auto-fill, minmax(9rem, 1fr)); }
.tiles svg, .slices svg { display: block; width: 100%; max-width: 15rem; height: auto; }
.slices { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 15rem), 1fr));
  align-items: end; }
.slices svg { max-width: 22rem; }
.note { border-left: 4px solid #D55E00; background: #fff4ec; padding: 0.5rem 0.8rem; margin: 0.6rem 0; }
.wide { overflow-x: auto; }
caption { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
table { position: relative; overflow-wrap: normal; border-collapse: collapse; font-size: 0.9rem;
  font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 0.3rem 0.8rem 0.3rem 0; border-bottom: 1px solid #cccccc; vertical-align: top; }
td { white-space: nowrap; }
td:last-child { white-space: normal; min-width: 8rem; }
th { border-bottom: 2px solid #767676; vertical-align: bottom; }
dt { font-weight: 600; }
dd { margin: 0 0 0.5rem 1rem; }
pre { overflow: auto; max-height: 40rem; background: #f5f5f5; padding: 0.8rem; font-size: 0.85rem;
  white-space: pre-wrap; }
summary { cursor: pointer; padding: 0.4rem 0; font-weight: 600; }
.sign { font-size: 0.9em; }
@media (max-width: 30rem) { .tiles { grid-template-columns: repeat(auto-fill, minmax(6.5rem, 1fr)); } }
@media print {
  @page { margin: 15mm; }
  body { font-size: 10pt; max-width: none; padding: 0; }
  nav { display: none; }
  details::details-content { content-visibility: visible; display: block; block-size: auto; }
  h2 { break-after: avoid; }
  figure, tr { break-inside: avoid; }
  .wide, pre { overflow: visible; max-height: none; }
  table { font-size: 6.5pt; }
  td, th { white-space: normal; padding-right: 0.4rem; }
  .figures { grid-template-columns: 1fr 1fr; }
  .tiles { grid-template-columns: repeat(6, 1fr); }
  a { color: inherit; text-decoration: none; }
}
)css";

}  // namespace rouleau::campaign
