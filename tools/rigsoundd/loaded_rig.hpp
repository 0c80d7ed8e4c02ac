// A rig read from disk, with the engine built from it: all that a start or a reload needs to succeed.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "osc_output.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/engine.hpp"

namespace rigsound::daemon {

/// What the indices of an engine's view mean.
struct SoundNames {
  std::vector<std::string> banks, rocks;
};

struct LoadedRig {
  config::Rig rig;
  SoundNames sounds;
  std::unique_ptr<Engine> engine;
  std::string fingerprint;
  OscOutput osc_output;
};

/// Errors: InputError, DeviceError when a target of OSC is no address. Thread: CT.
LoadedRig load(const std::filesystem::path& file, config::Buses buses);

/// A fresh engine for a rig already read; its sounds are read again. Errors as of load(). Thread: any.
LoadedRig build(config::Rig rig);

/// The same as load() for a daemon that runs `running`: what only a restart can change keeps its running
/// value and is listed in `not_applied`, `KEY: OLD, wanted NEW`. Errors as of load(). Thread: any.
LoadedRig load_for_reload(const config::Rig& running, config::Buses buses,
                          std::vector<std::string>& not_applied);

}  // namespace rigsound::daemon
