#include "chain/clip_verdict.hpp"

#include <algorithm>
#include <vector>

#include "clicks/click_fit.hpp"
#include "clicks/click_likeness.hpp"
#include "clicks/drilling_test.hpp"
#include "clicks/gaps.hpp"
#include "clicks/heard_band.hpp"
#include "clicks/repetition.hpp"
#include "clicks/rhythm.hpp"
#include "clicks/selection.hpp"
#include "denoise/cs_nmf.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/chain.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kQuarter = 0.25;  // of the bins: a codec empties cells of most, but hardly any of these

ClickTrain clicks_in(const Segment& window, const ClickTrain& clicks) {
  ClickTrain inside = clicks;
  inside.P.clear(), inside.beta.clear();
  for (std::size_t i = 0; i < clicks.P.size(); ++i) {
    if (clicks.P[i] < window.begin || clicks.P[i] >= window.end) continue;
    inside.P.push_back(static_cast<int>(clicks.P[i] - window.begin));
    inside.beta.push_back(clicks.beta[i]);
  }
  if (inside.P.size() >= kFewestFitted) inside.mean_gap_samples = median_gap(inside.P);
  return inside;
}

/// A rate may glide from window to window, and a window of few clicks know it less well than its clip.
const Selection& clearer(const Selection& own, const Selection& of_clip) {
  return own.surplus > of_clip.surplus ? own : of_clip;
}

/// Of one window alone, as far as the clip holds it.
DrillingEvidence evidence_in(const Segment& whole, const SearchedClip& clip, const Grid& with_clicks) {
  const Segment window{std::max(0L, whole.begin), std::min(static_cast<long>(clip.x.size()), whole.end)};
  DrillingEvidence e;
  e.clicks = clicks_in(window, clip.clicks);
  if (e.clicks.P.size() < kFewestFitted) return e;
  const Candidates candidates =
      candidates_between(clip.candidates, window.begin / kCandidateBlock, window.end / kCandidateBlock);
  const Selection chain =
      clearer(select_at_period(candidates, e.clicks.mean_gap_samples / kCandidateBlock),
              select_at_period(candidates, clip.clicks.mean_gap_samples / kCandidateBlock));
  e.total = chain.total;
  e.surplus = chain.surplus;
  e.fast_total = fast_total(candidates, e.clicks);
  e.irregularity = irregularity(e.clicks);
  e.jitter = jitter(e.clicks);
  e.strength_rhythm = strength_rhythm(e.clicks.beta, {e.clicks.P.begin(), e.clicks.P.end()});
  const Eigen::Map<const Eigen::ArrayXf> x(clip.x.data(), static_cast<long>(clip.x.size()));
  e.repetition = repetition(x.segment(window.begin, window.end - window.begin), e.clicks);
  const int first = static_cast<int>(window.begin / kChainStft.hop),
            last = std::min(static_cast<int>(window.end / kChainStft.hop) + 1, clip.power.frames);
  const PowerSpectrogram power = frames_between(clip.power, first, last);
  const ClickFrames clicks = click_frames(e.clicks, power.frames);
  const long heard = heard_bins(power, clicks);
  e.likeness = click_likeness(power, clicks, heard);
  const Eigen::ArrayXf near = frames_near_clicks(e.clicks, power.frames);
  e.background_alone =
      divergence_by_bin(power, clip.background_alone.middleCols(first, power.frames), near, heard).mean();
  const Eigen::ArrayXd left =
      divergence_by_bin(power, with_clicks.middleCols(first, power.frames), near, heard);
  e.with_clicks = left.mean();
  e.left_over = quantile(std::vector<double>(left.begin(), left.end()), kQuarter);
  return e;
}

constexpr char kEvidenceHeader[] =
    "begin_s,end_s,probability,clicks,total,chance_surplus,fast_total,gap_irregularity,gap_jitter,likeness,"
    "band_rise,bar_rhythm,strength_rhythm,waveform_repetition,background_alone,with_clicks,left_over,"
    "rate,swell,surplus,pulses,dispersion,rise,rhythm,irregularity,unexplained,repetition";

/// Figures and, by their names, the weights against drilling that come of them.
std::vector<double> evidence_row(const JudgedWindow& judged, const DrillingEvidence& e) {
  std::vector<double> row = {static_cast<double>(judged.window.begin) / kAnalysisRate,
                             static_cast<double>(judged.window.end) / kAnalysisRate,
                             judged.probability,
                             static_cast<double>(e.clicks.P.size()),
                             e.total,
                             e.surplus,
                             e.fast_total,
                             e.irregularity,
                             e.jitter,
                             e.likeness.dispersion,
                             e.likeness.rise,
                             e.likeness.rhythm,
                             e.strength_rhythm,
                             e.repetition,
                             e.background_alone,
                             e.with_clicks,
                             e.left_over};
  const auto weights = objection_weights(e);
  row.insert(row.end(), weights.begin(), weights.end());
  return row;
}

void dump_evidence(const Dump& dump, const std::string& pass, const std::vector<std::vector<double>>& rows) {
  Eigen::ArrayXXd table(static_cast<long>(rows.size()), static_cast<long>(rows.front().size()));
  for (long i = 0; i < table.rows(); ++i)
    table.row(i) = Eigen::Map<const Eigen::ArrayXd>(rows[i].data(), table.cols()).transpose();
  dump.table(pass + "_evidence", kEvidenceHeader, table);
}

bool reaches(double probability, const std::vector<JudgedWindow>& verdict) {
  return std::any_of(verdict.begin(), verdict.end(),
                     [=](const JudgedWindow& w) { return w.probability >= probability; });
}

}  // namespace

bool drills(const std::vector<JudgedWindow>& verdict) { return reaches(kDrillingProbability, verdict); }

bool may_drill(const std::vector<JudgedWindow>& verdict) { return reaches(kStillDrilling, verdict); }

Grid left_by_background(const WordFit& clip) { return itakura_saito(clip.power(), background_nmf(clip)); }

std::vector<JudgedWindow> judge(const std::vector<Segment>& windows, const SearchedClip& clip,
                                const std::string& pass, const Dump& dump) {
  Grid with_clicks;
  if (clip.factors) with_clicks = itakura_saito(clip.power, *clip.factors);
  std::vector<JudgedWindow> verdict;
  std::vector<std::vector<double>> rows;
  for (const Segment& window : windows) {
    const DrillingEvidence e = evidence_in(window, clip, with_clicks);
    verdict.push_back({window, drilling_probability(e), drilling_promise(e), objections_to(e)});
    rows.push_back(evidence_row(verdict.back(), e));
  }
  if (!rows.empty()) dump_evidence(dump, pass, rows);
  return verdict;
}

}  // namespace rigsound::analysis
