// Where a feed pressure lies among the banks of a rod count and a rock: every bar of feed is in the sound.
#pragma once

#include <array>
#include <vector>

#include "drill/drill_input.hpp"
#include "rigsound/feed_reach.hpp"
#include "rigsound/feed_rule.hpp"
#include "rigsound/options.hpp"
#include "rigsound/sound_set.hpp"
#include "scene/click_spectra.hpp"
#include "scene/tilted_norm.hpp"
#include "scene/unrecorded_level.hpp"

namespace rigsound::scene {

class ClickSpectra;

/// What is heard at one feed pressure.
struct FeedPlace {
  drill::BankChoices banks;                               ///< and how likely an impact draws each
  std::array<const BankUse*, drill::kMaxChoices> uses{};  ///< of each of them: what it was chosen for
  drill::Trend trend;         ///< how far the sound has gone on beyond the outermost banks
  double ln_tilted_norm = 0;  ///< what the trend's tilt does to the level of the banks
  double percussion_bar = 0;  ///< percussion pressure the banks were recorded at
};

class FeedAxis {
 public:
  /// `spectra`: of a sound set that must outlive it. `string`: of the boom, an index into SoundSet::strings;
  /// -1: none. Thread: OFF.
  FeedAxis(const ClickSpectra& spectra, const SceneOptions& options, int string = -1);

  /// `rods` may lie between two counts: then so does the sound. Thread: RT.
  FeedPlace place(double feed_bar, double rods, int rock) const noexcept;

  /// Thread: OFF.
  std::vector<FeedReach> reach() const;

 private:
  struct Point {
    double feed_bar, percussion_bar;
    const BankUse* use;
  };
  /// Beyond an outermost bank.
  struct End {
    FeedLaws laws;
    TiltedNorm norm;
  };
  /// The banks of one rod count, rising in feed.
  struct Series {
    int rods;
    std::vector<Point> points;
    End below, above;
  };
  Series series_of(int rods, int rock, const ClickSpectra& spectra) const;
  void find_ends(int rock, Series& series, const ClickSpectra& spectra) const;
  void add_limits(const Point& end, const FeedLaws& laws, double last_bar, FeedReach& reach) const;
  const ClickBank& bank_of(const Point& point) const noexcept { return sounds_->banks[point.use->bank]; }
  void draw(const Point& point, double share, int rock, FeedPlace& place) const noexcept;
  void add(const Series& series, double feed_bar, int rock, double weight, FeedPlace& place) const noexcept;
  const std::vector<Series>& rock_series(int rock) const noexcept;

  const SoundSet* sounds_;
  SceneOptions options_;
  FeedPoints points_;
  UnrecordedLevel level_;
  std::vector<std::vector<Series>> rocks_;  ///< of any rock, then of each; rising in rods
};

}  // namespace rigsound::scene
