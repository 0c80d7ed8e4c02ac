#include "progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

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

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::clear() {
  if (terminal_) fmt::print(stderr, "\r{:{}}\r", "", kWidth + 40);
}

void ProgressBar::show(int done, int total) {
  if (!terminal_ || total <= 0) return;
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = done > 0 ? spent * (total - done) / done : 0;
  const int filled = kWidth * std::clamp(done, 0, total) / total;
  fmt::print(stderr, "\r[{:<{}}] {}/{}  {} left   ", std::string(static_cast<size_t>(filled), '#'), kWidth,
             done, total, duration(left));
  std::fflush(stderr);
}

}  // namespace rigsound::tools
