#include <fmt/format.h>

#include <cstdio>
#include <mutex>
#include <thread>
#include <vector>

#include "record/bus_recorders.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/log/candump_writer.hpp"

namespace rigsound::tools {
namespace {

/// The file all interfaces write to.
struct SharedLog {
  explicit SharedLog(const std::filesystem::path& file) : writer(file) {}
  std::mutex mutex;
  log::CandumpWriter writer;
  std::uint64_t entries = 0;
};

class Interface : private can::CanListener {
 public:
  Interface(const can::CanOptions& options, SharedLog& log)
      : name_(options.interface),
        log_(log),
        bus_({options.interface, options.fd, true, {}}, *this),
        thread_([this] { bus_.run(stop_); }) {}
  ~Interface() override {
    stop_ = true;
    thread_.join();
    const can::CanCounters c = bus_.counters();
    fmt::print(stderr, "{}: {} frames, {} dropped by the kernel\n", name_, c.frames, c.dropped);
  }

 private:
  void frames(const can::Arrival* first, std::size_t count) override {
    const std::lock_guard<std::mutex> lock(log_.mutex);
    for (std::size_t i = 0; i < count; ++i)
      log_.writer.write({static_cast<std::int64_t>(first[i].realtime_s * 1e9), name_, first[i].frame});
    log_.entries += count;
  }
  void up() override { fmt::print(stderr, "{}: recording\n", name_); }
  void down(const std::string& why) override { fmt::print(stderr, "{}: down: {}\n", name_, why); }
  void notice(const std::string& text) override { fmt::print(stderr, "{}\n", text); }

  std::string name_;
  SharedLog& log_;
  can::CanBus bus_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

class CanRecorder : public BusRecorder {
 public:
  CanRecorder(const config::Rig& rig, const std::filesystem::path& file) : log_(file) {
    for (const can::CanOptions& bus : rig.can) interfaces_.push_back(std::make_unique<Interface>(bus, log_));
  }
  void flush() override {
    const std::lock_guard<std::mutex> lock(log_.mutex);
    log_.writer.flush();
  }
  std::uint64_t entries() const override {
    const std::lock_guard<std::mutex> lock(log_.mutex);
    return log_.entries;
  }

 private:
  mutable SharedLog log_;
  std::vector<std::unique_ptr<Interface>> interfaces_;
};

}  // namespace

std::unique_ptr<BusRecorder> record_can(const config::Rig& rig, const std::filesystem::path& file) {
  return std::make_unique<CanRecorder>(rig, file);
}

}  // namespace rigsound::tools
