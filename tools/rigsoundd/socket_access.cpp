#include "socket_access.hpp"

#include <grp.h>

#include "rigsound/machine/input_error.hpp"

namespace rigsound::daemon {

SocketAccess access_of(const config::Rig& rig) {
  const config::ControlOptions& control = rig.control;
  SocketAccess access{std::nullopt, control.mode_bits};
  if (control.group.empty()) return access;
  const group* const found = ::getgrnam(control.group.c_str());
  if (found == nullptr)
    throw InputError(
        rig.file.string(), control.group_line, "control.group",
        "there is no group \"" + control.group + "\", expected one of this machine (getent group)");
  access.group = found->gr_gid;
  return access;
}

}  // namespace rigsound::daemon
