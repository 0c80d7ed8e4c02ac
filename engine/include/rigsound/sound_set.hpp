// Everything the engine can sound like: banks, which of them serves what, tools, engine backgrounds.
#pragma once

#include <string>
#include <vector>

#include "rigsound/click_bank.hpp"
#include "rigsound/diesel_model.hpp"
#include "rigsound/machine/situation.hpp"
#include "rigsound/string_model.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound {

/// One line of soundset.toml: this bank serves that situation, rod count and rock.
struct BankUse {
  Situation situation = Situation::kNormal;
  int rods = 0;          ///< rod count the bank was recorded with; 0: any
  int rock = -1;         ///< index into SoundSet::rocks; -1: any
  int bank = 0;          ///< index into SoundSet::banks
  double feed_bar = -1;  ///< feed pressure it was recorded at; negative: its situation's place in the scene
  double percussion_bar = 0;  ///< percussion pressure it was recorded at; 0: the scene's nominal one
};

/// How the clicks of one rod count and rock change with the feed pressure, learned from a series of banks:
/// slopes in 1/bar. Beyond its outermost banks they go on so.
struct FeedLaws {
  int rods = 0;                                       ///< 0: any
  int rock = -1;                                      ///< -1: any
  double ln_gap = 0, ln_level = 0, ln_decay = 0;      ///< of T_0, B, alpha_d
  double gap_variation = 0, amplitude_variation = 0;  ///< of sigma_T / T_0, sigma_B / B
  double tilt_db_per_octave = 0;                      ///< of the clicks' spectrum
};

struct Rock {
  std::string name;
  double stiffness = 2e8;  ///< N/m, loading stiffness of the bit in it
};

struct SoundSet {
  std::vector<ClickBank> banks;
  std::vector<BankUse> uses;
  std::vector<FeedLaws> laws;
  std::vector<Rock> rocks;
  std::vector<ToolModel> tools;      ///< bars
  std::vector<StringModel> strings;  ///< drill strings
  std::vector<DieselModel> diesels;
};

}  // namespace rigsound
