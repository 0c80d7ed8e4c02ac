// Learning the diesel of a rig from recordings of it.
#pragma once

#include <string>
#include <vector>

#include "rigsound/analysis/recording.hpp"
#include "rigsound/analysis/time_table.hpp"
#include "rigsound/diesel_model.hpp"
#include "rigsound/progress.hpp"

namespace rigsound::analysis {

constexpr double kSlowestDiesel_rpm = 300, kFastestDiesel_rpm = 4000;  ///< of one that runs

/// One recording of the diesel: at one speed, or with its logged speed.
struct DieselTake {
  std::string source;             ///< for messages
  std::vector<float> mono;        ///< kAnalysisRate
  int source_rate = 48000;        ///< Hz, of the file: nothing is learned above its Nyquist frequency
  double clipped = 0;             ///< share of its samples on flat tops, 0...1
  double rpm = 0;                 ///< r/min within 3 %, when there is no log; 0: to be heard
  std::vector<double> rpm_log;    ///< r/min at every sample; empty: steady
  double load = 0;                ///< 0...1
  std::vector<double> impacts_s;  ///< times of hammer impacts in it, s, ascending; empty: clean
};

constexpr double kLongestTake_s = 40;  ///< 216 cycles at 650 r/min; 100 make a good model

/// What to read of a longer recording, so that memory does not grow with it: of a steady one (`rpm` is empty)
/// the middle, else where the speed moves most; all of a shorter one. Thread: OFF.
Stretch learned_stretch(double recording_s, const TimeTable& rpm);

struct DieselSettings {
  std::string name;
  double crossover_hz = 0;  ///< Hz, 200...800; 0: where slots or grains take over best
  int order = 0;            ///< of A(z), 32...128; 0: by the bandwidth of the recordings
  int grains = 0;           ///< cycles kept per point for the high layer, 0: slots; clean recordings only
};

/// What was measured at one point.
struct LearnedPoint {
  std::string source;
  double rpm = 0, load = 0, seconds = 0;
  int cycles = 0;
  double correlation = 0;  ///< of a cycle with its template
  double synchronous = 0;  ///< share of the energy in the mean cycle
};

struct LearnedDiesel {
  DieselModel model;
  std::vector<LearnedPoint> points;
  std::vector<std::string> warnings;  ///< one line each
};

/// Tracks the crank, splits run-ups into points, joins everything in the order domain (README, A1-A11).
/// A speed that nobody gave is heard and told among the warnings. Errors: InputError naming the take: fewer
/// than 20 cycles, speed off by more than 3 %, no periodicity, a speed that cannot be heard. Thread: OFF.
LearnedDiesel learn_diesel(const std::vector<DieselTake>& takes, const DieselSettings& settings,
                           const Progress& progress = {});

/// What `model` sounds like at a speed and load, through the engine's own voice. `rpm`: r/min at every sample
/// of kAnalysisRate. Thread: OFF.
std::vector<float> play_diesel(const DieselModel& model, const std::vector<double>& rpm, double load,
                               double feed, unsigned seed, const Progress& progress = {});

/// 4-byte numbers a model is made of, grains and one-shots left out. Thread: OFF.
std::size_t parameter_count(const DieselModel& model);

}  // namespace rigsound::analysis
