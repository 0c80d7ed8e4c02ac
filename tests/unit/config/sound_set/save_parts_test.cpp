// Sets and banks that are written: how far it is, and how many clicks a bank may have.
#include <doctest/doctest.h>

#include <vector>

#include "config/sound_set/example_bank.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_parts.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

TEST_CASE("the share of a set that is written or read goes up by a bank to all of it") {
  const test::TemporaryFolder folder;
  config::SoundSetParts parts;
  for (int s = 0; s < kSituationCount; ++s) {
    const std::string name = "bank" + std::to_string(s);
    parts.banks.push_back({test::example_bank(name), {}});
    config::BankEntry& entry = parts.index.banks.emplace_back();
    entry.name = name, entry.situation = static_cast<Situation>(s);
  }
  std::vector<double> written, read;
  config::save_parts(folder.path / "set", parts, [&](double share) { written.push_back(share); });
  config::load_parts(folder.path / "set", [&](double share) { read.push_back(share); });
  REQUIRE(written.size() == kSituationCount);
  for (int s = 0; s < kSituationCount; ++s)
    CHECK(written[static_cast<std::size_t>(s)] == (s + 1.0) / kSituationCount);
  CHECK(read == written);
}

TEST_CASE("a bank that is saved has 1 to 2400 clicks") {
  const test::TemporaryFolder set;
  const auto said = [&](std::size_t clicks) {
    ClickBank bank = test::example_bank("a");
    bank.clicks.assign(clicks, {1, 0, 0});
    return test::complaint([&] { config::save_bank(set.path, bank, {}); });
  };
  const std::string place = (set.path / "banks/a").string() + ": clicks: ";
  CHECK(said(0) == place + "0 clicks, expected 1 to 2400");
  CHECK(said(1).empty());
  CHECK(said(2400).empty());
  CHECK(said(2401) == place + "2401 clicks, expected 1 to 2400");
}
