// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace taut::report {

/// The style sheet of the page, without its figures' (figure_style()).
inline constexpr std::string_view page_style = R"(
:root{color-scheme:light dark;--ink:#222;--quiet:#5a6067;--line:#d5d9dd;--ground:#fff;--mark:#eef3f7}
*{box-sizing:border-box}
body{margin:0 auto;padding:1.5rem 1rem 3rem;max-width:66rem;background:var(--ground);
color:var(--ink);font:1rem/1.5 system-ui,-apple-system,"Segoe UI","DejaVu Sans",sans-serif;
overflow-wrap:anywhere}
h1{font-size:1.6rem;line-height:1.25;margin:0 0 .75rem}
h2{font-size:1.15rem;margin:2rem 0 .5rem}
p{margin:.5rem 0;max-width:46rem}
.quiet,figcaption{color:var(--quiet);font-size:.9rem}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.95rem;overflow-wrap:normal}
th,td{padding:.25rem .7rem;text-align:right;border-bottom:1px solid var(--line)}
th{font-weight:600}
tbody th,thead .what{text-align:left;font-weight:400;padding-left:0}
thead th{border-bottom-color:var(--quiet);vertical-align:bottom}
thead th[colspan]{text-align:center;border-bottom-color:var(--line)}
table+table,.scroll+.scroll{margin-top:1.25rem}
.columns{display:flex;flex-wrap:wrap;gap:0 4rem}
.next{padding-left:1.6rem}
.here{background:var(--mark)}
figure{margin:1.5rem 0 0}
figure h2{margin-bottom:.25rem}
figcaption{max-width:52rem}
.drawings{display:flex;flex-wrap:wrap;gap:.5rem 1rem;align-items:flex-start;overflow-x:auto}
.drawings>div{flex:1 1 24rem;min-width:0}
.drawings>.wide{min-width:46rem}
svg{display:block;width:100%;height:auto}
@media (max-width:30rem){body{padding:1rem .75rem 2rem;font-size:.95rem}
th,td{padding:.2rem .3rem;font-size:.8rem}.next{padding-left:.6rem}.drawings>div{flex-basis:100%}}
@media print{@page{size:A4;margin:14mm}html{font-size:9.5pt}
body{max-width:none;padding:0}
.drawings{flex-wrap:nowrap;overflow:visible}.drawings>.wide{min-width:0}.drawings>div{flex-basis:0}
figure,table,.together{break-inside:avoid}h2{break-after:avoid}
*{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
)";

/// What differs on a dark ground.
inline constexpr std::string_view dark_page_style =
    ":root{--ink:#e3e5e8;--quiet:#a3abb3;--line:#3a4148;--ground:#15181b;--mark:#20272d}\n";

}  // namespace taut::report
