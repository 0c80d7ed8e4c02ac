// Levels over times that people and scrapers look at, from the windows the audio thread closes.
#pragma once

#include <array>

#include "audio_report.hpp"

namespace rigsound::daemon {

/// Every block is in one window, and every window in one scrape. Thread: CT.
class Levels {
 public:
  /// The last complete window; one that was taken before does not count again: false.
  bool take(const LevelWindow& closed);

  LevelWindow recent() const;  ///< the last kRecent windows
  LevelWindow since_scrape();  ///< since the last call; the recent ones when no window came since
  std::uint32_t taken() const { return taken_; }  ///< number of the last window

 private:
  static constexpr std::size_t kRecent = 4;

  std::array<LevelWindow, kRecent> last_{};
  std::size_t next_ = 0;
  LevelWindow scraped_;
  std::uint32_t taken_ = 0;
};

}  // namespace rigsound::daemon
