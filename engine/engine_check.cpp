#include "engine_check.hpp"

#include "field_check.hpp"
#include "scene/bank_choice.hpp"

namespace rigsound {
namespace {

void require_order(const SceneOptions& s) {
  const FieldCheck check = FieldCheck().inside("scene");
  check.require(s.contact_bar < s.underfeed_bar, "contact_bar",
                "is " + number_text(s.contact_bar) + " bar, expected less than underfeed_bar, " +
                    number_text(s.underfeed_bar) + " bar");
  check.require(s.underfeed_bar <= s.overfeed_bar, "underfeed_bar",
                "is " + number_text(s.underfeed_bar) + " bar, expected at most overfeed_bar, " +
                    number_text(s.overfeed_bar) + " bar");
}

void require_banks(const SoundSet& sounds, double sample_rate) {
  const FieldCheck check;
  for (const ClickBank& bank : sounds.banks) {
    require_valid(bank);
    check.require(bank.sample_rate == sample_rate, "sample_rate",
                  "of bank \"" + bank.name + "\" is " + number_text(bank.sample_rate) +
                      " Hz, expected the engine's, " + number_text(sample_rate) + " Hz");
  }
  for (const BankUse& use : sounds.uses)
    check.require(use.bank >= 0 && use.bank < static_cast<int>(sounds.banks.size()), "bank",
                  "of a use is not there, expected one of the sound set");
  for (int s = 0; s < kSituationCount; ++s) {
    const auto situation = static_cast<Situation>(s);
    check.require(scene::choose_bank(sounds, situation, 1, 0) != nullptr, "bank",
                  "the sound set has none for the situation \"" + std::string(name(situation)) + "\"");
  }
}

}  // namespace

void require_valid(const EngineOptions& o) {
  const FieldCheck check;
  check.ranges(o);
  check.require(
      !o.booms.empty() && o.booms.size() <= kMaxBooms, "boom",
      "a rig has " + std::to_string(o.booms.size()) + " booms, expected " + Range{1, kMaxBooms}.text());
  require_order(o.scene);
  for (std::size_t i = 0; i < o.mix.equaliser.size(); ++i)
    check.inside("mix")
        .inside("equaliser", i)
        .at_most(kHighestCorner * o.sample_rate, number_text(kHighestCorner) + " of the rate",
                 o.mix.equaliser[i].frequency_hz, "frequency_hz");
}

void require_valid(const EngineOptions& o, const SoundSet& sounds) {
  require_valid(o);
  for (const BoomOptions& boom : o.booms) {
    const bool there = boom.tool >= -1 && boom.tool < static_cast<int>(sounds.tools.size()) &&
                       boom.drill_string >= -1 && boom.drill_string < static_cast<int>(sounds.strings.size());
    FieldCheck().require(there, "boom.tool",
                         "of \"" + boom.name + "\" is not there, expected one of the sound set");
  }
  require_banks(sounds, o.sample_rate);
}

}  // namespace rigsound
