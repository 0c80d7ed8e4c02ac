// A daemon that tells its figures and knows nothing else.
#pragma once

#include <string>
#include <vector>

#include "commands.hpp"

namespace rigsound::test {

struct Scraped : daemon::DaemonControl {
  daemon::Snapshot snapshot() const override {
    daemon::Snapshot s;
    s.blocks = blocks;
    s.reloads = reloads;
    return s;
  }
  daemon::Snapshot scrape() override {
    ++scrapes;
    return snapshot();
  }
  std::uint64_t ask_reload() override { return 1; }
  const daemon::ReloadResult* reload_result(std::uint64_t) const override { return nullptr; }
  void set_muted(bool) override {}
  void reset_exposure() override {}
  std::vector<std::string> boom_names() const override { return {}; }
  DrillControls controls(int) const override { return {}; }
  void set_control(int, const ControlInfo&, double) override {}
  std::vector<std::string> rock_names() const override { return {}; }
  bool holds(SignalId) const override { return false; }
  void hold(SignalId, double) override {}
  void release(SignalId) override {}

  int scrapes = 0;
  std::uint64_t blocks = 0, reloads = 0;
};

}  // namespace rigsound::test
