// The C interface: names and codes over PlayingRig; what is thrown stops here.
#include "rigsound.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "playing_rig.hpp"
#include "rigsound/machine/signal.hpp"

struct rigsound_handle {
  explicit rigsound_handle(const std::filesystem::path& file) : rig(file) {}
  explicit rigsound_handle(std::string_view packed_set) : rig(packed_set) {}
  rigsound::library::PlayingRig rig;
  std::string error;
};

namespace {

thread_local std::string open_error;

/// Runs `step`; its exception becomes the handle's line.
template <class Step>
int guarded(std::string& error, Step step) noexcept {
  try {
    step();
    return RIGSOUND_OK;
  } catch (const std::bad_alloc&) {
    error.clear();
    error = "no memory";
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  return RIGSOUND_REFUSED;
}

void require(bool given, const std::string& name) {
  if (!given) throw std::invalid_argument(name + ": is NULL");
}

const rigsound::EngineOptions& options(const rigsound_handle* rig) { return rig->rig.options(); }

}  // namespace

extern "C" {

const char* rigsound_version() { return RIGSOUND_VERSION; }

rigsound_handle* rigsound_open(const char* file) {
  rigsound_handle* opened = nullptr;
  guarded(open_error, [&] {
    require(file != nullptr, "file");
    opened = new rigsound_handle(std::filesystem::path(file));
  });
  return opened;
}

rigsound_handle* rigsound_open_memory(const void* bytes, size_t size) {
  rigsound_handle* opened = nullptr;
  guarded(open_error, [&] {
    require(bytes != nullptr, "bytes");
    opened = new rigsound_handle(std::string_view(static_cast<const char*>(bytes), size));
  });
  return opened;
}

void rigsound_close(rigsound_handle* rig) { delete rig; }

double rigsound_rate(const rigsound_handle* rig) { return options(rig).sample_rate; }
int rigsound_block(const rigsound_handle* rig) { return options(rig).block; }
int rigsound_channels(const rigsound_handle* rig) { return options(rig).channels; }
int rigsound_booms(const rigsound_handle* rig) { return static_cast<int>(options(rig).booms.size()); }
uint64_t rigsound_seed(const rigsound_handle* rig) { return options(rig).seed; }

int rigsound_set(rigsound_handle* rig, const char* signal, int boom, double value) {
  return guarded(rig->error, [&] {
    require(signal != nullptr, "signal");
    rig->rig.set_signal(signal, boom, value);
  });
}

int rigsound_control(rigsound_handle* rig, const char* control, int boom, double value) {
  return guarded(rig->error, [&] {
    require(control != nullptr, "control");
    rig->rig.set_control(control, boom, value);
  });
}

void rigsound_process(rigsound_handle* rig, float* interleaved) { rig->rig.process(interleaved); }

void rigsound_meters(const rigsound_handle* rig, rigsound_levels* levels) {
  const rigsound::EngineMeters meters = rig->rig.meters();
  *levels = {meters.peak, meters.rms, meters.limiter_gain, meters.lost_clicks};
}

const char* rigsound_last_error(const rigsound_handle* rig) {
  return rig == nullptr ? open_error.c_str() : rig->error.c_str();
}

const char* rigsound_signal_name(int index) {
  return index < 0 || index >= rigsound::kSignalCount ? nullptr : rigsound::signal_table()[index].name.data();
}

const char* rigsound_control_name(int index) {
  const auto& table = rigsound::control_table();
  return index < 0 || index >= static_cast<int>(table.size()) ? nullptr : table[index].name.data();
}

}  // extern "C"
