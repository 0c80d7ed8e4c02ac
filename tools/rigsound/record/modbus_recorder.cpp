#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <mutex>
#include <thread>
#include <vector>

#include "record/bus_recorders.hpp"
#include "rigsound/log/modbus_capture_writer.hpp"
#include "rigsound/modbus/modbus_link.hpp"

namespace rigsound::tools {
namespace {

/// The file all links write to.
struct SharedCapture {
  explicit SharedCapture(const std::filesystem::path& file) : writer(file) {}
  std::mutex mutex;
  log::ModbusCaptureWriter writer;
  std::uint64_t entries = 0;
};

std::int64_t realtime_ns() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

class Link : private modbus::ModbusListener {
 public:
  Link(const modbus::ModbusOptions& options, SharedCapture& capture)
      : name_(options.address),
        capture_(capture),
        link_(modbus::make_modbus_link(options, *this)),
        thread_([this] { link_->run(stop_); }) {}
  ~Link() override {
    stop_ = true;
    thread_.join();
  }

 private:
  void readings(const std::vector<modbus::Reading>&) override {}
  void exchange(const modbus::Exchange& exchange) override {
    const std::lock_guard<std::mutex> lock(capture_.mutex);
    capture_.writer.write(realtime_ns(), exchange);
    ++capture_.entries;
  }
  void up() override { fmt::print(stderr, "{}: recording\n", name_); }
  void down(const std::string& why) override { fmt::print(stderr, "{}: down: {}\n", name_, why); }
  void notice(const std::string& text) override { fmt::print(stderr, "{}\n", text); }

  std::string name_;
  SharedCapture& capture_;
  std::unique_ptr<modbus::ModbusLink> link_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

class ModbusRecorder : public BusRecorder {
 public:
  ModbusRecorder(const config::Rig& rig, const std::filesystem::path& file) : capture_(file) {
    for (const modbus::ModbusOptions& link : rig.modbus)
      links_.push_back(std::make_unique<Link>(link, capture_));
  }
  void flush() override {
    const std::lock_guard<std::mutex> lock(capture_.mutex);
    capture_.writer.flush();
  }
  std::uint64_t entries() const override {
    const std::lock_guard<std::mutex> lock(capture_.mutex);
    return capture_.entries;
  }

 private:
  mutable SharedCapture capture_;
  std::vector<std::unique_ptr<Link>> links_;
};

}  // namespace

std::unique_ptr<BusRecorder> record_modbus(const config::Rig& rig, const std::filesystem::path& file) {
  return std::make_unique<ModbusRecorder>(rig, file);
}

}  // namespace rigsound::tools
