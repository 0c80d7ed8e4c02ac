#include "progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ratio>

namespace rigsound::tools {

namespace {

constexpr int kWidth = 40;

std::string duration(double seconds) {
  const auto s = static_cast<long>(seconds + 0.5);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

}  // namespace

ProgressBar::ProgressBar(Beside beside)
    : terminal_(isatty(STDERR_FILENO) != 0 && (beside == Beside::kNothing || isatty(STDOUT_FILENO) == 0)) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::clear() {
  if (terminal_) fmt::print(stderr, "\r{:{}}\r", "", kWidth + 40);
}

void ProgressBar::show(int done, int total) {
  if (terminal_ && total > 0) draw(static_cast<double>(done) / total, fmt::format("{}/{}", done, total));
}

void ProgressBar::show(double share) {
  if (!terminal_) return;
  using Tenths = std::chrono::duration<int, std::deci>;
  const int tenth = std::chrono::duration_cast<Tenths>(std::chrono::steady_clock::now() - start_).count();
  if (tenth == last_tenth_) return;
  last_tenth_ = tenth;
  draw(share, fmt::format("{:.0f} %", 100 * share));
}

void ProgressBar::draw(double share, const std::string& count) {
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = share > 0 ? spent * (1 - share) / share : 0;
  const auto filled = static_cast<std::size_t>(kWidth * std::clamp(share, 0.0, 1.0));
  fmt::print(stderr, "\r[{:<{}}] {}  {} left   ", std::string(filled, '#'), kWidth, count,
             share > 0 ? duration(left) : "?");
  std::fflush(stderr);
}

}  // namespace rigsound::tools
