#include "progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace rigsound::tools {

constexpr int kWidth = 40;

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (terminal_) fmt::print(stderr, "\r{:{}}\r", "", kWidth + 40);
}

void ProgressBar::show(int done, int total) {
  if (!terminal_ || total <= 0) return;
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double left = done > 0 ? spent * (total - done) / done : 0;
  const int filled = kWidth * std::clamp(done, 0, total) / total;
  fmt::print(stderr, "\r[{:<{}}] {}/{}  {:.0f} s left ", std::string(static_cast<size_t>(filled), '#'),
             kWidth, done, total, left);
  std::fflush(stderr);
}

}  // namespace rigsound::tools
