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
  explicit ClickSpectra(const SoundSet& sounds) : sounds_(sounds), known_(sounds.banks.size()) {}

  const drill::ClickSpectrum& of(const BankUse& use) {
    const auto bank = static_cast<std::size_t>(use.bank);
    if (!known_[bank]) known_[bank].emplace(sounds_.banks[bank]);
    return *known_[bank];
  }

 private:
  const SoundSet& sounds_;
  std::vector<std::optional<drill::ClickSpectrum>> known_;
};

}  // namespace rigsound::scene
