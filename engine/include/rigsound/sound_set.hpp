// Everything the engine can sound like: banks, which of them serves what, tools, engine backgrounds.
#pragma once

#include <string>
#include <vector>

#include "rigsound/click_bank.hpp"
#include "rigsound/diesel_model.hpp"
#include "rigsound/machine/situation.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound {

/// One line of soundset.toml: this bank serves that situation, rod count and rock.
struct BankUse {
  Situation situation = Situation::kNormal;
  int rods = 0;   ///< rod count the bank was recorded with; 0: any
  int rock = -1;  ///< index into SoundSet::rocks; -1: any
  int bank = 0;   ///< index into SoundSet::banks
};

struct SoundSet {
  std::vector<ClickBank> banks;
  std::vector<BankUse> uses;
  std::vector<std::string> rocks;
  std::vector<ToolModel> tools;
  std::vector<DieselModel> diesels;
};

}  // namespace rigsound
