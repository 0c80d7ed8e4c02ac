// The style sheet of the report: light, dark and printed.
#pragma once

namespace rigsound::analysis {

constexpr const char* kPageStart = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>rigsound analysis report</title>
<style>
)";

// After the colours of chart/style_sheet.hpp.
constexpr const char* kPageStyle =
    R"(body { background: var(--paper); color: var(--ink); font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif;
  max-width: 1200px; margin: 1.5em auto; padding: 0 1.5em; }
h1 { font-size: 1.6em; margin-bottom: .2em } p { margin: .3em 0 }
h2 { font-size: 1.2em; margin: 0; padding-top: 1.2em; border-top: 1px solid var(--faint) }
h2 a { float: right; font-size: .75em; font-weight: 400; color: var(--grey) }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums }
th, td { text-align: left; padding: .25em .6em; border-bottom: 1px solid var(--faint); vertical-align: top }
th { font-weight: 600; border-bottom-color: var(--grey) } th small { display: block; font-weight: 400; color: var(--grey) }
td.n, th.n { text-align: right } .warn { color: var(--warn) } .quiet { color: var(--grey) }
p.warn::before { content: "⚠ " } a { color: inherit } .wide { overflow-x: auto }
dl { display: flex; flex-wrap: wrap; gap: .3em 1.6em; margin: .5em 0; font-variant-numeric: tabular-nums }
dl div { display: flex; gap: .45em } dt { color: var(--grey) } dd { margin: 0 }
@media print { section { break-inside: avoid-page } }
section { content-visibility: auto; contain-intrinsic-size: auto 1600px; margin-bottom: 2.4em }
.one, .two, .three, .five { display: grid; gap: .5em; margin: .5em 0 }
.two { grid-template-columns: repeat(auto-fit, minmax(min(100%, 480px), 1fr)) }
.three { grid-template-columns: repeat(auto-fit, minmax(min(100%, 340px), 1fr)) }
.five { grid-template-columns: repeat(auto-fill, minmax(200px, 1fr)) }
svg { width: 100%; height: auto; display: block }
)";

constexpr const char* kPageTop = R"(</style></head><body>
<h1 id="top">Analysis report</h1>
)";

}  // namespace rigsound::analysis
