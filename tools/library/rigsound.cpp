// The C interface of a handle that is open: names and codes over PlayingRig.
#include "rigsound.h"

#include "handle.hpp"
#include "rigsound/machine/signal.hpp"

using rigsound::library::guarded;
using rigsound::library::require;

namespace {

const rigsound::EngineOptions& options(const rigsound_handle* rig) { return rig->rig.options(); }

}  // namespace

extern "C" {

const char* rigsound_version() { return RIGSOUND_VERSION; }

void rigsound_close(rigsound_handle* rig) { delete rig; }

double rigsound_rate(const rigsound_handle* rig) { return options(rig).sample_rate; }
int rigsound_block(const rigsound_handle* rig) { return options(rig).block; }
int rigsound_channels(const rigsound_handle* rig) { return options(rig).channels; }
int rigsound_booms(const rigsound_handle* rig) { return static_cast<int>(options(rig).booms.size()); }
uint64_t rigsound_seed(const rigsound_handle* rig) { return options(rig).seed; }
int rigsound_latency(const rigsound_handle* rig) { return rigsound::lookahead_frames(options(rig)); }

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

int rigsound_watch(const rigsound_handle* rig, int boom, rigsound_drilling* drilling) {
  if (boom < 0 || boom >= rigsound_booms(rig)) return RIGSOUND_REFUSED;
  const rigsound::library::Drilling now = rig->rig.drilling(boom);
  *drilling = {name(now.situation).data(), now.hammering ? 1 : 0, now.impacts_hz};
  return RIGSOUND_OK;
}

const char* rigsound_last_error(const rigsound_handle* rig) {
  return rig == nullptr ? rigsound::library::open_error().c_str() : rig->error.c_str();
}

const char* rigsound_signal_name(int index) {
  return index < 0 || index >= rigsound::kSignalCount ? nullptr : rigsound::signal_table()[index].name.data();
}

const char* rigsound_control_name(int index) {
  const auto& table = rigsound::control_table();
  return index < 0 || index >= static_cast<int>(table.size()) ? nullptr : table[index].name.data();
}

}  // extern "C"
