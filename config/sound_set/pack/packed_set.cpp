#include "rigsound/config/packed_set.hpp"

#include <cmath>

#include "rigsound/config/names.hpp"
#include "rigsound/dsp/energy.hpp"
#include "sound_set/pack/pack_reader.hpp"
#include "sound_set/pack/pack_writer.hpp"
#include "sound_set/pack/sha256.hpp"

namespace rigsound::config {
namespace {

constexpr std::string_view kMagic{"RIGSET\x1a\n", 8};
constexpr std::size_t kHashAt = 24, kHashed = 56, kAlignment = 64;

// ---- what stands in the file, in its order; one function writes a part, its neighbour reads it

void write_index(const SoundSetIndex& index, PackWriter& out) {
  out.size(index.rocks.size());
  for (const RockEntry& rock : index.rocks) out.text(rock.name), out.write(rock);
  out.size(index.laws.size());
  for (const LawsEntry& laws : index.laws) out.write(laws);
  out.size(index.banks.size());
  for (const BankEntry& bank : index.banks)
    out.text(bank.name), out.text(std::string(name(bank.situation))), out.write(bank);
  out.size(index.tools.size());
  for (const ToolEntry& tool : index.tools) out.text(tool.name), out.write(tool);
  out.size(index.backgrounds.size());
  for (const std::string& background : index.backgrounds) out.text(background);
}

std::string read_name(PackReader& in) {
  std::string name = in.text();
  if (!is_name(name)) in.fail("holds a name that is none, " + std::string(kNameRule));
  return name;
}

Situation read_situation(PackReader& in) {
  const auto situation = situation_by_name(in.text());
  if (!situation) in.fail("holds a bank for a situation that is none");
  return *situation;
}

SoundSetIndex read_index(PackReader& in) {
  SoundSetIndex index;
  for (std::size_t left = in.size(1); left > 0; --left) {
    RockEntry& rock = index.rocks.emplace_back();
    rock.name = read_name(in), in.read(rock);
  }
  for (std::size_t left = in.size(1); left > 0; --left) in.read(index.laws.emplace_back());
  for (std::size_t left = in.size(1); left > 0; --left) {
    BankEntry& bank = index.banks.emplace_back();
    bank.name = read_name(in), bank.situation = read_situation(in), in.read(bank);
  }
  for (std::size_t left = in.size(1); left > 0; --left) {
    ToolEntry& tool = index.tools.emplace_back();
    tool.name = read_name(in), in.read(tool);
  }
  for (std::size_t left = in.size(1); left > 0; --left) index.backgrounds.push_back(read_name(in));
  return index;
}

/// Clicks go behind everything else: where each begins, in bytes from the first, and its samples.
void write_bank(const StoredBank& stored, PackWriter& out, std::string& samples) {
  out.text(stored.bank.name), out.write(stored.provenance), out.write(stored.bank);
  out.size(stored.bank.clicks.size());
  for (const Click& click : stored.bank.clicks) {
    samples.resize((samples.size() + kAlignment - 1) / kAlignment * kAlignment);
    out.number(static_cast<std::uint64_t>(samples.size()));
    out.size(click.size());
    samples.append(reinterpret_cast<const char*>(click.data()), click.size() * sizeof(float));
  }
}

struct PackedSamples {
  std::string_view bytes;
  const ClickOfBytes& click_of;
};

Click read_click(PackReader& in, const PackedSamples& samples) {
  const auto at = in.number<std::uint64_t>();
  const std::size_t count = in.number<std::uint32_t>();
  if (at > samples.bytes.size() || count > (samples.bytes.size() - at) / sizeof(float))
    in.fail("is damaged: a click lies behind its end");
  Click click = samples.click_of(samples.bytes.substr(at, count * sizeof(float)));
  if (!(std::fabs(std::sqrt(dsp::energy(click)) - 1) <= kUnitNormTolerance))
    in.fail("holds a click that is not of unit norm");
  return click;
}

StoredBank read_bank(PackReader& in, const PackedSamples& samples) {
  StoredBank stored;
  stored.bank.name = read_name(in);
  in.read(stored.provenance), in.read(stored.bank);
  const std::size_t clicks = in.size(sizeof(std::uint64_t) + sizeof(std::uint32_t));
  if (clicks == 0 || clicks > kMaxBankClicks)
    in.fail("holds a bank of " + std::to_string(clicks) + " clicks, expected 1 to " +
            std::to_string(kMaxBankClicks));
  for (std::size_t i = 0; i < clicks; ++i) stored.bank.clicks.push_back(read_click(in, samples));
  return stored;
}

void write_diesel(const DieselModel& diesel, PackWriter& out) {
  out.text(diesel.name), out.write(diesel);
  for (const DieselPoint& point : diesel.points) {
    out.size(point.grains.size());
    for (const std::vector<float>& grain : point.grains) out.samples(grain);
  }
  out.samples(diesel.start), out.samples(diesel.stop);
}

DieselModel read_diesel(PackReader& in) {
  DieselModel diesel;
  diesel.name = read_name(in), in.read(diesel);
  for (DieselPoint& point : diesel.points)
    for (std::size_t left = in.size(sizeof(std::uint32_t)); left > 0; --left)
      in.samples(point.grains.emplace_back());
  in.samples(diesel.start), in.samples(diesel.stop);
  return diesel;
}

template <class Model>
void write_models(const std::vector<Model>& models, PackWriter& out) {
  out.size(models.size());
  for (const Model& model : models) out.text(model.name), out.write(model);
}

template <class Model>
void read_models(PackReader& in, std::vector<Model>& models) {
  for (std::size_t left = in.size(1); left > 0; --left) {
    Model& model = models.emplace_back();
    model.name = read_name(in), in.read(model);
  }
}

void write_rig(const std::optional<PackedRig>& rig, PackWriter& out) {
  out.number(static_cast<std::uint8_t>(rig.has_value()));
  if (!rig) return;
  out.number(rig->engine.seed), out.write(rig->engine);
  for (const std::string& tool : rig->boom_tools) out.text(tool);
}

std::optional<PackedRig> read_rig(PackReader& in) {
  if (in.number<std::uint8_t>() == 0) return std::nullopt;
  PackedRig rig;
  rig.engine.seed = in.number<std::uint64_t>();
  rig.engine.booms.clear();
  in.read(rig.engine);
  for (std::size_t b = 0; b < rig.engine.booms.size(); ++b) rig.boom_tools.push_back(in.text());
  return rig;
}

// ---- the file around it

template <class Number>
void put(std::string& bytes, std::size_t at, Number x) {
  std::memcpy(bytes.data() + at, &x, sizeof x);
}

/// That the index and the models it names belong together.
void require_complete(const SoundSetParts& parts, const PackReader& in) {
  std::size_t bars = 0;
  for (const ToolEntry& tool : parts.index.tools) bars += tool.kind == SteelKind::kBar;
  const auto has = [&](const std::string& name) {
    return std::any_of(parts.banks.begin(), parts.banks.end(),
                       [&](const StoredBank& b) { return b.bank.name == name; });
  };
  for (const BankEntry& entry : parts.index.banks)
    if (!has(entry.name)) in.fail("is damaged: it names bank " + entry.name + " and does not hold it");
  if (bars != parts.tools.size() || parts.index.tools.size() - bars != parts.strings.size() ||
      parts.index.backgrounds.size() != parts.diesels.size())
    in.fail("is damaged: it names other tools and backgrounds than it holds");
}

void require_valid_models(const SoundSetParts& parts, const std::string& file) {
  try {
    for (const StoredBank& stored : parts.banks) require_valid_numbers(stored.bank);
    for (const ToolModel& tool : parts.tools) require_valid(tool, kMaxSampleRate);
    for (const StringModel& string : parts.strings) require_valid(string);
    for (const DieselModel& diesel : parts.diesels) require_valid(diesel);
  } catch (const InvalidField& invalid) {
    throw InputError(file, invalid.what());
  }
}

/// What the head says of the whole; the rest of it is trusted only then. Returns the file's version.
std::uint32_t require_whole(std::string_view bytes, PackReader& head) {
  if (!is_packed(bytes)) head.fail("is no packed sound set, expected one that rigsound pack wrote");
  head.number<std::uint64_t>();
  const auto version = head.number<std::uint32_t>();
  if (version < 1 || version > kPackVersion)
    head.fail("is of version " + std::to_string(version) + ", expected 1..." + std::to_string(kPackVersion));
  head.number<std::uint32_t>();
  if (head.number<std::uint64_t>() != bytes.size()) head.fail("is cut off or has grown since it was packed");
  if (bytes.size() < kHashed) head.fail("is cut off");
  const auto hash = sha256(bytes.substr(kHashed));
  if (std::memcmp(hash.data(), bytes.data() + kHashAt, hash.size()) != 0)
    head.fail("is damaged: its SHA-256 is another");
  return version;
}

}  // namespace

Click copied_click(std::string_view bytes) {
  std::vector<float> samples(bytes.size() / sizeof(float));
  if (!bytes.empty()) std::memcpy(samples.data(), bytes.data(), bytes.size());
  return samples;
}

bool is_packed(std::string_view bytes) { return bytes.substr(0, kMagic.size()) == kMagic; }

std::string packed(const PackedSet& set) {
  std::string bytes(kHashed + sizeof(std::uint64_t), '\0'), samples;
  std::memcpy(bytes.data(), kMagic.data(), kMagic.size());
  PackWriter out(bytes);
  write_rig(set.rig, out);
  write_index(set.parts.index, out);
  out.size(set.parts.banks.size());
  for (const StoredBank& bank : set.parts.banks) write_bank(bank, out, samples);
  write_models(set.parts.tools, out);
  write_models(set.parts.strings, out);
  out.size(set.parts.diesels.size());
  for (const DieselModel& diesel : set.parts.diesels) write_diesel(diesel, out);

  bytes.resize((bytes.size() + kAlignment - 1) / kAlignment * kAlignment);
  put(bytes, 8, kPackVersion);
  put(bytes, kHashed, static_cast<std::uint64_t>(bytes.size()));
  bytes += samples;
  put(bytes, 16, static_cast<std::uint64_t>(bytes.size()));
  const auto hash = sha256(std::string_view(bytes).substr(kHashed));
  std::memcpy(bytes.data() + kHashAt, hash.data(), hash.size());
  return bytes;
}

PackedSet read_packed(std::string_view bytes, const std::string& file, const ClickOfBytes& click_of) {
  PackReader head(bytes, file);
  const std::uint32_t version = require_whole(bytes, head);
  std::uint64_t samples_at = 0;
  PackReader all(bytes.substr(kHashed), file);
  samples_at = all.number<std::uint64_t>();
  if (samples_at > bytes.size() || samples_at < kHashed + sizeof samples_at)
    all.fail("is damaged: it begins behind its end");
  const PackedSamples samples{bytes.substr(samples_at), click_of};
  PackReader in(bytes.substr(kHashed + sizeof samples_at, samples_at - kHashed - sizeof samples_at), file,
                version);
  PackedSet set;
  set.rig = read_rig(in);
  set.parts.index = read_index(in);
  for (std::size_t left = in.size(1); left > 0; --left) set.parts.banks.push_back(read_bank(in, samples));
  read_models(in, set.parts.tools);
  read_models(in, set.parts.strings);
  for (std::size_t left = in.size(1); left > 0; --left) set.parts.diesels.push_back(read_diesel(in));
  require_complete(set.parts, in);
  require_every_situation(set.parts.index, file);
  require_valid_models(set.parts, file);
  return set;
}

}  // namespace rigsound::config
