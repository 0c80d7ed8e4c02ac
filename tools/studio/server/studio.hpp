// The server behind `rigsound studio`.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "studio_options.hpp"

namespace rigsound::studio {

class Studio {
 public:
  /// Listens, but answers nothing yet. Errors: InputError when a folder or the page is not there, DeviceError
  /// when the port is taken. Thread: OFF.
  explicit Studio(const StudioOptions& options);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  /// What a person opens: "http://127.0.0.1:PORT/#TOKEN".
  std::string address() const;

  void serve();  ///< until the process ends

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Writes the page of the rig with engine and packed set inside. Errors: InputError, DeviceError. Thread:
/// OFF.
void export_page(const StudioOptions& options, const std::filesystem::path& file);

}  // namespace rigsound::studio
