#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "record/bus_recorders.hpp"
#include "record/opening.hpp"
#include "rigsound/log/modbus_capture_writer.hpp"
#include "rigsound/modbus/modbus_link.hpp"

namespace rigsound::tools {
namespace {

/// The file all links write to, once all of them are open.
struct SharedCapture {
  std::mutex mutex;
  std::optional<log::ModbusCaptureWriter> writer;
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

  void require_open() { opening_.require(); }

 private:
  void readings(const std::vector<modbus::Reading>&) override {}
  void exchange(const modbus::Exchange& exchange) override {
    const std::lock_guard<std::mutex> lock(capture_.mutex);
    if (!capture_.writer) return;
    capture_.writer->write(realtime_ns(), exchange);
    ++capture_.entries;
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
  SharedCapture& capture_;
  Opening opening_;
  std::unique_ptr<modbus::ModbusLink> link_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

class ModbusRecorder : public BusRecorder {
 public:
  ModbusRecorder(const config::Rig& rig, const std::filesystem::path& file) {
    const std::lock_guard<std::mutex> lock(capture_.mutex);
    for (const modbus::ModbusOptions& link : rig.modbus)
      links_.push_back(std::make_unique<Link>(link, capture_));
    for (const auto& link : links_) link->require_open();
    capture_.writer.emplace(file);
  }
  void flush() override {
    const std::lock_guard<std::mutex> lock(capture_.mutex);
    capture_.writer->flush();
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
