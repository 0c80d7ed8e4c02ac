// The click spectra of a sound set, for whoever asks for the same bank again and again.
#pragma once

#include <optional>
#include <vector>

#include "drill/click_spectrum.hpp"
#include "rigsound/sound_set.hpp"

namespace rigsound::scene {

/// Each is computed when it is first asked for. Thread: OFF.
class ClickSpectra {
 public:
  /// `sounds` must outlive it.
  ClickSpectra(const SoundSet& sounds)  // NOLINT(google-explicit-constructor): for one boom, a set is enough
      : sounds_(sounds), known_(sounds.banks.size()) {}

  const SoundSet& sounds() const noexcept { return sounds_; }

  const drill::ClickSpectrum& of(const BankUse& use) const {
    const auto bank = static_cast<std::size_t>(use.bank);
    if (!known_[bank]) known_[bank].emplace(sounds_.banks[bank]);
    return *known_[bank];
  }

 private:
  const SoundSet& sounds_;
  mutable std::vector<std::optional<drill::ClickSpectrum>> known_;
};

}  // namespace rigsound::scene
