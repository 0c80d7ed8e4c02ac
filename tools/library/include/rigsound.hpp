// rigsound.hpp: the C interface for C++17, errors as exceptions. Threads as in rigsound.h.
#pragma once

#include <rigsound.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigsound {

class Sound {
 public:
  /// Throws std::runtime_error with the line of rigsound_last_error. Thread: OFF.
  explicit Sound(const std::string& rig_file) : rig_(::rigsound_open(rig_file.c_str())) {
    if (!rig_) throw std::runtime_error(::rigsound_last_error(nullptr));
  }

  double rate() const { return ::rigsound_rate(rig_.get()); }
  int block() const { return ::rigsound_block(rig_.get()); }
  int channels() const { return ::rigsound_channels(rig_.get()); }
  int booms() const { return ::rigsound_booms(rig_.get()); }
  std::uint64_t seed() const { return ::rigsound_seed(rig_.get()); }
  int latency() const { return ::rigsound_latency(rig_.get()); }  ///< frames

  /// Throws std::invalid_argument. Thread: CT.
  void set(const std::string& signal, double value, int boom = 0) {
    require(::rigsound_set(rig_.get(), signal.c_str(), boom, value));
  }
  void control(const std::string& control, double value, int boom = 0) {
    require(::rigsound_control(rig_.get(), control.c_str(), boom, value));
  }

  /// Room for one block. Thread: OFF.
  std::vector<float> make_block() const { return std::vector<float>(block() * channels()); }
  void process(float* interleaved) noexcept { ::rigsound_process(rig_.get(), interleaved); }  ///< Thread: RT

  rigsound_levels meters() const {
    rigsound_levels levels{};
    ::rigsound_meters(rig_.get(), &levels);
    return levels;
  }

 private:
  void require(int result) const {
    if (result != RIGSOUND_OK) throw std::invalid_argument(::rigsound_last_error(rig_.get()));
  }

  struct Close {
    void operator()(::rigsound_handle* rig) const { ::rigsound_close(rig); }
  };
  std::unique_ptr<::rigsound_handle, Close> rig_;
};

}  // namespace rigsound
