// What a handle of the C interface is, and how what is thrown becomes its line.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "playing_rig.hpp"
#include "rigsound.h"

struct rigsound_handle {
  explicit rigsound_handle(rigsound::Engine engine) : rig(std::move(engine)) {}
  rigsound::library::PlayingRig rig;
  std::string error;
};

namespace rigsound::library {

/// Of the last handle that could not be opened in this thread.
std::string& open_error() noexcept;

/// Runs `step`; its exception becomes the line.
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

inline void require(bool given, const std::string& name) {
  if (!given) throw std::invalid_argument(name + ": is NULL");
}

}  // namespace rigsound::library
