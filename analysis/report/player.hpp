// The sound of a bank in its page.
#pragma once

#include <string>
#include <vector>

namespace rigsound::analysis {

constexpr double kHeard_s = 3;  ///< of each sound, at most

/// Of one stretch of time, at kAnalysisRate.
struct HeardSounds {
  std::vector<float> recorded, drilling;
  std::vector<float> synthesised;  ///< by the bank; of any other time
  double start_s = 0;              ///< of the first two, in the recording
};

/// Three FLAC sounds under one another. Recorded and drilling have one gain, because the one is a part of the
/// other; the synthesised is brought to the mean level of the drilling; gains are told. Needs kPlayerScript
/// in the page, once. Thread: OFF.
std::string player(const HeardSounds& sounds);

/// One sound at a time, and the next goes on where the last one was; 1, 2 and 3 choose.
constexpr const char* kPlayerScript = R"(<script>
for (const player of document.querySelectorAll('.player')) {
  const takes = [...player.querySelectorAll('audio')];
  let at = 0;
  for (const take of takes) {
    take.addEventListener('play', () => {
      for (const other of takes) {
        if (other === take) continue;
        if (!other.paused) at = other.currentTime;
        other.pause();
      }
      if (Math.abs(take.currentTime - at) > 0.02) take.currentTime = at;
    });
    take.addEventListener('timeupdate', () => { if (!take.paused) at = take.currentTime; });
    take.addEventListener('seeking', () => { at = take.currentTime; });
  }
  player.addEventListener('keydown', event => {
    const take = takes[event.key - 1];
    if (take) { take.focus(); take.play(); }
  });
}
</script>
)";

}  // namespace rigsound::analysis
