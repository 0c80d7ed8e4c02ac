#include "bank/segment.hpp"

#include <algorithm>
#include <iterator>

namespace rigsound::analysis {
namespace {

constexpr std::size_t kFewestOwn = 3;  // two gaps: of six clicks one of two segments has as many

}  // namespace

Segments learnable(const Segments& segments) {
  Segments enough;
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(enough),
               [](const DrillingSegment& s) { return s.last - s.first >= kFewestOwn; });
  return enough;
}

std::vector<int> own_onsets(const DrillingSegment& segment) {
  const std::vector<int>& P = segment.result.clicks.P;
  return {P.begin() + static_cast<long>(segment.first),
          P.begin() + static_cast<long>(std::min(segment.last + 1, P.size()))};
}

}  // namespace rigsound::analysis
