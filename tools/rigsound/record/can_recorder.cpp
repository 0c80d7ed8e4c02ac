#include <fmt/format.h>

#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "record/bus_recorders.hpp"
#include "record/opening.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/log/candump_writer.hpp"

namespace rigsound::tools {
namespace {

/// The file all interfaces write to, once all of them are open.
struct SharedLog {
  std::mutex mutex;
  std::optional<log::CandumpWriter> writer;
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
    if (!log_.writer) return;
    const can::CanCounters c = bus_.counters();
    fmt::print(stderr, "{}: {} frames, {} dropped by the kernel\n", name_, c.frames, c.dropped);
  }

  void require_open() { opening_.require(); }

 private:
  void frames(const can::Arrival* first, std::size_t count) override {
    const std::lock_guard<std::mutex> lock(log_.mutex);
    if (!log_.writer) return;
    for (std::size_t i = 0; i < count; ++i)
      log_.writer->write({static_cast<std::int64_t>(first[i].realtime_s * 1e9), name_, first[i].frame});
    log_.entries += count;
  }
  void up() override {
    fmt::print(stderr, "{}: recording\n", name_);
    opening_.worked();
  }
  void down(const std::string& why) override { fmt::print(stderr, "{}: down: {}\n", name_, why); }
  void notice(const std::string& text) override {
    if (!opening_.failed(text)) fmt::print(stderr, "{}\n", text);
  }

  std::string name_;
  SharedLog& log_;
  Opening opening_;
  can::CanBus bus_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

class CanRecorder : public BusRecorder {
 public:
  // Frames wait in the kernel until the file is there.
  CanRecorder(const config::Rig& rig, const std::filesystem::path& file) {
    const std::lock_guard<std::mutex> lock(log_.mutex);
    for (const can::CanOptions& bus : rig.can) interfaces_.push_back(std::make_unique<Interface>(bus, log_));
    for (const auto& interface : interfaces_) interface->require_open();
    log_.writer.emplace(file);
  }
  void flush() override {
    const std::lock_guard<std::mutex> lock(log_.mutex);
    log_.writer->flush();
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
