#include "rigsound/analysis/chain.hpp"

#include "clip_analysis.hpp"

namespace rigsound::analysis {

ChainResult run_chain(const std::vector<float>& mono, const ChainOptions& options) {
  return analyse_clip(mono, options);
}

}  // namespace rigsound::analysis
