/* rigsound.h: the sound of a percussive drilling rig, in a program of your own.
 *
 * One handle is one rig. The state of the machine goes in by name, in the units of the rig's signal table
 * (README); one fixed block of interleaved float samples comes out with each call of rigsound_process, the
 * same bits as `rigsound render --states` gives for the same states.
 *
 * Threads. OFF: no other call with the handle at the same time. CT: any thread but the audio thread; calls
 * are serialised inside. RT: the audio thread; never allocates, locks, blocks or calls the system.
 *
 * Errors. Functions that can fail return NULL or RIGSOUND_REFUSED and leave one line in rigsound_last_error.
 * No call throws, no call ends the program.
 */
#ifndef RIGSOUND_H
#define RIGSOUND_H

#include <stddef.h>
#include <stdint.h>

#if defined(__wasm__)
#define RIGSOUND_API __attribute__((used))
#elif defined(__GNUC__)
#define RIGSOUND_API __attribute__((visibility("default")))
#else
#define RIGSOUND_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum { RIGSOUND_OK = 0, RIGSOUND_REFUSED = -1 };

/* NOLINTBEGIN(modernize-use-using): it is C. */
/** A rig that sounds. */
typedef struct rigsound_handle rigsound_handle;

/** What the last block was like; amplitudes are linear, full scale 1. */
typedef struct rigsound_levels {
  float peak, rms;
  float limiter_gain;   /**< lowest of the block; 1: the limiter did nothing */
  uint64_t lost_clicks; /**< clicks dropped because every voice was busy, since rigsound_open */
} rigsound_levels;

/** What one drill did in the last block. */
typedef struct rigsound_drilling {
  const char* situation; /**< "normal", "underfeed", "overfeed", "closed_rattling" or "open_rattling" */
  int hammering;         /**< 0: the hammer rests */
  float impacts_hz;      /**< counted over the last second of sound */
} rigsound_drilling;
/* NOLINTEND(modernize-use-using) */

/** Version of the library, "1.2.3". Thread: any. */
RIGSOUND_API const char* rigsound_version(void);

/** Reads a rig file and its sound set, or a sound set that was packed with its rig (`rigsound pack --rig`), and builds
 *  the engine. NULL when that cannot be done; rigsound_last_error(NULL) then says why, with file, line and key.
 *  Thread: OFF. */
RIGSOUND_API rigsound_handle* rigsound_open(const char* file);

/** The same of a packed sound set in memory, which may be gone afterwards. Thread: OFF. */
RIGSOUND_API rigsound_handle* rigsound_open_memory(const void* bytes, size_t size);

/** Ends the handle; NULL is let pass. Thread: OFF. */
RIGSOUND_API void rigsound_close(rigsound_handle* rig);

/** Samples a second, frames a block, channels a frame, booms, seed: as the rig file says. Thread: any. */
RIGSOUND_API double rigsound_rate(const rigsound_handle* rig);
RIGSOUND_API int rigsound_block(const rigsound_handle* rig);
RIGSOUND_API int rigsound_channels(const rigsound_handle* rig);
RIGSOUND_API int rigsound_booms(const rigsound_handle* rig);
RIGSOUND_API uint64_t rigsound_seed(const rigsound_handle* rig);

/** Frames by which all that rigsound_process gives is late, because the limiter looks ahead (`[mix]
 * lookahead_ms`). Thread: any. */
RIGSOUND_API int rigsound_latency(const rigsound_handle* rig);

/** Sets a signal, such as "feed_pressure_bar", of a boom (0 is the first; signals of the whole rig take 0).
 * Acts from the next block on. Refused: an unknown name, a boom that is not there, a value outside the
 * signal's range. The value that means "absent" (README, signal table) takes a signal back. Thread: CT. */
RIGSOUND_API int rigsound_set(rigsound_handle* rig, const char* signal, int boom, double value);

/** Sets one of the six live controls: mean_frequency_hz, mean_amplitude_db, deviation_time,
 * deviation_amplitude, attack_factor, decay_factor. Refused as above. Thread: CT. */
RIGSOUND_API int rigsound_control(rigsound_handle* rig, const char* control, int boom, double value);

/** One block: rigsound_block x rigsound_channels samples, interleaved; no sample exceeds the rig's ceiling.
 *  Thread: RT. */
RIGSOUND_API void rigsound_process(rigsound_handle* rig, float* interleaved);

/** What the last processed block was like. Thread: any. */
RIGSOUND_API void rigsound_meters(const rigsound_handle* rig, rigsound_levels* levels);

/** What the drill of a boom did in the last processed block. Refused: a boom that is not there. Thread: any. */
RIGSOUND_API int rigsound_watch(const rigsound_handle* rig, int boom, rigsound_drilling* drilling);

/** Why the last call that failed did, one line; "" when none has. With NULL: of rigsound_open, in this
 * thread. Valid until the next failing call. Thread: CT. */
RIGSOUND_API const char* rigsound_last_error(const rigsound_handle* rig);

/** Name of signal or control number `index`, in a fixed order; NULL behind the last one. Thread: any. */
RIGSOUND_API const char* rigsound_signal_name(int index);
RIGSOUND_API const char* rigsound_control_name(int index);

#ifdef __cplusplus
}
#endif

#endif
