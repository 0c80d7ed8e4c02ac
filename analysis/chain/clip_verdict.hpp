// The verdict on the windows of a clip whose clicks are known.
#pragma once

#include <string>
#include <vector>

#include "chain/dump.hpp"
#include "chain/segments.hpp"
#include "clicks/candidates.hpp"
#include "denoise/factors.hpp"
#include "denoise/word_fit.hpp"
#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

struct JudgedWindow {
  Segment window;          ///< samples of the clip; may reach beyond it
  double probability = 0;  ///< that it is drilling
  double promise = 0;      ///< that it is, as far as rough clicks tell: drilling_promise()
  std::string objections;  ///< what speaks against it
};

/// One window does. Thread: OFF.
bool drills(const std::vector<JudgedWindow>& verdict);

/// Whether it may where a neighbour drills: a window reaches kStillDrilling. Thread: OFF.
bool may_drill(const std::vector<JudgedWindow>& verdict);

/// What the search for clicks leaves.
struct SearchedClip {
  const std::vector<float>& x;  ///< as recorded
  const Candidates& candidates;
  const ClickTrain& clicks;
  const PowerSpectrogram& power;
  const Grid& background_alone;  ///< left_by_background() of it
  const Factors* factors;        ///< of step 6; null: too few clicks for it
};

/// The divergence that a slow background leaves of every cell. Thread: OFF.
Grid left_by_background(const WordFit& clip);

/// The verdict on every window; the figures behind it go into PASS_evidence.csv. Thread: OFF.
std::vector<JudgedWindow> judge(const std::vector<Segment>& windows, const SearchedClip& clip,
                                const std::string& pass, const Dump& dump);

}  // namespace rigsound::analysis
