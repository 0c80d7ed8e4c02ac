#include "report/page_frame.hpp"

#include "chart/markup_text.hpp"
#include "chart/style_sheet.hpp"

namespace rigsound::analysis {
namespace {

constexpr const char* kDocumentHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>)";

// After the colours of chart/style_sheet.hpp.
constexpr const char* kPageStyle =
    R"(body { background: var(--paper); color: var(--ink); font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif;
  max-width: 1200px; margin: 1.5em auto; padding: 0 1.5em; }
h1 { font-size: 1.6em; margin-bottom: .2em } p { margin: .3em 0 }
h2 { font-size: 1.2em; margin: 0; padding-top: 1.2em; border-top: 1px solid var(--faint) }
h2 span { float: right; font-size: .75em; font-weight: 400 } h2 span a { color: var(--grey); margin-left: .8em }
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
svg { width: 100%; height: auto; display: block } .narrow { display: none }
a:focus-visible, audio:focus-visible { outline: 2px solid var(--first); outline-offset: 2px }
.player { margin: .8em 0; display: grid; gap: .4em } .player figcaption { color: var(--grey); max-width: 60em }
.player label { display: flex; gap: .8em; align-items: center } .player span { flex: 0 0 7.2em; font-weight: 600 }
.player audio { flex: 1 1 auto; min-width: 0; max-width: 34em; height: 2.4em }
.cards tbody th { border-bottom-color: var(--faint) } .legend dl { gap: .2em 2.2em } .legend dd { max-width: 26em }
@media (max-width: 640px) {
  body { padding: 0 .8em } h1, h2, p, .cards tr { overflow-wrap: anywhere } .broad { display: none } .narrow { display: grid }
  h2 span { float: none; display: block } h2 span a { margin: 0 .8em 0 0 }
  .player label { display: block } .player audio { width: 100%; max-width: none }
  .five { grid-template-columns: 1fr 1fr }
  .cards thead { display: none } .cards tr { display: block; padding: .5em 0; border-bottom: 1px solid var(--grey) }
  .cards td, .cards tbody th { display: flex; justify-content: space-between; padding: .1em 0; border: 0 }
  .cards td[data-name]::before { content: attr(data-name); color: var(--grey) }
}
)";

}  // namespace

std::string page_start(const std::string& title, const std::string& style) {
  const std::string text = chart::markup_text(title);
  return kDocumentHead + text + " · rigsound</title>\n<style>\n" + chart::page_colours() + kPageStyle +
         chart::chart_styles() + style + "</style></head><body>\n<h1 id=\"top\">" + text + "</h1>\n";
}

}  // namespace rigsound::analysis
