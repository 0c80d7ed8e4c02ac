#include "rigsound/log/log_clock.hpp"

#include <algorithm>
#include <cstdlib>

namespace rigsound::log {
namespace {

constexpr std::int64_t kMilli = 1'000'000, kSecond = 1'000 * kMilli;
constexpr std::int64_t kLate_ns = 50 * kMilli;               // what sources differ by
constexpr std::int64_t kLongestPause_ns = 86'400 * kSecond;  // more was no pause, but the clock
constexpr std::int64_t kFirstGap_ns = kMilli;                // where no two entries tell
constexpr std::int64_t kLong_ns = 3'600 * kSecond;           // worth a word
constexpr std::int64_t kEnd_ns = 9'000'000'000 * kSecond;

double seconds(std::int64_t ns) { return static_cast<double>(ns) * 1e-9; }

std::string times(std::uint64_t count) {
  return count == 1 ? "" : " (and " + std::to_string(count - 1) + " times more)";
}

}  // namespace

LogClock::LogClock(std::optional<double> longest_gap_s) : usual_gap_ns_(kFirstGap_ns) {
  if (longest_gap_s) longest_gap_ns_ = static_cast<std::int64_t>(*longest_gap_s * 1e9);
}

void LogClock::Events::add(int at_line, double size_s) {
  if (count++ > 0) return;
  line = at_line;
  first_s = size_s;
}

std::int64_t LogClock::place(std::int64_t stamp_ns, std::optional<std::int64_t> next_ns, int line) {
  if (last_stamp_ns_)
    now_ns_ = std::min(now_ns_ + gap_to(stamp_ns, next_ns, line), kEnd_ns);
  else
    last_stamp_ns_ = stamp_ns;
  return now_ns_;
}

/// Sets last_stamp_ns_ to what the stamp should have been, so that the next gap counts from there.
std::int64_t LogClock::gap_to(std::int64_t stamp_ns, std::optional<std::int64_t> next_ns, int line) {
  const std::int64_t last_ns = *last_stamp_ns_, gap_ns = stamp_ns - last_ns;
  const bool next_goes_on = next_ns && *next_ns > last_ns && *next_ns - last_ns <= kLongestPause_ns;
  const bool out_of_line = stamp_ns < last_ns || (next_ns && *next_ns < stamp_ns);
  if (out_of_line && next_goes_on) {
    const std::int64_t between_ns = (*next_ns - last_ns) / 2;
    const bool late = gap_ns < 0 ? gap_ns >= -kLate_ns : stamp_ns - *next_ns <= kLate_ns;
    (late ? late_ : lone_).add(line, seconds(gap_ns));
    last_stamp_ns_ = last_ns + between_ns;
    return between_ns;
  }
  if (gap_ns < 0 && gap_ns >= -kLate_ns) {
    late_.add(line, seconds(gap_ns));
    return 0;  // the stamps go on from the later one
  }
  last_stamp_ns_ = stamp_ns;
  if (gap_ns < 0 || gap_ns > kLongestPause_ns) {
    (gap_ns < 0 ? backward_ : forward_).add(line, seconds(gap_ns));
    return usual_gap_ns_;
  }
  if (longest_gap_ns_ && gap_ns > *longest_gap_ns_) {
    skipped_.add(line, seconds(gap_ns));
    return std::min(usual_gap_ns_, *longest_gap_ns_);
  }
  if (gap_ns > kLong_ns) long_.add(line, seconds(gap_ns));
  if (gap_ns > 0) usual_gap_ns_ = std::min(gap_ns, kSecond);
  return gap_ns;
}

std::vector<LogNote> LogClock::notes() const {
  std::vector<LogNote> notes;
  const auto note = [&](const Events& events, const std::string& text) {
    if (events.count > 0) notes.push_back({text, events.line});
  };
  note(forward_, "the clock was set forward by " + seconds_text(forward_.first_s) + " s here" +
                     times(forward_.count) + "; time goes on from there, no frame is lost");
  note(backward_, "time runs backwards by " + seconds_text(-backward_.first_s) + " s here" +
                      times(backward_.count) +
                      ": a clock that was set, or another log; time goes on from there, no frame is lost");
  note(late_, std::to_string(late_.count) +
                  " stamps are up to 50 ms out of order, the first here; kept in the order of the file");
  note(lone_, std::to_string(lone_.count) + " stamps alone are wrong, the first here by " +
                  seconds_text(std::abs(lone_.first_s)) + " s; their frames lie between their neighbours");
  note(long_, "a pause of " + seconds_text(long_.first_s) + " s here" + times(long_.count) +
                  ": --skip-gaps 10 leaves such pauses out");
  note(skipped_, std::to_string(skipped_.count) + " pauses were left out, the first of " +
                     seconds_text(skipped_.first_s) + " s here");
  return notes;
}

}  // namespace rigsound::log
