// What a reload takes over, and what it leaves to a restart.
#include "loaded_rig.hpp"

#include <doctest/doctest.h>

#include "daemon/running_daemon.hpp"

using namespace rigsound;
using namespace rigsound::daemon;
using namespace rigsound::test;

namespace {

using Keys = std::vector<std::string>;

Keys keys_of(const Keys& not_applied) {
  Keys keys;
  for (const std::string& line : not_applied) keys.push_back(line.substr(0, line.find(':')));
  return keys;
}

}  // namespace

TEST_CASE("a reload without changes leaves nothing to a restart") {
  const SmallRig rig;
  const LoadedRig running = load(rig.folder.path / "rig.toml", config::Buses::kRead);
  Keys not_applied;
  const LoadedRig again = load_for_reload(running.rig, config::Buses::kRead, not_applied);
  CHECK(not_applied.empty());
  CHECK(again.fingerprint == running.fingerprint);
  CHECK(again.sounds.banks == Keys{"a"});
}

TEST_CASE("a reload keeps the card and the sockets, says so, and takes the rest") {
  const SmallRig rig;
  const LoadedRig running = load(rig.folder.path / "rig.toml", config::Buses::kRead);
  rig.folder.write(
      "rig.toml",
      "[audio]\ndevice = \"hw:7\"\nrate = 44100\nblock = 128\nperiods = 5\nchannels = 4\nformat = "
      "\"s16\"\n[sound]\nset = \"set\"\n[control]\nsocket = \"" +
          (rig.folder.path / "other").string() +
          "\"\nmode = \"0600\"\nmetrics = \"127.0.0.1:9\"\n[mix]\ndrill_db = -7\n");
  Keys not_applied;
  const LoadedRig loaded = load_for_reload(running.rig, config::Buses::kRead, not_applied);
  CHECK(keys_of(not_applied) == Keys{"audio.device", "audio.rate", "audio.block", "audio.periods",
                                     "audio.channels", "audio.format", "control.socket", "control.mode",
                                     "control.metrics"});
  CHECK(not_applied[1] == "audio.rate: 48000, wanted 44100");
  CHECK(loaded.rig.audio.device == "null");
  CHECK(loaded.rig.audio.rate == 48000);
  CHECK(loaded.rig.audio.format == running.rig.audio.format);
  CHECK(loaded.rig.control.socket == running.rig.control.socket);
  CHECK(loaded.rig.engine.sample_rate == 48000);
  CHECK(loaded.rig.engine.block == running.rig.engine.block);
  CHECK(loaded.rig.engine.channels == running.rig.engine.channels);
  CHECK(loaded.rig.engine.mix.drill_db == -7);
  CHECK(loaded.fingerprint != running.fingerprint);
}
