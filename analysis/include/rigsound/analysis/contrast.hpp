// Can the situations of a rig be told apart by ear, and from which feed pressure on?
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "rigsound/config/rig.hpp"
#include "rigsound/feed_rule.hpp"

namespace rigsound::analysis {

constexpr double kToldRight =
    0.75;  ///< share of excerpts from which on a difference counts as heard; chance is 1/2
constexpr double kFloors = 2;  ///< a distance counts from so many times that of two runs of one sound on

/// What the drill is told.
struct DrillSetting {
  double feed_bar = 0;
  Rattling rattling = Rattling::kNone;
  int rods = 1;
  int rock = 0;  ///< index into SoundSet::rocks
};

struct ContrastSubject {
  std::string name;                ///< for people
  std::vector<std::string> banks;  ///< that serve it; empty: not said
  DrillSetting setting;
};

struct ContrastPlan {
  std::filesystem::path sound_set;  ///< for messages
  SceneOptions scene;
  scene::FeedPoints points;                  ///< where the situations stand
  double lowest_bar = 0, highest_bar = 0;    ///< of the feed
  std::vector<ContrastSubject> situations;   ///< in the order of Situation
  std::vector<ContrastSubject> rods, rocks;  ///< at normal feed; empty: nothing that tells them apart
};

/// At kAnalysisRate.
struct RenderedSound {
  std::vector<float> all;  ///< what is heard
  std::vector<float>
      drill;  ///< of it the drill alone, whose impacts are counted; empty: there is nothing else
};

/// `seconds` of a setting. Called from several threads at once.
using RenderSound =
    std::function<RenderedSound(const DrillSetting& setting, double seconds, std::uint64_t seed)>;

struct ContrastOptions {
  double seconds = 20;  ///< of each run, 4 at least
  int runs = 4;         ///< of each setting, with different seeds, 2 at least
  std::uint64_t seed = 1;
  int jobs = 1;
  double full_scale_db_spl = 100;  ///< at the listener's ear, of a sine of full scale
};

struct SubjectFigures {
  ContrastSubject subject;
  double rate_hz = 0, loudness_sone = 0, loudness_phon = 0;
};

/// Two subjects: means over pairs of runs, and the same between runs of one of them (the floor).
struct PairFigures {
  std::size_t first = 0, second = 0;
  double third_octave_db = 0, third_octave_floor_db = 0;  ///< mean absolute difference of 25 levels
  double modulation_db = 0, modulation_floor_db = 0;      ///< the same of the envelope's spectrum, 1...256 Hz
  double rate = 0, rate_floor = 0;                        ///< difference of impacts a second over their mean
  double phon = 0;   ///< loudness level of the second less that of the first
  double right = 0;  ///< share of one-second excerpts that a listener tells right

  bool above_floor() const;
  bool told_apart() const { return right >= kToldRight && above_floor(); }
};

struct SubjectGroup {
  std::vector<SubjectFigures> subjects;
  std::vector<PairFigures> pairs;  ///< every subject with every later one
};

/// One feed pressure against normal.
struct FeedFigures {
  double feed_bar = 0;
  double third_octave_db = 0, modulation_db = 0;
  double rate_hz = 0, loudness_sone = 0, loudness_phon = 0;
  int right = 0, of = 0;  ///< one-second excerpts; none at normal itself
};

/// From how far away of normal on a feed pressure is heard: kToldRight on a curve
/// 1/2 + 0.49 (1 - exp(-(away / scale)^slope)).
struct Reach {
  bool found = false;                              ///< within the feed's range
  double away_bar = 0, low_bar = 0, high_bar = 0;  ///< and the interval of 95 %
  double scale_bar = 0, slope = 0;
};

struct Contrast {
  ContrastPlan plan;
  ContrastOptions options;
  SubjectGroup situations, rods, rocks;
  std::vector<FeedFigures> feed;  ///< rising
  double floor_db = 0;            ///< third-octave distance of two runs of normal
  Reach under, over;
};

/// The plan of boom `boom` of a rig and what renders it: the whole rig with the diesel at `engine_rpm` (0:
/// off), other booms off, channels together, after the first seconds. Errors: InputError. Thread: OFF.
struct ContrastRig {
  ContrastPlan plan;
  RenderSound render;
};
ContrastRig contrast_rig(config::Rig rig, std::size_t boom, double engine_rpm);

/// Renders and compares; `progress(done, total)` is called from one thread at a time. Thread: OFF.
Contrast measure_contrast(const ContrastPlan& plan, const ContrastOptions& options, const RenderSound& render,
                          const std::function<void(int done, int total)>& progress);

/// "a", "a and b", "a, b and 4 more"; "" for none. Thread: OFF.
std::string bank_list(const ContrastSubject& subject);

/// What it comes to, one sentence each: overfeed, underfeed, then the situations. Thread: OFF.
std::vector<std::string> contrast_verdicts(const Contrast& contrast);

/// What a trainee would fail for, one line each, the sound set named. Thread: OFF.
std::vector<std::string> contrast_warnings(const Contrast& contrast);

/// Writes one self-contained HTML page: verdicts, pairs, curves over the feed, how it was measured.
/// Errors: DeviceError. Thread: OFF.
void write_contrast_page(const std::filesystem::path& path, const Contrast& contrast);

}  // namespace rigsound::analysis
