#include "levels.hpp"

namespace rigsound::daemon {

bool Levels::take(const LevelWindow& closed) {
  if (closed.number == taken_) return false;
  taken_ = closed.number;
  last_[next_] = closed;
  next_ = (next_ + 1) % kRecent;
  scraped_.add(closed);
  return true;
}

LevelWindow Levels::recent() const {
  LevelWindow sum;
  for (const LevelWindow& window : last_) sum.add(window);
  return sum;
}

LevelWindow Levels::since_scrape() {
  const LevelWindow sum = scraped_.blocks > 0 ? scraped_ : recent();
  scraped_ = {};
  return sum;
}

}  // namespace rigsound::daemon
