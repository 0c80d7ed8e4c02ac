#include "sound_set/index_text.hpp"

#include "rigsound/machine/fields.hpp"
#include "toml/toml_writer.hpp"

namespace rigsound::config {

std::string index_preamble() {
  const std::string rods = kRodCounts.text(), trims = kBankTrims.text(),
                    pressures = kRecordedPressures.text(), stiffness = kRockStiffnesses.text();
  return R"(# What this sound set plays, and when. Written by rigsound, meant to be edited: rigsound only ever adds
# entries at the end and leaves everything else as it finds it.
#
# [[bank]] says that a bank of clicks serves a drilling situation:
#   name       folder under banks/
#   situation  normal, underfeed, overfeed, closed_rattling or open_rattling; all five must be served
#   rods       rod count it was recorded with, )" +
         rods + R"(; 0 serves any count
#   rock       name of a [[rock]] below; "" serves any rock
#   feed_bar, percussion_bar   pressures it was recorded at, )" +
         pressures + R"(; 0: where the rig's
#              thresholds put its situation, the rig's nominal one
#   gain_db    trim against the other banks, )" +
         trims + R"(
# A bank may serve several situations: give it one [[bank]] each. Of several that fit, the nearest in
# rods and rock is played.
#
# [[rock]] names a rock. The machine signal `rock` counts them from 0 in this order. stiffness, )" +
         stiffness + R"(:
# of the bit in it; a drill string rings the longer the softer the rock.
# [[laws]] says how the clicks of some rods and rock go on beyond the outermost banks: slopes over the feed, 1/bar; the
#   last one is of the spectrum, dB an octave.
# analyze fits them where none are; remove an entry to have it written anew.
# [[tool]] is a steel, tools/NAME.json: kind = "bar" (a jackhammer's tool) or "string" (rods, joints, bit on rock). [[background]] is a diesel, backgrounds/NAME.

format = 1
)";
}

std::string index_bank_text(const BankEntry& entry) {
  return "\n[[bank]]\nname = \"" + entry.name + "\"\nsituation = \"" + std::string(name(entry.situation)) +
         "\"\n" + toml_text(entry);
}

std::string index_laws_text(const LawsEntry& laws) { return "\n[[laws]]\n" + toml_text(laws); }

std::string index_name_text(std::string_view kind, std::string_view name) {
  return "\n[[" + std::string(kind) + "]]\nname = \"" + std::string(name) + "\"\n";
}

}  // namespace rigsound::config
