#include "rigsound/analysis/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace rigsound::analysis {

void for_each_index(int count, int jobs, const std::function<void(int)>& work) {
  std::vector<std::exception_ptr> failures(static_cast<size_t>(std::max(count, 0)));
  std::atomic<int> next{0};
  const auto run = [&] {
    for (int i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  std::vector<std::thread> helpers;
  for (int k = 1; k < std::min(jobs, count); ++k) helpers.emplace_back(run);
  run();
  for (std::thread& helper : helpers) helper.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace rigsound::analysis
