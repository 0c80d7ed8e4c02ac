#include <fmt/format.h>

#include <cstdio>
#include <thread>

#include "record/bus_news.hpp"
#include "record/file_recorder.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/log/candump_writer.hpp"

namespace rigsound::tools {
namespace {

using LogFile = SharedFile<log::CandumpWriter>;

class Interface : private can::CanListener {
 public:
  Interface(const can::CanOptions& options, LogFile& file)
      : news_(options.interface),
        file_(file),
        bus_({options.interface, options.fd, true, {}}, *this),
        thread_([this] { bus_.run(stop_); }) {}
  ~Interface() override {
    stop_ = true;
    thread_.join();
    const can::CanCounters c = bus_.counters();
    if (c.frames > 0)
      fmt::print(stderr, "{}: {} frames, {} dropped by the kernel\n", news_.bus(), c.frames, c.dropped);
  }

  void require_open() { news_.require_up(); }

 private:
  void frames(const can::Arrival* first, std::size_t count) override {
    file_.add([&](log::CandumpWriter& writer) {
      for (std::size_t i = 0; i < count; ++i)
        writer.write({static_cast<std::int64_t>(first[i].realtime_s * 1e9), news_.bus(), first[i].frame});
      return count;
    });
  }
  void up() override { news_.up(); }
  void down(const std::string& why) override { news_.down(why); }
  void notice(const std::string& text) override { news_.notice(text); }

  BusNews news_;
  LogFile& file_;
  can::CanBus bus_;
  std::atomic<bool> stop_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace

std::unique_ptr<BusRecorder> record_can(const config::Rig& rig, const std::filesystem::path& file) {
  return std::make_unique<FileRecorder<Interface, log::CandumpWriter>>(rig.can, file);
}

}  // namespace rigsound::tools
