// What a person changed in a bank, as a file and as it is played.
#include "rigsound/config/refinement.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "config/sound_set/example_bank.hpp"
#include "replaced.hpp"
#include "rigsound/machine/fields.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::config;

namespace {

Refinement without(std::vector<int> clicks) {
  Refinement refinement;
  refinement.dropped = std::move(clicks);
  return refinement;
}

std::string refusal(int clicks, std::vector<int> dropped) {
  return test::complaint(
      [&] { refined(test::example_bank("a", 48000, clicks), without(std::move(dropped))); });
}

}  // namespace

TEST_CASE("dropped clicks are gone, the others stay in their order, and all is trimmed") {
  const ClickBank bank = test::example_bank("a");
  Refinement refinement = without({3, 1});
  refinement.trim_db = -4.5;
  const ClickBank after = refined(bank, refinement);
  CHECK(after.clicks == std::vector<Click>{bank.clicks[0], bank.clicks[2], bank.clicks[4]});
  CHECK(after.gain_db == -2.5 - 4.5);
  CHECK(refined(bank, without({0, 4})).clicks ==
        std::vector<Click>{bank.clicks[1], bank.clicks[2], bank.clicks[3]});
  CHECK(refined(bank, Refinement{}).clicks == bank.clicks);
  CHECK(refined(bank, without({2, 2})).clicks.size() == 4);
}

TEST_CASE("the controls are worked into what stays") {
  Refinement refinement = without({0});
  refinement.controls.mean_frequency_hz = 25;
  refinement.controls.decay_factor = 2;
  const ClickBank bank = test::example_bank("a"), after = refined(bank, refinement);
  CHECK(after.mean_gap_samples == doctest::Approx(48000 / 25.0));
  CHECK(after.decay == doctest::Approx(2 * bank.decay));
  CHECK(after.clicks.size() == 4);
}

TEST_CASE("a click that is not there is refused, and so are too few that stay") {
  CHECK(refusal(5, {5}) == "dropped: there is no click 5, expected 0 to 4");
  CHECK(refusal(5, {0, -1}) == "dropped: there is no click -1, expected 0 to 4");
  CHECK(refusal(5, {0, 1, 2, 3}) == "dropped: leaves 1 clicks, expected 2 or more");
  CHECK(refusal(5, {0, 1, 2}).empty());
  CHECK(refusal(2, {0}) == "dropped: leaves 1 clicks, expected 2 or more");
  CHECK(refusal(2, {}).empty());
  CHECK(refusal(1, {}).empty());
  CHECK(refusal(1, {0}) == "dropped: leaves 0 clicks, expected 2 or more");
}

TEST_CASE("a refinement is read as it was written; a bank without one stands as analysed") {
  const test::TemporaryFolder folder;
  CHECK_FALSE(load_refinement(folder.path));
  Refinement refinement = without({7, 0, 2399});
  refinement.controls.attack_factor = 0.5F, refinement.controls.mean_amplitude_db = -3;
  refinement.trim_db = 1.25;
  folder.write(kRefinementFile, refinement_text(refinement));
  const auto again = load_refinement(folder.path);
  REQUIRE(again);
  CHECK(again->dropped == refinement.dropped);
  CHECK(again->trim_db == 1.25);
  for (const ControlInfo& control : control_table())
    CHECK(again->controls.*control.field == refinement.controls.*control.field);
}

TEST_CASE("a file that says what cannot be is refused with its key") {
  const test::TemporaryFolder folder;
  const std::string good = refinement_text(without({1}));
  const auto complaint = [&](const std::string& text) {
    folder.write(kRefinementFile, text);
    return test::complaint([&] { load_refinement(folder.path); });
  };
  CHECK(complaint(good).empty());
  CHECK(complaint(test::replaced(good, "\"format\": 1", "\"format\": 2")).find("format") !=
        std::string::npos);
  CHECK(complaint(test::replaced(good, "\"trim_db\": 0.0", "\"trim_db\": 24.5")).find("trim_db: ") !=
        std::string::npos);
  CHECK(complaint(test::replaced(good, "\"decay_factor\": 1.0", "\"decay_factor\": 0.0"))
            .find("controls.decay_factor: ") != std::string::npos);
}
