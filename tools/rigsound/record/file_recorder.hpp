// Several buses, one file.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "record/bus_recorders.hpp"

namespace rigsound::tools {

/// The file, once all buses are open; each bus writes to it from its own thread.
template <typename Writer>
class SharedFile {
 public:
  /// `write` gets the writer, and says how many entries it wrote. Before there is a file, and after, nothing
  /// is kept.
  template <typename Write>
  void add(Write&& write) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (writer_) entries_ += write(*writer_);
  }
  /// Opens the file when `ready` returns; what comes meanwhile waits. Errors: those of `ready` and of the
  /// writer.
  template <typename Ready>
  void open(const std::filesystem::path& file, Ready&& ready) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ready();
    writer_.emplace(file);
  }
  void flush() {
    const std::lock_guard<std::mutex> lock(mutex_);
    writer_->flush();
  }
  std::uint64_t entries() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return entries_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<Writer> writer_;
  std::uint64_t entries_ = 0;
};

/// `Bus` is built from one of the rig's buses and the shared file, and knows require_open().
template <typename Bus, typename Writer>
class FileRecorder : public BusRecorder {
 public:
  template <typename Options>
  FileRecorder(const std::vector<Options>& buses, const std::filesystem::path& file) {
    file_.open(file, [&] {
      for (const Options& bus : buses) buses_.push_back(std::make_unique<Bus>(bus, file_));
      for (const auto& bus : buses_) bus->require_open();
    });
  }
  void flush() override { file_.flush(); }
  std::uint64_t entries() const override { return file_.entries(); }

 private:
  SharedFile<Writer> file_;
  std::vector<std::unique_ptr<Bus>> buses_;  // after the file they write to
};

}  // namespace rigsound::tools
