#include "rig_loader.hpp"

#include <exception>
#include <utility>

namespace rigsound::daemon {

void RigLoader::begin(Load load) {
  job_.begin([load = std::move(load)] {
    Outcome outcome;
    try {
      outcome.rig = load(outcome.not_applied);
    } catch (const std::exception& error) {
      outcome.error = error.what();
    }
    return outcome;
  });
}

}  // namespace rigsound::daemon
