// Likeness of clicks, against spectrograms whose band powers are chosen.
#include "clicks/click_likeness.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "clicks/heard_band.hpp"
#include "denoise/factors.hpp"

using namespace rigsound::analysis;

namespace {

constexpr int kGap = 20, kClicks = 24;  // frames, clicks

/// A steady background of power 1 in every bin and `kClicks` clicks a gap apart, each four frames long;
/// spectrum(click, bin) is a click's power.
template <class Spectrum>
PowerSpectrogram clicks_in_background(Spectrum spectrum) {
  PowerSpectrogram power;
  power.frames = kGap * (kClicks + 1);
  power.P = Grid::Ones(257, power.frames);
  for (int click = 0; click < kClicks; ++click)
    for (int bin = 0; bin < 257; ++bin)
      power.P.row(bin).segment(kGap * (click + 1), 4) += static_cast<float>(spectrum(click, bin));
  return power;
}

ClickTrain train() {
  ClickTrain clicks;
  clicks.mean_gap_samples = kGap * 128;
  for (int click = 0; click < kClicks; ++click) {
    clicks.P.push_back((click + 1) * kGap * 128);
    clicks.beta.push_back(1);
  }
  return clicks;
}

double slope(int bin) { return 30 * std::exp(-bin / 60.0); }

ClickLikeness likeness_of(const PowerSpectrogram& power, const ClickTrain& clicks) {
  const ClickFrames frames = click_frames(clicks, power.frames);
  return click_likeness(power, frames, heard_bins(power, frames));
}

}  // namespace

TEST_CASE("clicks of one spectrum resemble one another, whatever their strength") {
  const auto power = clicks_in_background(
      [](int click, int bin) { return slope(bin) * std::exp(std::sin(static_cast<double>(click))); });
  CHECK(likeness_of(power, train()).dispersion < 1e-3);
}

TEST_CASE("clicks of two kinds do not: the divergence of their mixture from its mean") {
  // Two spectra that share no band, in turn: the best single spectrum is half of each, so that where a click
  // sounds its power is twice the model's and the background's is below it.
  const auto power =
      clicks_in_background([](int click, int bin) { return (bin > 21) == (click % 2 == 0) ? 99.0 : 0.0; });
  const double high = 100.0 / 50.5, low = 1.0 / 50.5;
  const double expected = 0.5 * ((high - std::log(high) - 1) + (low - std::log(low) - 1));
  CHECK(likeness_of(power, train()).dispersion == doctest::Approx(expected).epsilon(0.02));
}

TEST_CASE("the rise is that of the bands at the clicks, in nepers of power") {
  const auto power = clicks_in_background([](int, int) { return std::exp(1.5) - 1; });
  CHECK(likeness_of(power, train()).rise == doctest::Approx(1.5));
  const auto silent = clicks_in_background([](int, int) { return 0.0; });
  CHECK(likeness_of(silent, train()).rise == doctest::Approx(0));
}

TEST_CASE("a band that holds nothing says nothing") {
  const auto all = [](int click, int bin) { return slope(bin) * (1 + click % 3); };
  PowerSpectrogram power = clicks_in_background(all);
  const ClickLikeness whole = likeness_of(power, train());
  power.P.bottomRows(150).setConstant(1e-8f);
  const ClickLikeness limited = likeness_of(power, train());
  CHECK(limited.dispersion < 1e-3);
  CHECK(limited.rise > whole.rise);
}

TEST_CASE("bands that a codec writes now and then are no figure of the clicks") {
  // What a codec short of bits keeps of the bins over 7.5 kHz: nothing, one click and background in three.
  constexpr int kFirst = 80;
  const auto emptied = [](int every) {
    PowerSpectrogram power =
        clicks_in_background([](int click, int bin) { return slope(bin) * (1 + click % 4); });
    for (int click = 0; click < kClicks; click += every)
      power.P.bottomRows(257 - kFirst).middleCols(kGap * (click + 1) - 4, kGap / 2).setConstant(1e-7f);
    return power;
  };
  const PowerSpectrogram often = emptied(3), once = emptied(kClicks);
  CHECK(likeness_of(often, train()).dispersion < 1e-3);
  CHECK(heard_bins(often, click_frames(train(), often.frames)) == kFirst);
  CHECK(heard_bins(once, click_frames(train(), once.frames)) == 257);
}

TEST_CASE("bins over which no click is heard, or that hold nothing, leave the divergence alone") {
  PowerSpectrogram power;
  power.frames = 100;
  power.P = Grid::Ones(10, power.frames);
  power.P.row(2).setConstant(1e-6f);
  Grid divergence = Grid::Constant(10, power.frames, 0.5f);
  divergence.bottomRows(4).setConstant(9);
  divergence.row(2).setConstant(9);
  const auto by_bin = divergence_by_bin(power, divergence, Eigen::ArrayXf::Ones(power.frames), 6);
  CHECK(by_bin.size() == 5);
  CHECK(by_bin.minCoeff() == doctest::Approx(0.5));
  CHECK(by_bin.maxCoeff() == doctest::Approx(0.5));
}

TEST_CASE("one click resembles nothing") {
  ClickTrain one = train();
  one.P.resize(1);
  const auto power = clicks_in_background([](int, int bin) { return slope(bin); });
  CHECK(likeness_of(power, one).dispersion == 0);
}
