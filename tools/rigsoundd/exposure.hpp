// What a listener has been given, and what more the limit of the rig allows.
#pragma once

#include "levels.hpp"
#include "snapshot.hpp"

namespace rigsound::daemon {

/// Exposure to noise as 2003/10/EC counts it, from the windows the audio thread closes; without a calibration
/// there is none.
///
/// With a limit the output is turned down before the A-weighted equivalent level over a minute passes it:
/// what may be heard is what the minute has left to a target 1.5 dB below, spread over the next seconds. The
/// gain follows a leap within 0.3 s: one of 17 dB over the limit is still held. No longer average passes what
/// a minute's does not, the daily exposure included. Thread: CT.
class Exposure {
 public:
  /// `db_spl_at_0dbfs`: see kCalibrations, 0: none; `max_laeq_db`: 0: no limit.
  void set(double db_spl_at_0dbfs, double max_laeq_db);

  /// A window that was not taken before, of blocks of `block_s`.
  void take(const LevelWindow& window, double block_s);

  /// Daily exposure, peak and time begin again; what the limit has seen stays.
  void reset();

  double gain() const { return gain_; }  ///< of the output from now on, for the limit's sake; 1: untouched
  std::optional<ExposureSnapshot> snapshot() const;  ///< none without a calibration

 private:
  void limit(double power, double seconds);
  double db(double power) const;

  double calibration_db_ = 0, limit_ = 0;       ///< limit_: a power, full scale 1; 0: none
  double energy_ = 0, peak_ = 0, seconds_ = 0;  ///< since the reset
  double fast_ = 0, slow_ = 0;                  ///< powers
  double minute_ = 0;                           ///< average power over it
  double source_ = 0;                           ///< the power there would be at gain 1
  double gain_ = 1, earlier_[2] = {1, 1};       ///< of now and of the last windows
};

}  // namespace rigsound::daemon
