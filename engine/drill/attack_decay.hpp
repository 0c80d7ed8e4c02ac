// The attack/decay envelope of a click (drilling paper, eq. 5 and 6), sample by sample.
#pragma once

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::drill {

/// a_n for n = 0, 1, 2, ...: rises from 0 to 1 over N_a samples with bend alpha_a, then decays with alpha_d.
class AttackDecay {
 public:
  AttackDecay() = default;
  AttackDecay(double N_a, double alpha_a, double alpha_d) noexcept
      : N_a_(N_a), bend_(dsp::exp(-alpha_a)), fall_(dsp::exp(-alpha_d)), alpha_d_(alpha_d) {
    const double bend_total = alpha_a * N_a;
    straight_ = bend_total < 1e-6 && bend_total > -1e-6;
    full_ = straight_ ? 1 : 1 - dsp::exp(-bend_total);
  }

  bool decaying() const noexcept { return decaying_; }

  double next() noexcept {
    if (n_ <= N_a_ && N_a_ > 0) {
      const double a = straight_ ? n_ / N_a_ : (1 - power_) / full_;
      power_ *= bend_;
      n_ += 1;
      return a;
    }
    if (!decaying_) {
      decaying_ = true;
      value_ = dsp::exp(-(n_ - N_a_) * alpha_d_);
    } else {
      value_ *= fall_;
    }
    n_ += 1;
    return value_;
  }

 private:
  double N_a_ = 0, bend_ = 1, fall_ = 1, alpha_d_ = 0, full_ = 1;
  double n_ = 0, power_ = 1, value_ = 1;
  bool straight_ = true, decaying_ = false;
};

}  // namespace rigsound::drill
