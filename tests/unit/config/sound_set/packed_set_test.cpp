// A packed sound set gives back what went in, and a damaged or hostile one is refused.
#include "rigsound/config/packed_set.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <fstream>

#include "config/sound_set/example_bank.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/pack/sha256.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

constexpr std::size_t kHashAt = 24, kHashed = 56;  // as packed_set.hpp lays the file out

std::string hex(const std::string& bytes) {
  std::string text;
  for (const std::uint8_t byte : config::sha256(bytes)) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

config::PackedSet example() {
  config::PackedSet set;
  set.parts.banks.push_back({test::example_bank("a", 44100), {"a.wav", "00", "denoise=1", "test"}});
  set.parts.banks.push_back({test::example_bank("b", 48000), {}});
  for (int s = 0; s < kSituationCount; ++s) {
    config::BankEntry& entry = set.parts.index.banks.emplace_back();
    entry.name = s % 2 == 0 ? "a" : "b", entry.situation = static_cast<Situation>(s), entry.gain_db = -s;
  }
  set.parts.index.rocks = {{"granite", 3e8}};
  config::LawsEntry& laws = set.parts.index.laws.emplace_back();
  laws.rock = "granite", laws.laws.ln_gap = 0.001;
  ToolModel tool;
  tool.name = "hex25";
  StringModel rods, thicker;
  rods.name = "rods38", thicker.name = "rods45";
  DieselModel diesel = default_diesel();
  diesel.name = "diesel";
  diesel.stop = {0.5F, -0.25F};
  set.parts.index.tools = {
      {"rods38", config::SteelKind::kString}, {"hex25"}, {"rods45", config::SteelKind::kString}};
  set.parts.index.backgrounds = {"diesel"};
  set.parts.tools = {tool}, set.parts.strings = {rods, thicker}, set.parts.diesels = {diesel};
  set.rig = config::PackedRig{};
  set.rig->engine.seed = 18446744073709551615ULL;
  set.rig->engine.scene.overfeed_bar = 131;
  set.rig->boom_tools = {"hex25"};
  return set;
}

/// The hash made right again after `bytes` were changed: what comes then is for the reader alone.
std::string rehashed(std::string bytes) {
  const std::uint64_t size = bytes.size();
  std::memcpy(bytes.data() + 16, &size, sizeof size);
  const auto hash = config::sha256(std::string_view(bytes).substr(kHashed));
  std::memcpy(bytes.data() + kHashAt, hash.data(), hash.size());
  return bytes;
}

}  // namespace

TEST_CASE("SHA-256 as FIPS 180-4 and its examples have it") {
  CHECK(hex("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hex("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(hex(std::string(1000000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("what is packed is read back, to the last bit") {
  const config::PackedSet set = example();
  const std::string bytes = config::packed(set);
  REQUIRE(config::is_packed(bytes));
  const config::PackedSet again = config::read_packed(bytes, "x.rigset");
  CHECK(config::packed(again) == bytes);
  CHECK(again.parts.banks[0].bank.clicks == set.parts.banks[0].bank.clicks);
  CHECK(again.parts.banks[0].provenance.settings == "denoise=1");
  CHECK(again.parts.index.banks[4].gain_db == -4);
  CHECK(again.parts.index.rocks[0].stiffness == 3e8);
  CHECK(again.parts.index.laws[0].laws.ln_gap == 0.001);
  CHECK(again.parts.diesels[0].stop == set.parts.diesels[0].stop);
  REQUIRE(again.rig);
  CHECK(again.rig->engine.seed == 18446744073709551615ULL);
  CHECK(again.rig->engine.scene.overfeed_bar == 131);
  CHECK(again.rig->boom_tools == std::vector<std::string>{"hex25"});
  const SoundSet sounds = config::sound_set_of(again.parts, 48000);
  REQUIRE(sounds.banks.size() == 5);  // another trim is another bank
  for (int s = 0; s < kSituationCount; ++s) {
    CHECK(sounds.banks[s].gain_db == set.parts.banks[s % 2].bank.gain_db - s);
    CHECK(sounds.banks[s].sample_rate == 48000);
    CHECK(sounds.banks[s].clicks == sounds.banks[s % 2].clicks);
  }
  CHECK(sounds.banks[1].clicks == set.parts.banks[1].bank.clicks);
  CHECK(sounds.strings[0].name == "rods38");
}

TEST_CASE("a set that was packed before limiters looked ahead still plays, and looks ahead as by default") {
  config::PackedSet set = example();
  set.rig->engine.mix.lookahead_s = 0.0171;
  std::string bytes = config::packed(set);
  char lookahead[sizeof(double)];
  std::memcpy(lookahead, &set.rig->engine.mix.lookahead_s, sizeof lookahead);
  const std::size_t at = bytes.find(std::string(lookahead, sizeof lookahead));
  REQUIRE(at != std::string::npos);
  std::uint64_t samples_at = 0;
  std::memcpy(&samples_at, bytes.data() + kHashed, sizeof samples_at);
  bytes.insert(samples_at, sizeof lookahead, '\0');  // where the samples begin stays
  bytes.erase(at, sizeof lookahead);
  bytes[8] = 1;
  const config::PackedSet old = config::read_packed(rehashed(bytes), "old.rigset");
  CHECK(old.rig->engine.mix.lookahead_s == EngineOptions{}.mix.lookahead_s);
  CHECK(old.rig->engine.scene.overfeed_bar == 131);
  CHECK(old.rig->boom_tools == set.rig->boom_tools);
  CHECK(old.parts.banks[1].bank.clicks == set.parts.banks[1].bank.clicks);
}

TEST_CASE("clicks lie at multiples of 64 bytes, as a reader wants them that plays them where they lie") {
  const config::PackedSet set = example();
  const std::string bytes = config::packed(set);
  std::uint64_t samples_at = 0;
  std::memcpy(&samples_at, bytes.data() + kHashed, sizeof samples_at);
  CHECK(samples_at % 64 == 0);
  const Click& first = set.parts.banks[0].bank.clicks[0];
  CHECK(std::memcmp(bytes.data() + samples_at, first.data(), first.size() * sizeof(float)) == 0);
}

TEST_CASE("a packed file is played as it was read, whoever writes over it then") {
  const test::TemporaryFolder folder;
  const config::PackedSet set = example();
  const std::filesystem::path file = folder.write("x.rigset", config::packed(set));
  const config::PackedSet loaded = config::load_packed(file);
  std::ofstream(file, std::ios::trunc) << "as cp over it does: the same file, cut off";
  for (std::size_t b = 0; b < set.parts.banks.size(); ++b)
    CHECK(loaded.parts.banks[b].bank.clicks == set.parts.banks[b].bank.clicks);
  CHECK_THROWS_AS(config::load_packed(file), InputError);
}

TEST_CASE("clicks of a packed file are in memory once, and stay when all else of the set is gone") {
  const test::TemporaryFolder folder;
  const config::PackedSet set = example();
  const std::filesystem::path file = folder.write("x.rigset", config::packed(set));
  std::vector<Click> clicks;
  {
    const config::PackedSet loaded = config::load_packed(file);
    const std::vector<ClickBank> banks = config::sound_set_of(loaded.parts, 48000).banks;
    CHECK(banks[1].clicks[0].data() == loaded.parts.banks[1].bank.clicks[0].data());
    CHECK(banks[3].clicks[0].data() == banks[1].clicks[0].data());  // another trim
    clicks = banks[1].clicks;
  }
  CHECK(clicks == set.parts.banks[1].bank.clicks);
}

TEST_CASE("clicks that lie where no float may are copied to where one may") {
  const test::TemporaryFolder folder;
  const config::PackedSet set = example();
  std::string bytes = config::packed(set);
  std::uint64_t samples_at = 0;
  std::memcpy(&samples_at, bytes.data() + kHashed, sizeof samples_at);
  bytes.insert(samples_at++, 1, '\0');
  std::memcpy(bytes.data() + kHashed, &samples_at, sizeof samples_at);
  const config::PackedSet loaded = config::load_packed(folder.write("odd.rigset", rehashed(bytes)));
  for (std::size_t b = 0; b < set.parts.banks.size(); ++b) {
    CHECK(loaded.parts.banks[b].bank.clicks == set.parts.banks[b].bank.clicks);
    for (const Click& click : loaded.parts.banks[b].bank.clicks)
      CHECK(reinterpret_cast<std::uintptr_t>(click.data()) % alignof(float) == 0);
  }
}

TEST_CASE("a bank without clicks is refused") {
  config::PackedSet set = example();
  set.parts.banks[0].bank.clicks.clear();
  CHECK_THROWS_WITH_AS(config::read_packed(config::packed(set), "x"),
                       "x: holds a bank of 0 clicks, expected 1 to 2400", InputError);
}

TEST_CASE("a folder packed and unpacked is the folder again") {
  const test::TemporaryFolder folder;
  config::save_parts(folder.path / "set", example().parts);
  config::PackedSet set;
  set.parts = config::load_parts(folder.path / "set");
  config::save_parts(folder.path / "again", config::read_packed(config::packed(set), "x").parts);
  for (const std::string file : {"soundset.toml", "banks/a/bank.json", "banks/b/clicks.wav",
                                 "tools/hex25.json", "tools/rods38.json", "backgrounds/diesel/stop.wav"}) {
    const bool same =
        test::content(folder.path / "set" / file) == test::content(folder.path / "again" / file);
    CHECK_MESSAGE(same, file);
  }
  CHECK_THROWS_AS(config::save_parts(folder.path / "set", set.parts), InputError);
}

TEST_CASE("cut off, damaged or of another kind: refused with one line") {
  const std::string bytes = config::packed(example());
  const auto complaint = [](const std::string& given) {
    try {
      config::read_packed(given, "x.rigset");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(complaint("") == "x.rigset: is no packed sound set, expected one that rigsound pack wrote");
  CHECK(complaint(bytes.substr(0, 20)).find("cut off") != std::string::npos);
  CHECK(complaint(bytes.substr(0, bytes.size() - 1)).find("cut off") != std::string::npos);
  std::string other = bytes;
  other[8] = 9;
  CHECK(complaint(other) == "x.rigset: is of version 9, expected 1...2");
  other = bytes;
  other[bytes.size() / 2] ^= 1;
  CHECK(complaint(other).find("SHA-256") != std::string::npos);
}

TEST_CASE("with a right hash every length is still mistrusted: refused, or a set that can be played") {
  config::PackedSet small = example();
  small.parts.index.backgrounds.clear(), small.parts.diesels.clear();  // its many numbers say nothing new
  const std::string bytes = config::packed(small);
  std::uint64_t samples_at = 0;
  std::memcpy(&samples_at, bytes.data() + kHashed, sizeof samples_at);
  int refused = 0, read = 0;
  const auto attempt = [&](const std::string& given) {
    try {
      config::sound_set_of(config::read_packed(given, "x").parts, 48000);
      ++read;
    } catch (const InputError&) {
      ++refused;
    }
  };
  for (std::size_t at = kHashed; at < samples_at; at += 5)
    for (const int value : {1, 255}) {
      std::string other = bytes;
      other[at] = static_cast<char>(value);
      attempt(rehashed(other));
    }
  for (std::size_t size = kHashed; size < bytes.size(); size += 997) attempt(rehashed(bytes.substr(0, size)));
  CHECK(refused > 100);
  CHECK(read > 50);  // a changed letter of a provenance harms nothing
}
