#include "bank/segment.hpp"

#include <algorithm>
#include <iterator>

#include "rigsound/analysis/bank_builder.hpp"

namespace rigsound::analysis {

bool has_drilling(const ChainResult& segment) {
  return segment.drilling_found && static_cast<int>(segment.clicks.P.size()) >= kFewestClicks;
}

Segments with_drilling(const Segments& segments) {
  Segments drilling;
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(drilling), has_drilling);
  return drilling;
}

}  // namespace rigsound::analysis
