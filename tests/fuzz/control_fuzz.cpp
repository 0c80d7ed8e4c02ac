// Any text as a line of the control socket, and as a request for the metrics: one line of JSON comes back, or
// one HTTP answer; what is set is a value that its signal or control takes.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "fuzz_target.hpp"
#include "metrics_page.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

class NoDaemon : public DaemonControl {
 public:
  Snapshot snapshot() const override { return {}; }
  Snapshot scrape() override { return {}; }
  std::uint64_t ask_reload() override { return 1; }
  const ReloadResult* reload_result(std::uint64_t) const override { return &reloaded_; }
  void set_muted(bool) override {}
  void reset_exposure() override {}
  std::vector<std::string> boom_names() const override { return {"left", "right"}; }
  DrillControls controls(int) const override { return {}; }
  void set_control(int boom, const ControlInfo& control, double value) override {
    require(boom >= 0 && boom < 2 && control.takes(value));
  }
  std::vector<std::string> rock_names() const override { return {"granite"}; }
  bool holds(SignalId) const override { return true; }
  void hold(SignalId id, double value) override { require(id.boom < 2 && info(id.signal).takes(value)); }
  void release(SignalId id) override { require(id.boom < 2); }

 private:
  static void require(bool good) {
    if (!good) std::abort();
  }

  ReloadResult reloaded_;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string request(reinterpret_cast<const char*>(data), size);
  NoDaemon daemon;
  ClientState client;
  std::string line = answer(request, daemon, client);
  if (line.empty()) line = late_answer(daemon, client);
  if (line.empty() || line.find('\n') != line.size() - 1) std::abort();
  if (!nlohmann::json::accept(line)) std::abort();
  if (MetricsPage(daemon).answer(request).compare(0, 9, "HTTP/1.1 ") != 0) std::abort();
  return 0;
}
