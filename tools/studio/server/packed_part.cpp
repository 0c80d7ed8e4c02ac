#include "packed_part.hpp"

#include "packed_rig.hpp"
#include "rigsound/config/background_files.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/packed_set.hpp"
#include "rigsound/config/refinement.hpp"
#include "rigsound/machine/signal.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {
namespace {

/// The smallest diesel there is, of no sound: a set without one would get the built-in diesel, whose tables
/// are most of what an engine takes to make.
DieselModel silent_diesel() {
  DieselModel diesel;
  diesel.name = "off";
  diesel.angle_samples = 1024;
  diesel.slots = 16;
  diesel.low_channels = 64;
  diesel.low_scales = 0;
  DieselPoint point;
  point.rpm = info(Signal::kEngineRpm).max;
  point.low_variance.assign(static_cast<std::size_t>(diesel.low_channels), 0.0F);
  const std::size_t bands = slot_band_edges(diesel.slot_samples()).size() - 1;
  point.slot_variance.assign(static_cast<std::size_t>(diesel.slots) * bands, 0.0F);
  point.slot_log_variance.assign(static_cast<std::size_t>(diesel.slots), 0.0F);
  diesel.points = {point};
  return diesel;
}

void set_diesel(config::PackedSet& set, DieselModel diesel) {
  set.parts.index.backgrounds = {diesel.name};
  set.parts.diesels = {std::move(diesel)};
}

/// `stored` serves every situation; nothing else sounds.
config::PackedSet alone(EngineOptions engine, config::StoredBank stored) {
  config::PackedSet set;
  for (int s = 0; s < kSituationCount; ++s) {
    config::BankEntry use;
    use.name = stored.bank.name;
    use.situation = static_cast<Situation>(s);
    set.parts.index.banks.push_back(use);
  }
  set.parts.index.rocks = {{"medium"}};
  set.parts.banks.push_back(std::move(stored));
  set_diesel(set, silent_diesel());
  engine.booms = {BoomOptions()};
  set.rig = config::PackedRig{std::move(engine), {""}};
  return set;
}

/// The same impacts with clicks that nobody hears: what is struck sounds alone.
config::StoredBank silent(config::StoredBank stored) {
  constexpr double kSilent = 1e-12;
  stored.bank.amplitude_deviation *= kSilent / stored.bank.mean_amplitude;
  stored.bank.mean_amplitude = kSilent;
  stored.bank.clicks = {Click{1.0F}};
  return stored;
}

config::StoredBank even_hammer(double sample_rate) {
  constexpr double kRate_hz = 24;
  config::StoredBank stored;
  stored.bank.name = "hammer";
  stored.bank.sample_rate = sample_rate;
  stored.bank.mean_gap_samples = sample_rate / kRate_hz;
  return stored;
}

/// Those of the clicks that stay; empty: all.
std::vector<Click> kept_clicks(const ClickBank& bank, const std::vector<int>& clicks) {
  if (clicks.empty()) return bank.clicks;
  std::vector<Click> kept;
  for (const int click : clicks) {
    if (click < 0 || click >= static_cast<int>(bank.clicks.size()))
      throw ApiError(400, "clicks: there is no click " + std::to_string(click));
    kept.push_back(bank.clicks[static_cast<std::size_t>(click)]);
  }
  return kept;
}

}  // namespace

std::string packed_bank(const Workplace& place, const std::string& bank, const std::vector<int>& clicks) {
  config::StoredBank stored = config::load_analysed_bank(bank_folder(place, bank));
  stored.bank.clicks = kept_clicks(stored.bank, clicks);
  return config::packed(alone(engine_of(place), std::move(stored)));
}

std::string packed_background(const Workplace& place, const std::string& background) {
  const EngineOptions engine = engine_of(place);
  config::PackedSet set = alone(engine, silent(even_hammer(engine.sample_rate)));
  set_diesel(set, config::load_background(background_folder(place, background)));
  return config::packed(set);
}

std::string packed_steel(const Workplace& place, const ToolModel& steel, const Hammer& hammer) {
  const EngineOptions engine = engine_of(place);
  config::StoredBank impacts = hammer.bank.empty() ? even_hammer(engine.sample_rate)
                                                   : config::load_bank(bank_folder(place, hammer.bank));
  const bool clicks = hammer.clicks && !hammer.bank.empty();
  config::PackedSet set = alone(engine, clicks ? std::move(impacts) : silent(std::move(impacts)));
  set.parts.index.tools = {{steel.name}};
  set.parts.tools = {steel};
  set.rig->boom_tools = {steel.name};
  return config::packed(set);
}

}  // namespace rigsound::studio
