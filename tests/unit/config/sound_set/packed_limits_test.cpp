// What the head of a packed set may say of the rest, and what its index may name.
#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>

#include "config/sound_set/example_bank.hpp"
#include "rigsound/config/packed_set.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/pack/sha256.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

constexpr std::size_t kSizeAt = 16, kDigestAt = 24, kBodyAt = 56;  // as packed_set.hpp lays the file out

config::PackedSet one_bank() {
  config::PackedSet set;
  set.parts = test::one_bank_set("a");
  return set;
}

std::string said_of_bytes(const std::string& bytes) {
  return test::complaint([&] { config::read_packed(bytes, "x"); });
}
std::string said_of_set(const config::PackedSet& set) { return said_of_bytes(config::packed(set)); }

bool is_too_short(const std::string& bytes) {
  return said_of_bytes(bytes).find("it is too short for what it says it holds") != std::string::npos;
}

std::uint64_t samples_begin(const std::string& bytes) {
  std::uint64_t at = 0;
  std::memcpy(&at, bytes.data() + kBodyAt, sizeof at);
  return at;
}

/// With samples that begin elsewhere, and the hash of that.
std::string beginning_at(std::string bytes, std::uint64_t at) {
  std::memcpy(bytes.data() + kBodyAt, &at, sizeof at);
  const auto hash = config::sha256(std::string_view(bytes).substr(kBodyAt));
  std::memcpy(bytes.data() + kDigestAt, hash.data(), hash.size());
  return bytes;
}

const std::string kOthers = "x: is damaged: it names other tools and backgrounds than it holds";

}  // namespace

TEST_CASE("samples begin behind the head and before the end of the file") {
  const std::string bytes = config::packed(one_bank());
  CHECK(said_of_bytes(bytes).empty());
  const std::string outside = "x: is damaged: it begins behind its end";
  CHECK(said_of_bytes(beginning_at(bytes, 0)) == outside);
  CHECK(said_of_bytes(beginning_at(bytes, kBodyAt + 7)) == outside);
  CHECK(said_of_bytes(beginning_at(bytes, bytes.size() + 1)) == outside);
  CHECK(said_of_bytes(beginning_at(bytes, UINT64_MAX)) == outside);
  CHECK(is_too_short(beginning_at(bytes, kBodyAt + 8)));  // an index of nothing
  CHECK(said_of_bytes(beginning_at(bytes, bytes.size())) == "x: is damaged: a click lies behind its end");
}

TEST_CASE("an index that goes on where the samples begin is too short") {
  const std::string bytes = config::packed(one_bank());
  const std::uint64_t begin = samples_begin(bytes);
  for (std::uint64_t less = 64; less <= 256; less += 64)
    CHECK(is_too_short(beginning_at(bytes, begin - less)));
}

TEST_CASE("samples begin at the first multiple of 64 bytes behind the index") {
  for (int letters = 1; letters <= 64; ++letters) {
    config::PackedSet set = one_bank();
    const std::uint64_t before = samples_begin(config::packed(set));
    set.parts.banks[0].provenance.settings.assign(static_cast<std::size_t>(letters), 'x');
    const std::uint64_t behind = samples_begin(config::packed(set));
    CHECK(behind % 64 == 0);
    CHECK(behind - before <= 64);
    if (letters == 64) CHECK(behind - before == 64);
  }
}

TEST_CASE("a packed bank has 1 to 2400 clicks") {
  config::PackedSet set = one_bank();
  std::vector<Click>& clicks = set.parts.banks[0].bank.clicks;
  const Click one = {1, 0, 0};
  clicks.assign(1, one);
  CHECK(said_of_set(set).empty());
  clicks.assign(2400, one);
  CHECK(said_of_set(set).empty());
  clicks.assign(2401, one);
  CHECK(said_of_set(set) == "x: holds a bank of 2401 clicks, expected 1 to 2400");
  clicks.assign(1, {2, 0, 0});
  CHECK(said_of_set(set) == "x: holds a click that is not of unit norm");
}

TEST_CASE("what a packed index names is in the file, and nothing else is") {
  CHECK(said_of_set(one_bank()).empty());
  config::PackedSet other = one_bank();
  other.parts.index.banks[2].name = "b";
  CHECK(said_of_set(other) == "x: is damaged: it names bank b and does not hold it");
  other = one_bank();
  other.parts.index.tools = {{"hex25"}};
  CHECK(said_of_set(other) == kOthers);
  other.parts.tools.resize(1), other.parts.tools[0].name = "hex25";
  CHECK(said_of_set(other).empty());
  other.parts.index.tools[0].kind = config::SteelKind::kString;
  CHECK(said_of_set(other) == kOthers);
  other = one_bank();
  other.parts.index.tools = {{"rods38", config::SteelKind::kString}};
  CHECK(said_of_set(other) == kOthers);
  other.parts.strings.resize(1), other.parts.strings[0].name = "rods38";
  CHECK(said_of_set(other).empty());
  other = one_bank();
  other.parts.index.backgrounds = {"diesel"};
  CHECK(said_of_set(other) == kOthers);
  other.parts.diesels = {default_diesel()}, other.parts.diesels[0].name = "diesel";
  CHECK(said_of_set(other).empty());
}

TEST_CASE("versions 1 and 2 of a packed set are known") {
  std::string bytes = config::packed(one_bank());
  CHECK(bytes[8] == 2);
  bytes[8] = 0;
  CHECK(said_of_bytes(bytes) == "x: is of version 0, expected 1...2");
  bytes[8] = 3;
  CHECK(said_of_bytes(bytes) == "x: is of version 3, expected 1...2");
  bytes[8] = 2, bytes[kSizeAt] = static_cast<char>(bytes[kSizeAt] + 1);
  CHECK(said_of_bytes(bytes) == "x: is cut off or has grown since it was packed");
}
