// The paper's model as the Faust compiler writes it.
#pragma once

namespace rigsound::bench {

/// 32 samples of it, struck as often as the other contestants; the last sample.
double run_faust_paper_tool();

}  // namespace rigsound::bench
