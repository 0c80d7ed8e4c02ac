#include "clicks/train_power.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/click_kernels.hpp"

namespace rigsound::analysis {

TrainPower::TrainPower(const EnvelopePower& shape, const std::vector<long>& onset, long length)
    : shape_(shape), length_(length) {
  const long attack = shape.attack.size();
  before_ = onset.empty() ? length : std::clamp(onset.front() + attack, 0L, length);
  long longest = before_;
  for (size_t i = 0; i < onset.size(); ++i) {
    const long tail = onset[i] + attack, start = std::clamp(tail, 0L, length);
    const long end = i + 1 < onset.size() ? std::clamp(onset[i + 1] + attack, 0L, length) : length;
    const double first =
        tail < 0 ? shape.tail * std::pow(shape.decay, static_cast<double>(-tail)) : shape.tail;
    clicks_.push_back({onset[i], start, end, tail < length ? first : 0, 0});
    longest = std::max(longest, end - start);
  }
  decay_.resize(longest + 1);
  double factor = 1;
  for (long k = 0; k <= longest; ++k, factor *= shape.decay) decay_(k) = factor;
  for (Click& click : clicks_) click.carry = decay_(click.end - click.start);
}

template <class Visit>
void TrainPower::each_attack_block(const Click& click, Visit visit) const {
  const long first = std::max(0L, -click.onset),
             last = std::min<long>(shape_.attack.size(), length_ - click.onset);
  if (first < last) visit(click.onset + first, shape_.attack.segment(first, last - first));
}

void TrainPower::spread(const Eigen::ArrayXd& power, double floor, Eigen::ArrayXd& v) const {
  v.resize(length_);
  v.head(before_).setConstant(floor);
  double carried = 0;
  for (size_t i = 0; i < clicks_.size(); ++i) {
    const Click& click = clicks_[i];
    carried += power(static_cast<long>(i)) * click.first;
    click_kernels().tail(carried, decay_.data(), floor, click.end - click.start, v.data() + click.start);
    carried *= click.carry;
  }
  for (size_t i = 0; i < clicks_.size(); ++i)
    each_attack_block(clicks_[i], [&](long at, const auto& attack) {
      v.segment(at, attack.size()) += power(static_cast<long>(i)) * attack;
    });
}

TrainSums TrainPower::weigh(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, double clip) const {
  const auto count = static_cast<long>(clicks_.size());
  TrainSums sums{Eigen::ArrayXd(count), Eigen::ArrayXd(count), {}};
  const auto weighed = [&](const double* a, long at, long length) {
    return click_kernels().weigh(q.data() + at, v.data() + at, a, clip, length);
  };
  const auto count_in = [&](const WeighedSums& s) { sums.all.first += s.x, sums.all.second += s.y; };
  PairOfSums later;
  for (long i = count; i-- > 0;) {
    const Click& click = clicks_[static_cast<size_t>(i)];
    const WeighedSums tail = weighed(decay_.data(), click.start, click.end - click.start);
    count_in(tail);
    later = {later.first * click.carry + tail.ax, later.second * click.carry + tail.ay};
    sums.x(i) = click.first * later.first, sums.y(i) = click.first * later.second;
    each_attack_block(click, [&](long at, const auto& attack) {
      const WeighedSums here = weighed(attack.data(), at, attack.size());
      sums.x(i) += here.ax, sums.y(i) += here.ay;
    });
  }
  count_in(weighed(decay_.data(), 0, before_));
  return sums;
}

}  // namespace rigsound::analysis
