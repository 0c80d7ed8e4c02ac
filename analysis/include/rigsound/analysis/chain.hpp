// The whole path from a noisy recording to a denoised one and its clicks.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "rigsound/analysis/click_train.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/analysis/samples.hpp"

namespace rigsound::analysis {

enum class Method { kClickNmf, kPaper };

struct ChainOptions {
  Method method = Method::kClickNmf;
  bool denoise = true;         ///< false: the recording is taken as clean
  bool labelled = false;       ///< a person says that it drills: what speaks against it is a doubt
  int machine = 0;             ///< of several in a recording, 1 the loudest; 0: all of them together
  unsigned seed = 0;           ///< of the random start of the factorisation
  std::filesystem::path dump;  ///< folder for intermediate signals; empty: none
  int jobs = 1;  ///< threads for the segments of a long recording; the result is the same for any number
  std::function<void(int done, int total)>
      progress;  ///< after each segment, from any of the threads but one at a time
};

/// How likely a stretch of a recording holds percussive drilling.
struct VerdictWindow {
  double start_s = 0, end_s = 0;
  double probability = 0;
};

constexpr double kVerdictWindow_s = 2, kVerdictHop_s = 1;
constexpr double kDrillingProbability = 0.5;  ///< from here on a window counts as drilling
constexpr double kStillDrilling = 0.2;        ///< from here on it does beside one that counts

/// One of the machines that strike in a recording at rates of their own.
struct Machine {
  double rate_hz = 0;
  std::size_t clicks = 0;
  double level_db = 0;  ///< of its drilling over the whole recording, dB re full scale
};

struct ChainResult {
  bool drilling_found = false;
  std::string reason;                  ///< why not, when nothing was found; of a labelled recording the doubt
  std::vector<VerdictWindow> verdict;  ///< over time
  ClickTrain clicks;                   ///< from the first to the last window that counts
  std::vector<Machine> machines;       ///< of the recording, the loudest first; empty for a single segment
  std::vector<int> struck_by;          ///< machine of each click, from 1 on; empty where only one is meant
  Samples drilling;                    ///< the recording without its background, same length and level
  std::vector<double> signal_psd;      ///< mean modelled power of the drilling, per STFT bin (257 bins)
  std::vector<double> noise_psd;       ///< the same for the background
  std::vector<double> output_psd;      ///< mean power of the denoised output, same bins
};

/// A segment in which drilling was found, analysed for itself: with its own envelope, powers and whitening.
struct DrillingSegment {
  long begin = 0;                   ///< first sample, in the recording
  std::size_t first = 0, last = 0;  ///< clicks first ... last - 1 count here, the others in a neighbour
  ChainResult result;               ///< times from `begin` on, overlaps with the neighbours included
};

/// A recording as a whole, without its sound, and in its segments. The clicks of `joined` are those that
/// count in `drilling`: of windows that drill. Of a labelled recording in which none does, all segments with
/// enough clicks count.
struct SegmentedResult {
  ChainResult joined;
  int segments = 0;                       ///< with and without drilling
  std::vector<DrillingSegment> drilling;  ///< in the order of time
};

/// Stretches of drilling; neighbouring windows that drill are one. Thread: OFF.
std::vector<Stretch> drilling_stretches(const std::vector<VerdictWindow>& verdict);

/// "machine 1: 21.0 Hz, 84 clicks; machine 2: 34.2 Hz, 136 clicks"; empty for one. Thread: OFF.
std::string machines_text(const std::vector<Machine>& machines);

/// "drilling in 2.0-6.0, 9.0-12.0 of 20.0 s"; empty where it is everywhere or nowhere. Thread: OFF.
std::string stretches_text(const std::vector<VerdictWindow>& verdict);

/// Runs denoising and click detection on `mono` (48 kHz, full scale 1). More than 4 s are analysed in
/// overlapping segments of 2 to 4 s, whose sound is kept in `file`: memory does not grow with the recording.
/// Of several machines the one meant counts, with `machine` 0 the loudest; the others are background to it.
/// Deterministic. Errors: DeviceError when the dump or the file cannot be written. Thread: OFF.
SegmentedResult run_chain_in_segments(const Samples& mono, SampleFile& file, const ChainOptions& options);

/// The same in memory; `joined` has its sound, with `machine` 0 of all machines.
SegmentedResult run_chain_in_memory(const Samples& mono, const ChainOptions& options);
ChainResult run_chain(const Samples& mono, const ChainOptions& options);

}  // namespace rigsound::analysis
