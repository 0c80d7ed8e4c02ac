// Step 6: click-synchronous NMF. The activations follow from the clicks, only the spectra are learned.
#pragma once

#include <vector>

#include "denoise/click_activations.hpp"
#include "denoise/factors.hpp"
#include "denoise/word_fit.hpp"
#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// One click train and the decays of its dictionary.
struct TrainWords {
  ClickTrain clicks;
  Decays decays = kUsualDecays;
};

struct CsNmfOptions {
  Updates updates = fast_updates(7);  ///< of W
  float noise_start =
      0.05f;            ///< of the 20 % quantile's noise level; low, or a loud drill leaks into the noise
  float slow_cost = 0;  ///< 0...1; of decays of 0.4 of the train's own and below, none from 0.8 of it on
};

/// Minimises the Itakura-Saito divergence D(P | W_s E + W_n hats) over W_s and W_n, with E the click
/// activations of the trains (kDecayCount words each, at most two trains) and one noise knot more than every
/// two seconds. Every bin is independent. slow_cost makes a train's slowest words dearer: a tail that hardly
/// falls from click to click explains hiss as well as the background does, and takes it where nothing speaks
/// against it. Where the train itself falls by 15 dB or less from click to click, nothing is dearer. Thread:
/// OFF.
Factors cs_nmf(const WordFit& clip, const std::vector<TrainWords>& trains, const CsNmfOptions& options);

/// The words of train `k` first, as the drilling; those of the other trains count among the background.
/// Thread: OFF.
Factors drilling_of_train(const Factors& factors, int k);

/// The same without any clicks: a slow background alone. Thread: OFF.
Factors background_nmf(const WordFit& clip);

}  // namespace rigsound::analysis
