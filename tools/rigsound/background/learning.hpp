// Recordings of one diesel into takes to learn from. Thread: OFF.
#pragma once

#include <string>
#include <vector>

#include "cli/verb.hpp"
#include "rigsound/analysis/diesel.hpp"

namespace rigsound::tools {

struct LearningOptions {
  std::vector<std::string> inputs, rpm_tracks, clicks;
  std::vector<double> rpm, load;
  std::string name, start, stop;
  bool formula = false;
  analysis::DieselSettings settings;
};

void add_learning_options(cli::Verb& verb, LearningOptions& o);

/// As asked for, or that of the first recording.
std::string background_name(const LearningOptions& o);

/// The recordings with what is known of each; none with --formula. Errors: InputError, and UsageError when
/// the lists of options do not fit the recordings.
std::vector<analysis::DieselTake> read_takes(const LearningOptions& o);

/// The model, named, with its start and stop sounds. Errors: InputError.
analysis::LearnedDiesel learn(const std::vector<analysis::DieselTake>& takes, const LearningOptions& o);

}  // namespace rigsound::tools
