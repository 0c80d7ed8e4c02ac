// The samples of one recorded click.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace rigsound {

/// Samples that never change; copies share them. Thread: any; the last copy of a click ends OFF.
class Click {
 public:
  Click() = default;
  Click(std::vector<float> samples)  // NOLINT(google-explicit-constructor): the same samples
      : count_(samples.size()) {
    auto held = std::make_shared<const std::vector<float>>(std::move(samples));
    first_ = {held, held->data()};
  }
  Click(std::initializer_list<float> samples) : Click(std::vector<float>(samples)) {}
  /// `count` samples from `first` on, which keeps all of them in memory.
  Click(std::shared_ptr<const float> first, std::size_t count) : first_(std::move(first)), count_(count) {}

  const float* data() const noexcept { return first_.get(); }
  std::size_t size() const noexcept { return count_; }
  bool empty() const noexcept { return count_ == 0; }
  const float* begin() const noexcept { return data(); }
  const float* end() const noexcept { return data() + count_; }
  const float& operator[](std::size_t n) const noexcept { return data()[n]; }

  friend bool operator==(const Click& a, const Click& b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
  friend bool operator!=(const Click& a, const Click& b) noexcept { return !(a == b); }

 private:
  std::shared_ptr<const float> first_;
  std::size_t count_ = 0;
};

}  // namespace rigsound
