// The style sheet of the report: light, dark and printed.
#pragma once

namespace rigsound::analysis {

constexpr const char* kPageHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>rigsound analysis report</title>
<style>
:root { color-scheme: light dark; --ink: #1b1b1f; --paper: #fff; --faint: #dcdce2; --grey: #6b6b74;
  --first: #1f66b0; --second: #a9adb8; --third: #c2410c; --onset: #15803d; --warn: #9a4a06; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8ec; --paper: #17171b; --faint: #3a3a42; --grey: #a2a2ac;
  --first: #6db1ff; --second: #6a6d79; --third: #ff9a5c; --onset: #5bd68a; --warn: #f5b04c; } }
@media print { :root { --ink: #000; --paper: #fff; --faint: #ccc; --grey: #555; --first: #1f66b0; --second: #a9adb8;
  --third: #c2410c; --onset: #15803d; --warn: #8a4207; } section { break-inside: avoid-page; } }
body { background: var(--paper); color: var(--ink); font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif;
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
section { content-visibility: auto; contain-intrinsic-size: auto 1600px; margin-bottom: 2.4em }
.one, .two, .three, .five { display: grid; gap: .5em; margin: .5em 0 }
.two { grid-template-columns: repeat(auto-fit, minmax(min(100%, 480px), 1fr)) }
.three { grid-template-columns: repeat(auto-fit, minmax(min(100%, 340px), 1fr)) }
.five { grid-template-columns: repeat(auto-fill, minmax(200px, 1fr)) }
svg { width: 100%; height: auto; display: block } image { image-rendering: pixelated }
svg text { font: 11px system-ui, "DejaVu Sans", sans-serif; fill: var(--ink) }
svg .title { font-weight: 600; font-size: 12px } svg .tick { fill: var(--grey) }
svg .x { text-anchor: middle } svg .y { text-anchor: end }
.axis { fill: none; stroke: var(--grey) } .grid { stroke: var(--faint); stroke-width: .6; opacity: .55 }
.line { fill: none; stroke-width: 1.6 } .line.onset { stroke-width: .8 }
.line.first { stroke: var(--first) } .line.second { stroke: var(--second) } .line.third { stroke: var(--third) }
.line.onset { stroke: var(--onset) } .area.first { fill: var(--first) }
svg tspan { font-weight: 600 } tspan.first { fill: var(--first) } tspan.second, tspan.quiet { fill: var(--grey) }
tspan.third { fill: var(--third) } tspan.onset { fill: var(--onset) } tspan.quiet { font-weight: 400 }
</style></head><body>
<h1 id="top">Analysis report</h1>
)";

}  // namespace rigsound::analysis
