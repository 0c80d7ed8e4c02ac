#include <chrono>
#include <thread>

#include "record/bus_news.hpp"
#include "record/file_recorder.hpp"
#include "rigsound/log/modbus_capture_writer.hpp"
#include "rigsound/modbus/modbus_link.hpp"

namespace rigsound::tools {
namespace {

using CaptureFile = SharedFile<log::ModbusCaptureWriter>;

std::int64_t realtime_ns() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

class Link : private modbus::ModbusListener {
 public:
  Link(const modbus::ModbusOptions& options, CaptureFile& file)
      : news_(options.address),
        file_(file),
        link_(modbus::make_modbus_link(options, *this)),
        thread_([this] { link_->run(stop_); }) {}
  ~Link() override {
    stop_ = true;
    thread_.join();
  }

  void require_open() { news_.require_up(); }

 private:
  void readings(const std::vector<Reading>&) override {}
  void exchange(const modbus::Exchange& exchange) override {
    file_.add([&](log::ModbusCaptureWriter& writer) {
      writer.write(realtime_ns(), exchange);
      return 1;
    });
  }
  void up() override { news_.up(); }
  void down(const std::string& why) override { news_.down(why); }
  void notice(const std::string& text) override { news_.notice(text); }

  BusNews news_;
  CaptureFile& file_;
  std::unique_ptr<modbus::ModbusLink> link_;
  std::atomic<bool> stop_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace

std::unique_ptr<BusRecorder> record_modbus(const config::Rig& rig, const std::filesystem::path& file) {
  return std::make_unique<FileRecorder<Link, log::ModbusCaptureWriter>>(rig.modbus, file);
}

}  // namespace rigsound::tools
