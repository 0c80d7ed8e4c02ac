#include <sstream>

#include "packed_part.hpp"
#include "packed_rig.hpp"
#include "routes.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {
namespace {

/// "0,2,5"
std::vector<int> numbers_of(const std::string& list) {
  std::vector<int> numbers;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) {
    std::size_t used = 0;
    try {
      numbers.push_back(std::stoi(word, &used));
    } catch (const std::exception&) {
      used = 0;
    }
    if (used == 0 || used != word.size())
      throw ApiError(400, "clicks: expected whole numbers separated by commas");
  }
  return numbers;
}

Answer rigset(const Workplace& place, const Request& request) {
  const auto asked = [&](const char* name) {
    const auto found = request.query.find(name);
    return found == request.query.end() ? std::string() : found->second;
  };
  const std::string bank = asked("bank"), background = asked("background");
  if (!bank.empty()) return bytes_answer(packed_bank(place, bank, numbers_of(asked("clicks"))));
  if (!background.empty()) return bytes_answer(packed_background(place, background));
  return bytes_answer(packed_sound_set(place, asked("rig") == "1" ? PackRig::kEmbedded : PackRig::kLeftOut));
}

}  // namespace

void add_sound_set_routes(Router& router, Workplace& place) {
  router.add("GET", "/sound_set", [&place](const Request&) { return json_answer(sound_set_json(place)); });
  router.add("GET", "/sound_set.rigset", [&place](const Request& request) { return rigset(place, request); });
  router.add("GET", "/rig", [&place](const Request&) { return json_answer(rig_description(place)); });
}

}  // namespace rigsound::studio
