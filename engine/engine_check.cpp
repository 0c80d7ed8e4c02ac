#include "engine_check.hpp"

#include <stdexcept>
#include <string>

#include "drill/bank_check.hpp"
#include "scene/bank_choice.hpp"

namespace rigsound {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument(what);
}

bool between(double x, double low, double high) { return x >= low && x <= high; }

void require_valid(const SceneOptions& s) {
  require(between(s.contact_bar, 0, 300), "scene.contact_bar must be 0...300 bar");
  require(between(s.underfeed_bar, s.contact_bar, 300), "scene.underfeed_bar must be contact_bar...300 bar");
  require(between(s.overfeed_bar, s.underfeed_bar, 300) && s.overfeed_bar > 0,
          "scene.overfeed_bar must be underfeed_bar...300 bar");
  require(between(s.hysteresis_bar, 0, 100), "scene.hysteresis_bar must be 0...100 bar");
  require(between(s.crossfade_s, 0, 10), "scene.crossfade_s must be 0...10 s");
  require(between(s.open_burst_s, 0, 10), "scene.open_burst_s must be 0...10 s");
  require(between(s.open_sustain_db, -60, 0), "scene.open_sustain_db must be -60...0 dB");
  require(between(s.idle_rpm, 100, 4000), "scene.idle_rpm must be 100...4000 r/min");
}

void require_valid(const MixOptions& m, double sample_rate) {
  require(between(m.drill_db, -60, 24) && between(m.tool_db, -60, 24) && between(m.diesel_db, -60, 24),
          "mix gains must be -60...24 dB");
  require(between(m.ceiling_dbfs, -60, 0), "mix.ceiling_dbfs must be -60...0 dBFS");
  for (const EqualiserBand& band : m.equaliser)
    require(between(band.frequency_hz, 10, 0.45 * sample_rate) && between(band.gain_db, -24, 24) &&
                between(band.q, 0.1, 20),
            "mix.equaliser: frequency_hz must be 10 Hz...0.45 rate, gain_db -24...24, q 0.1...20");
}

void require_valid(const SoundSet& sounds, double sample_rate) {
  for (const ClickBank& bank : sounds.banks) {
    drill::require_playable(bank);
    require(bank.sample_rate == sample_rate, "bank \"" + bank.name + "\" is not at the engine's rate");
  }
  for (const BankUse& use : sounds.uses)
    require(use.bank >= 0 && use.bank < static_cast<int>(sounds.banks.size()),
            "a use names a bank that is not there");
  for (int s = 0; s < kSituationCount; ++s) {
    const auto situation = static_cast<Situation>(s);
    require(scene::choose_bank(sounds, situation, 1, 0) != nullptr,
            "the sound set has no bank for the situation \"" + std::string(name(situation)) + "\"");
  }
}

}  // namespace

void require_valid(const EngineOptions& o, const SoundSet& sounds) {
  require(between(o.sample_rate, kMinSampleRate, kMaxSampleRate), "rate must be 32000...192000 Hz");
  require(o.block >= kChunk && o.block <= kMaxBlock && o.block % kChunk == 0,
          "block must be a multiple of 32 from 32 to 8192 frames");
  require(o.channels >= 1 && o.channels <= kMaxChannels, "channels must be 1...8");
  require(!o.booms.empty() && o.booms.size() <= kMaxBooms, "a rig has 1...4 booms");
  for (const BoomOptions& boom : o.booms) {
    require(between(boom.pan, -1, 1), "boom \"" + boom.name + "\": pan must be -1...1");
    require(between(boom.gain_db, -60, 24), "boom \"" + boom.name + "\": gain_db must be -60...24 dB");
    require(boom.tool >= -1 && boom.tool < static_cast<int>(sounds.tools.size()),
            "boom \"" + boom.name + "\": its tool is not in the sound set");
  }
  require_valid(o.scene);
  require_valid(o.mix, o.sample_rate);
  require_valid(sounds, o.sample_rate);
}

}  // namespace rigsound
