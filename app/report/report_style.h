// The style sheet of report.html: light and dark as the reader's system is, for screens of any width
// and for paper.
#pragma once

namespace quicksand {

constexpr const char* kReportStyle = R"css(
:root {
  color-scheme: light dark;
  --page: #ffffff; --ink: #1b1f24; --faint: #5b6470; --rule: #d9dde2; --stripe: #f5f7f9;
  --link: #00588c; --inside: #00664b; --outside: #a83f00; --undecided: #5b6470;
  --note: #eef4f9; --warning: #fdf1e3;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14171c; --ink: #e3e7ec; --faint: #98a2ae; --rule: #343b44; --stripe: #1b2027;
    --link: #7cc0ee; --inside: #4fd0a5; --outside: #ff9b66; --undecided: #98a2ae;
    --note: #1b2a37; --warning: #362a1c;
  }
  /* Turns a white plot dark and keeps its hues. */
  img.plot { filter: invert(0.91) hue-rotate(180deg); }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 1.5rem 1rem 4rem; max-width: 66rem;
  background: var(--page); color: var(--ink);
  font: 1rem/1.55 system-ui, "Segoe UI", Roboto, Helvetica, Arial, sans-serif;
}
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0.5rem 0 1rem; }
h2 { font-size: 1.35rem; margin: 2.5rem 0 0.75rem; padding-top: 0.5rem; border-top: 1px solid var(--rule); }
h1, h2, p, li, figcaption, td, th { overflow-wrap: break-word; }
a { color: var(--link); }
nav { border-left: 3px solid var(--rule); padding-left: 1rem; margin: 1.25rem 0; }
nav ul { list-style: none; margin: 0; padding: 0; }
figure { margin: 1.5rem 0; }
figure img { display: block; width: 100%; height: auto; }
figcaption, caption, .caption { color: var(--faint); font-size: 0.9rem; text-align: left; }
figcaption { margin-top: 0.4rem; }
caption { padding-bottom: 0.4rem; }
.gallery { display: flex; flex-wrap: wrap; gap: 0.75rem; }
.gallery figure { flex: 1 1 15rem; margin: 0; }
.wide { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: 0.92rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.3rem 0.7rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule); }
thead th { border-bottom: 2px solid var(--faint); vertical-align: bottom; }
tbody tr:nth-child(even) { background: var(--stripe); }
td:not(.number) { min-width: 6.5rem; }
.number { text-align: right; white-space: nowrap; }
.inside { color: var(--inside); font-weight: 600; }
.outside { color: var(--outside); font-weight: 600; }
.undecided { color: var(--undecided); font-style: italic; }
.remark { padding: 0.6rem 1rem; border-left: 4px solid var(--link); background: var(--note); }
.warning { border-left-color: var(--outside); background: var(--warning); }
pre { overflow-x: auto; padding: 0.75rem 1rem; background: var(--stripe); border: 1px solid var(--rule); font-size: 0.85rem; }
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; }
  nav, .files { display: none; }
  figure, tr, .remark { break-inside: avoid; }
  h2 { break-after: avoid; }
  .wide { overflow: visible; }
}
)css";

}  // namespace quicksand
