// The paper's model as a user of the Synthesis ToolKit would put it together.
#pragma once

namespace rigsound::bench {

/// 32 samples of it, struck as often as the other contestants; the last sample.
double run_stk_paper_tool();

}  // namespace rigsound::bench
