#include "clicks/train_power.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::analysis {

TrainPower::TrainPower(const EnvelopePower& shape, const std::vector<long>& onset, long length)
    : shape_(shape), length_(length) {
  const long attack = shape.attack.size();
  long longest = 0;
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
  v.setConstant(length_, floor);
  double carried = 0;
  for (size_t i = 0; i < clicks_.size(); ++i) {
    const Click& click = clicks_[i];
    carried += power(static_cast<long>(i)) * click.first;
    v.segment(click.start, click.end - click.start) += carried * decay_.head(click.end - click.start);
    carried *= click.carry;
  }
  for (size_t i = 0; i < clicks_.size(); ++i)
    each_attack_block(clicks_[i], [&](long at, const auto& attack) {
      v.segment(at, attack.size()) += power(static_cast<long>(i)) * attack;
    });
}

Eigen::ArrayXd TrainPower::gather(const Eigen::ArrayXd& x) const {
  Eigen::ArrayXd sums(static_cast<long>(clicks_.size()));
  double later = 0;
  for (size_t i = clicks_.size(); i-- > 0;) {
    const Click& click = clicks_[i];
    const long length = click.end - click.start;
    later = later * click.carry + (decay_.head(length) * x.segment(click.start, length)).sum();
    double sum = click.first * later;
    each_attack_block(
        click, [&](long at, const auto& attack) { sum += (attack * x.segment(at, attack.size())).sum(); });
    sums(static_cast<long>(i)) = sum;
  }
  return sums;
}

}  // namespace rigsound::analysis
