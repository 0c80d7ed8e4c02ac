// Rigs of a few lines, read or refused.
#pragma once

#include <filesystem>
#include <string>

#include "rigsound/config/rig.hpp"
#include "temporary_folder.hpp"

namespace rigsound::test {

inline const std::filesystem::path kDemo = std::filesystem::path(RIGSOUND_CONFIG) / "rigs/demo.toml";
inline const std::filesystem::path kDbc = std::filesystem::path(RIGSOUND_CONFIG) / "dbc/rig.dbc";

/// A bus with one signal of the bundled DBC.
inline std::string minimal() {
  return "[[can]]\ninterface = \"can0\"\ndbc = \"" + kDbc.string() +
         "\"\n[can.signals]\nengine_rpm = \"EEC1.EngSpeed\"\n";
}

inline config::Rig loaded(const std::string& text) {
  TemporaryFolder folder;
  return config::load_rig(folder.write("rig.toml", text));
}

/// What is said of it, behind the name of its file; empty: it is read.
inline std::string refusal(const std::string& text) {
  TemporaryFolder folder;
  const std::filesystem::path file = folder.write("rig.toml", text);
  const std::string said = complaint([&] { config::load_rig(file); });
  return said.rfind(file.string(), 0) == 0 ? said.substr(file.string().size()) : said;
}

inline const SafetyRule& rule(const config::Rig& rig, Signal s) {
  return rig.safety.rule[static_cast<std::size_t>(s)];
}

}  // namespace rigsound::test
